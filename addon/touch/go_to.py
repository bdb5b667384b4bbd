"""Going to a longitude and latitude: 3D cursor, Touch Target, the hand's window and the views."""

from __future__ import annotations

import math

import bpy
from mathutils import Vector
from proxygraph import Grid, Window

from ..terrain.frame import map_size, nearest_on_map
from ..terrain.kept import KeptTerrain, recall
from ..terrain.opening import open_shown
from ..terrain.view import look_at
from .follow import lay_window
from .live import Touch, live
from .placement import Placement
from .target import clearance, move_target


class PlaceError(ValueError):
    """A map does not show a place; the text says what it shows."""


def go_to(context: bpy.types.Context, terrain: bpy.types.Object, longitude: float, latitude: float) -> Vector:
    """Bring cursor, target, window and views to a place.

    Args:
        longitude: degrees east, of any turn.
        latitude: degrees north, of the kind that the grid has.

    Returns:
        The ground there, scene coordinates.

    Raises:
        PlaceError: the map does not show it.
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(terrain)
    return go_on_map(context, terrain, kept, *map_place(kept, longitude, latitude))


def go_on_map(
    context: bpy.types.Context, terrain: bpy.types.Object, kept: KeptTerrain, east: float, north: float
) -> Vector:
    """Bring cursor, target, window and views to a place of the map, terrain metres.

    Args:
        kept: what the terrain remembers.

    Returns:
        The ground there, scene coordinates.

    Raises:
        FormatError: the grid's file cannot be used any more.
    """
    touch = live.touch
    if touch is not None and touch.terrain.find() != terrain:
        touch = None
    grid = touch.grid if touch is not None else open_shown(live.opened, kept)
    up = _ground(grid, kept, east, north)
    placement = Placement.of(terrain, kept.frame)
    window = _window(touch, grid, placement, east, north, up)
    if touch is not None:
        lay_window(touch, window)
    place = placement.to_scene(east, north, up)
    if context.scene is not None:
        context.scene.cursor.location = place
        move_target(context.scene, placement.to_scene(east, north, up + clearance(window)))
    look_at(context, place)
    return place


def map_place(kept: KeptTerrain, longitude: float, latitude: float) -> tuple[float, float]:
    """Terrain metres east and north of a place; within half a cell of the edge, those of the edge.

    Raises:
        PlaceError: the map does not show it.
    """
    grid = kept.grid
    layout, georeference = grid.layout, grid.georeference
    named = f"{longitude:g}\N{DEGREE SIGN} E {latitude:g}\N{DEGREE SIGN} N"
    place = None
    if math.isfinite(longitude) and -90.0 <= latitude <= 90.0:
        place = georeference.column_row(longitude, latitude, layout.columns)
    if place is None:
        raise PlaceError(f"{named} is no place of this map ({georeference.projection.name}).")
    column, row = place
    east, north = column * layout.cell_width, -row * layout.cell_height
    on_edge = nearest_on_map(layout, (east, north, 0.0))[:2]
    beside = abs(on_edge[0] - east) / layout.cell_width, abs(on_edge[1] - north) / layout.cell_height
    if max(beside) > 0.5:
        raise PlaceError(f"{named} is not on this map, which shows {shown_extent(kept)}.")
    return on_edge


def shown_extent(kept: KeptTerrain) -> str:
    """What a map shows, in words: its corners and its middle."""
    layout, georeference = kept.grid.layout, kept.grid.georeference
    last_column, last_row = layout.columns - 1, layout.rows - 1
    if georeference.projection.in_degrees:
        west, east = georeference.x(0), georeference.x(last_column)
        return (
            f"{west:g} to {east:g}\N{DEGREE SIGN} E, {georeference.y(last_row):g} to "
            f"{georeference.y(0):g}\N{DEGREE SIGN} N"
        )
    middle = georeference.longitude_latitude(last_column / 2.0, last_row / 2.0)
    if middle is None:
        return "no longitudes and latitudes that are known"
    return f"the surroundings of {middle[0]:.3f}\N{DEGREE SIGN} E {middle[1]:.3f}\N{DEGREE SIGN} N"


def _ground(grid: Grid, kept: KeptTerrain, east: float, north: float) -> float:
    """The height of the ground; over a hole, one in the middle of all."""
    height = grid.elevation_at(kept.frame.on_map(east), north)
    return (kept.minimum + kept.maximum) / 2.0 if height is None else height


def _window(
    touch: Touch | None, grid: Grid, placement: Placement, east: float, north: float, up: float
) -> Window:
    """The hand's window: around the place, unless it holds the whole map."""
    if touch is None:
        across = max(map_size(grid.layout))
        return Window(east, north, up, width=across, exaggeration=placement.exaggeration)
    window = touch.session.window
    across, down = map_size(grid.layout)
    if window.width >= max(across, down):
        return window
    return Window(east, north, up, width=window.width, exaggeration=window.exaggeration, turn=window.turn)
