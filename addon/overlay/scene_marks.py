"""What is drawn into the scene: the force as an arrow, and a ghost where the hand is.

Both are seen through the ground too, dimmed: the hand is below it whenever the ground is felt.
"""

from __future__ import annotations

from functools import cache
from typing import Literal

import gpu
from gpu.types import GPUBatch
from mathutils import Matrix, Vector

from ..touch.shown import Shown
from .colours import BELOW_GROUND, FORCE, LINE, SHADOW, Rgba, faded
from .pen import (
    at,
    circle,
    closed_batch,
    cone_batch,
    draw_filled,
    draw_lines,
    filled_batch,
    lines_batch,
    placed,
)
from .view import View

ARROW = 4.0
"""Length of the arrow of the largest force, in sizes of the cursor."""

CLEAR = 1.6
"""Sizes of the cursor by which an arrow that points up is longer: the cone hides so much of it."""

LEAST_FORCE = 0.01
"""Newtons: less has no arrow."""

HEAD = 0.5
"""Length of an arrow's head, in sizes of the cursor; of a shorter arrow, all of it."""

GHOST = 0.3
"""Radius of the ring that stands for the hand, in sizes of the cursor."""

LEAST_APART = 0.07
"""Sizes of the cursor between hand and proxy; nearer, the cursor is the hand."""

PASSES: tuple[tuple[Literal["GREATER", "LESS_EQUAL"], float], ...] = (
    ("GREATER", BELOW_GROUND),
    ("LESS_EQUAL", 1.0),
)
"""What is behind the ground, then what is before it; and the opacity of each."""

WIDTH = 2.0
"""Of lines, pixels at a scale of 1."""


def draw_scene_marks(shown: Shown, view: View, strongest: float, *, force: bool, ghost: bool) -> None:
    """Draw them.

    Args:
        strongest: the largest force that the hand may feel, newtons.
        force, ghost: whether each is wanted.
    """
    force = force and shown.force.length > LEAST_FORCE and strongest > 0.0
    ghost = ghost and shown.hand.length > LEAST_APART * shown.size
    for depth, opacity in PASSES:
        gpu.state.depth_test_set(depth)
        if ghost:
            _draw_ghost(shown, view, opacity)
        if force:
            _draw_arrow(shown, view, ARROW * shown.size * shown.force.length / strongest, opacity)


def _draw_ghost(shown: Shown, view: View, opacity: float) -> None:
    """A ring that faces the viewer, and a line to it from the proxy."""
    hand = shown.place + shown.hand
    radius = GHOST * shown.size
    ring = Matrix.Translation(hand[:]) @ view.rotation.to_4x4() @ at(0.0, 0.0, radius)
    way = max(shown.hand.length - radius, 0.0)
    _draw_line(_along(shown.place, shown.hand, way), LINE, view, opacity)
    with placed(ring):
        draw_filled(_disc(), faded(LINE, 0.25 * opacity))
        draw_lines(_ring(), faded(SHADOW, opacity), (WIDTH + 2.0) * view.scale)
        draw_lines(_ring(), faded(LINE, opacity), WIDTH * view.scale)


def _draw_arrow(shown: Shown, view: View, length: float, opacity: float) -> None:
    way = shown.force.normalized()
    upright = max(way.dot(shown.turn @ Vector((0.0, 0.0, 1.0))), 0.0)
    head = min(HEAD * shown.size, length)
    shaft = length - head + CLEAR * shown.size * upright**4  # hidden as far as it is within the cone
    _draw_line(_along(shown.place, shown.force, shaft), FORCE, view, opacity)
    tip = shown.place + way * shaft
    with placed(_along(tip, shown.force, head)):
        draw_filled(_head(), faded(FORCE, opacity))


def _draw_line(matrix: Matrix, colour: Rgba, view: View, opacity: float) -> None:
    """A line from (0, 0, 0) to (0, 0, 1), placed."""
    with placed(matrix):
        draw_lines(_line(), faded(SHADOW, opacity), (WIDTH + 2.0) * view.scale)
        draw_lines(_line(), faded(colour, opacity), WIDTH * view.scale)


def _along(place: Vector, direction: Vector, length: float) -> Matrix:
    """A place whose own upward axis points elsewhere, and whose unit is a length."""
    turn = direction.to_track_quat("Z", "Y")
    return Matrix.LocRotScale(place[:], turn, (length, length, length))


@cache
def _line() -> GPUBatch:
    return lines_batch([((0.0, 0.0, 0.0), (0.0, 0.0, 1.0))])


@cache
def _ring() -> GPUBatch:
    return closed_batch(circle())


@cache
def _disc() -> GPUBatch:
    return filled_batch(circle())


@cache
def _head() -> GPUBatch:
    return cone_batch(0.4)
