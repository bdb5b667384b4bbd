"""What the newest tick looks like in the scene: for the cursor, and for what is drawn beside it."""

from __future__ import annotations

from dataclasses import dataclass

from mathutils import Quaternion, Vector
from proxygraph import State

from .cursor import Shape
from .placement import Placement
from .workspace import from_workspace, to_workspace

STEP = 0.001
"""Metres of the workspace in which the force's direction is looked up: small beside any curvature."""


@dataclass(frozen=True)
class Shown:
    """Places, directions and lengths of the scene, in Blender units."""

    place: Vector
    """Of the proxy, lifted onto the preview."""
    turn: Quaternion
    """Of what stands upright there."""
    size: float
    """Of the cursor."""
    shape: Shape
    hand: Vector
    """From the proxy to the hand."""
    force: Vector
    """In the scene's directions, newtons."""
    units_per_metre: float
    """Of terrain, along the ground."""


@dataclass(frozen=True)
class Look:
    """What a person sees of a touch."""

    shown: Shown | None
    window: tuple[float, ...]
    mode: str
    held: str | None


def to_hand(placement: Placement, state: State) -> Vector:
    """From the proxy to the hand, in the scene."""
    return placement.between(state.proxy, state.goal)


def force_in_scene(placement: Placement, state: State, width: float) -> Vector:
    """The force as a vector of the scene, as long as it has newtons.

    Args:
        width: of the device's workspace, metres.
    """
    newtons = Vector(state.force)
    step = newtons.normalized() * STEP
    x, y, z = to_workspace(state.proxy, state.window, width)
    there = from_workspace((x + step.x, y + step.y, z + step.z), state.window, width)
    return placement.between(state.proxy, there).normalized() * newtons.length
