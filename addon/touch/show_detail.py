"""Showing the ground finely around the hand, where someone looks and wants it."""

from __future__ import annotations

from contextlib import suppress

import bpy
from proxygraph import State

from ..terrain.kept import KeptError, recall
from ..terrain.levels_object import can_show_levels
from ..terrain.preview import VERTEX_BUDGET
from .detail import Detail
from .follow_view import someone_looks
from .live import Touch, live
from .placement import Placement
from .sight import pixels_per_unit


def show_detail(
    touch: Touch, scene: bpy.types.Scene, terrain: bpy.types.Object, placement: Placement, state: State
) -> None:
    """Let the levels follow the point that is felt; where they are not wanted, there are none."""
    wanted = scene.haptic_terrain.detail and someone_looks() and can_show_levels(terrain)
    if not wanted or is_shown_whole(touch):
        if touch.detail is not None:
            touch.detail.put_away()
        return
    if touch.detail is None:
        with suppress(KeptError):  # what was changed by hand is told when touch starts again
            touch.detail = Detail(touch.grid, recall(terrain))
    if touch.detail is not None:
        east, north, up = state.proxy
        seen = pixels_per_unit(bpy.context, scene, placement.to_scene(east, north, up))
        touch.detail.tell_frame()
        try:
            touch.detail.follow(terrain, placement, east, north, seen)
        except MemoryError:
            touch.detail.put_away()
            scene.haptic_terrain.detail = False
            live.message = "There is not enough memory to show the ground finely around the hand."


def is_shown_whole(touch: Touch) -> bool:
    """Whether the terrain's own mesh has every sample, and no more than any machine draws smoothly."""
    cells = touch.surface.cells
    return cells.vertices <= VERTEX_BUDGET and _has_all(cells.columns) and _has_all(cells.rows)


def _has_all(lines: tuple[int, ...]) -> bool:
    return len(lines) == lines[-1] + 1
