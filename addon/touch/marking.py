"""Marking the place that is touched, or that of the 3D cursor, and measuring between two marks."""

from __future__ import annotations

import math

import bpy
from proxygraph import Grid

from ..formats.profiles.profile import Profile, profile
from ..terrain.frame import is_on_map, place_in_grid
from ..terrain.kept import KeptTerrain, recall
from ..terrain.marks import Between, MarkName, Place, marks_of, nearest_turn, set_between, set_mark
from ..terrain.opening import open_shown
from .go_to import PlaceError
from .live import live
from .placement import Placement


def mark(context: bpy.types.Context, terrain: bpy.types.Object, name: MarkName) -> None:
    """Mark where the hand touches, or where the 3D cursor is while nothing is touched.

    Raises:
        PlaceError: that is beside the map.
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(terrain)
    set_mark(terrain, name, _place(context, terrain, kept))
    cut = marked_profile(terrain)
    if cut is not None:
        set_between(terrain, _between(cut))


def marked_profile(terrain: bpy.types.Object) -> Profile | None:
    """The cut from A to B; ``None`` where they are not both marked.

    Raises:
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(terrain)
    layout = kept.grid.layout
    ends = nearest_turn(marks_of(terrain), layout.columns, wraps=layout.wraps)
    if ends is None:
        return None
    return profile(kept.grid.georeference, open_grid(terrain, kept), *ends)


def open_grid(terrain: bpy.types.Object, kept: KeptTerrain) -> Grid:
    """The grid that is touched, where it is this terrain's, else the terrain's own.

    Raises:
        FormatError: its file cannot be used any more.
    """
    touch = live.touch
    if touch is not None and touch.terrain.find() == terrain:
        return touch.grid
    return open_shown(live.opened, kept)


def _place(context: bpy.types.Context, terrain: bpy.types.Object, kept: KeptTerrain) -> Place:
    touch = live.touch
    if touch is not None and touch.terrain.find() == terrain:
        east, north, _up = touch.session.state().proxy
        what = "The cursor"
    else:
        placement = Placement.of(terrain, kept.frame)
        east, north, _up = placement.to_terrain(context.scene.cursor.location)
        what = "The 3D cursor"
    if not (math.isfinite(east) and math.isfinite(north)) or not is_on_map(kept.grid.layout, east, north):
        raise PlaceError(f"{what} is beside the map: move it onto the terrain.")
    return place_in_grid(kept.grid.layout, kept.frame.on_map(east), north)


def _between(cut: Profile) -> Between:
    first, last = cut.points[0].elevation, cut.points[-1].elevation
    return Between(
        length=cut.length,
        difference=None if first is None or last is None else last - first,
        rise=cut.rise,
        fall=cut.fall,
        mean_slope=cut.mean_slope,
        steepest_slope=cut.steepest_slope,
        void_length=cut.void_length,
    )
