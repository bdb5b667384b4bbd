"""Showing a terrain on its sphere, or flat again. Grid and touch stay as they are."""

from __future__ import annotations

from dataclasses import replace
from typing import cast

import bpy

from .bend import Bend
from .kept import keep_frame, recall
from .mesh import move_vertices
from .opened import OpenedGrids
from .opening import open_shown
from .preview import preview_cells, preview_surface


class CurvatureError(ValueError):
    """A terrain cannot be shown on its sphere; the text says what to do."""


def show_curvature(terrain: bpy.types.Object, opened: OpenedGrids, *, curved: bool) -> None:
    """Move the shown samples onto the sphere, or back; cursor, target and trails follow the same frame.

    Raises:
        CurvatureError: the mesh was edited, or the ellipsoid has no size.
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(terrain)
    bend = Bend.of(kept.grid.georeference, kept.grid.layout.rows) if curved else None
    if bend is not None and bend.radius <= 0.0:
        raise CurvatureError(f"The grid of {terrain.name} states no radius of its body: it stays flat.")
    frame = replace(kept.frame, bend=bend)
    surface = preview_surface(open_shown(opened, kept), preview_cells(kept.grid.layout, kept.vertex_budget))
    try:
        move_vertices(cast("bpy.types.Mesh", terrain.data), surface, frame)
    except ValueError as error:
        raise CurvatureError(f"{error}: it was edited; import the grid again.") from error
    keep_frame(terrain, frame)
