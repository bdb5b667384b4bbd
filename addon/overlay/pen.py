"""Drawing with ``gpu``: lines, shapes and pictures that are made once, and then only placed."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from typing import Any

import gpu
from gpu.types import GPUBatch, GPUTexture
from gpu_extras.batch import batch_for_shader
from mathutils import Matrix

from .colours import Rgba
from .rect import Point, Rect, Segment

ROUND = 24
"""Corners of a circle: more are not seen at the sizes that are drawn."""

Place = tuple[float, float, float]

Coloured = tuple[list[Point], list[Rgba], list[tuple[int, int, int]]]
"""Corners in the region, pixels; the colour of each; and the corners of each triangle."""


@contextmanager
def clean_state() -> Iterator[None]:
    """Leave Blender's drawing as it was found."""
    blend: Any = gpu.state.blend_get()
    depth: Any = gpu.state.depth_test_get()
    writes, width = gpu.state.depth_mask_get(), gpu.state.line_width_get()
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_mask_set(False)
    try:
        yield
    finally:
        gpu.state.blend_set(blend)
        gpu.state.depth_test_set(depth)
        gpu.state.depth_mask_set(writes)
        gpu.state.line_width_set(width)


@contextmanager
def placed(matrix: Matrix) -> Iterator[None]:
    """Draw what follows somewhere else, and larger or smaller."""
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(matrix)
        yield


def at(x: float, y: float, size: float = 1.0) -> Matrix:
    """A place of the region for ``placed``: pixels, and how many of them a unit has."""
    return Matrix(((size, 0.0, 0.0, x), (0.0, size, 0.0, y), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0)))


def lines_batch(segments: Sequence[tuple[Place, Place]]) -> GPUBatch:
    """Lines for ``draw_lines``, to be kept."""
    shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
    return batch_for_shader(shader, "LINES", {"pos": [end for segment in segments for end in segment]})


def flat_lines_batch(segments: Sequence[Segment]) -> GPUBatch:
    """The same in the plane of the region."""
    return lines_batch([((x, y, 0.0), (end_x, end_y, 0.0)) for (x, y), (end_x, end_y) in segments])


def closed_batch(corners: Sequence[Point]) -> GPUBatch:
    """The outline of a polygon for ``draw_lines``, to be kept."""
    return flat_lines_batch(list(zip(corners, [*corners[1:], corners[0]], strict=True)))


def filled_batch(corners: Sequence[Point]) -> GPUBatch:
    """A convex polygon for ``draw_filled``, to be kept."""
    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    fan = [(0, number, number + 1) for number in range(1, len(corners) - 1)]
    return batch_for_shader(shader, "TRIS", {"pos": [(x, y, 0.0) for x, y in corners]}, indices=fan)


def cone_batch(radius: float) -> GPUBatch:
    """A cone from its base around (0, 0, 0) to (0, 0, 1), for ``draw_filled``, to be kept."""
    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    base = [(x, y, 0.0) for x, y in circle(radius)]
    tip, middle = len(base), len(base) + 1
    edges = [(number, (number + 1) % len(base)) for number in range(len(base))]
    sides = [(one, other, tip) for one, other in edges]
    floor = [(other, one, middle) for one, other in edges]
    corners = [*base, (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)]
    batch: GPUBatch = batch_for_shader(shader, "TRIS", {"pos": corners}, indices=sides + floor)
    return batch


def coloured_batch(shapes: Sequence[Coloured]) -> GPUBatch:
    """Shapes whose colours run from corner to corner, for ``draw_coloured``, to be kept."""
    places: list[Place] = []
    colours: list[Rgba] = []
    faces: list[tuple[int, int, int]] = []
    for corners, shades, triangles in shapes:
        first = len(places)
        places += [(x, y, 0.0) for x, y in corners]
        colours += shades
        faces += [(first + one, first + two, first + three) for one, two, three in triangles]
    shader = gpu.shader.from_builtin("SMOOTH_COLOR")
    return batch_for_shader(shader, "TRIS", {"pos": places, "color": colours}, indices=faces)


def draw_coloured(batch: GPUBatch) -> None:
    """Draw triangles in their own colours."""
    shader = gpu.shader.from_builtin("SMOOTH_COLOR")
    shader.bind()
    batch.draw(shader)


def draw_lines(batch: GPUBatch, colour: Rgba, width: float) -> None:
    """Draw smooth lines, so many pixels wide."""
    shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", width)
    shader.uniform_float("color", colour)
    batch.draw(shader)


def draw_filled(batch: GPUBatch, colour: Rgba) -> None:
    """Draw triangles."""
    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    shader.bind()
    shader.uniform_float("color", colour)
    batch.draw(shader)


def draw_plate(rect: Rect, colour: Rgba) -> None:
    """Draw a filled rectangle."""
    with placed(_stretched(rect)):
        draw_filled(_square(), colour)


def draw_picture(texture: GPUTexture, rect: Rect) -> None:
    """Draw a texture, whose first row is the lowest."""
    shader = gpu.shader.from_builtin("IMAGE")
    shader.bind()
    shader.uniform_sampler("image", texture)
    with placed(_stretched(rect)):
        _picture().draw(shader)


def circle(radius: float = 1.0, corners: int = ROUND) -> list[Point]:
    """The corners of a circle around (0, 0), counter-clockwise."""
    angles = [2.0 * math.pi * number / corners for number in range(corners)]
    return [(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles]


def _stretched(rect: Rect) -> Matrix:
    return Matrix(
        (
            (rect.width, 0.0, 0.0, rect.left),
            (0.0, rect.height, 0.0, rect.bottom),
            (0.0, 0.0, 1.0, 0.0),
            (0.0, 0.0, 0.0, 1.0),
        )
    )


CORNERS: tuple[Point, ...] = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


@cache
def _square() -> GPUBatch:
    return filled_batch(CORNERS)


@cache
def _picture() -> GPUBatch:
    shader = gpu.shader.from_builtin("IMAGE")
    corners = [(x, y, 0.0) for x, y in CORNERS]
    batch: GPUBatch = batch_for_shader(
        shader, "TRIS", {"pos": corners, "texCoord": CORNERS}, indices=[(0, 1, 2), (0, 2, 3)]
    )
    return batch
