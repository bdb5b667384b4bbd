"""A profile as a curve that lies on the terrain."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

import bpy
import numpy as np

from ..formats.profiles.profile import Profile, ProfilePoint
from ..terrain.frame import map_size
from ..terrain.kept import recall
from ..terrain.preview import Numbers, PreviewSurface, preview_cells, preview_surface
from .marking import open_grid
from .placement import Placement

NAME = "Profile"

RADIUS = 0.001
"""Of the line, as a share of the terrain's longest side."""

COLOUR = (1.0, 0.55, 0.02, 1.0)


def add_profile_curve(scene: bpy.types.Scene, terrain: bpy.types.Object, cut: Profile) -> bpy.types.Object:
    """Make the curve, with a gap where there is no data.

    Raises:
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(terrain)
    layout, frame = kept.grid.layout, kept.frame
    surface = preview_surface(open_grid(terrain, kept), preview_cells(layout, kept.vertex_budget))
    line = bpy.data.curves.new(NAME, "CURVE")
    line.dimensions = "3D"
    line.bevel_depth = RADIUS * max(map_size(layout)) * frame.units_per_metre
    line.bevel_resolution = 2
    line.materials.append(_material())
    for piece in _pieces(cut, layout.columns if layout.wraps else None):
        east = np.array([point.column for point in piece]) * layout.cell_width
        north = np.array([point.row for point in piece]) * -layout.cell_height
        up = _lifted(
            np.array([point.elevation for point in piece], dtype=float), surface, frame.on_map(east), north
        )
        spline = line.splines.new("POLY")
        spline.points.add(len(piece) - 1)
        x, y, z = frame.to_object(east, north, up)
        spline.points.foreach_set("co", np.stack((x, y, z, np.ones_like(x)), axis=-1).ravel())
    curve = bpy.data.objects.new(NAME, line)
    curve.matrix_world = Placement.of(terrain, frame).matrix
    scene.collection.objects.link(curve)
    return curve


def _pieces(cut: Profile, turn: int | None) -> Iterator[list[ProfilePoint]]:
    """Split at voids, and where the line leaves a map that wraps to come back on its other side."""

    def piece(point: ProfilePoint) -> tuple[bool, float]:
        return point.elevation is None, 0.0 if turn is None else point.column // turn

    for (is_void, _turn), points in groupby(cut.points, key=piece):
        if not is_void:
            yield list(points)


def _lifted(up: Numbers, surface: PreviewSurface, east: Numbers, north: Numbers) -> Numbers:
    """Lift what the shown surface would bury."""
    return np.asarray(np.fmax(up, surface.heights_at(east, north)))


def _material() -> bpy.types.Material:
    material = bpy.data.materials.get(NAME) or bpy.data.materials.new(NAME)
    if material.node_tree is None:  # older than 5.0
        material.use_nodes = True
    material.diffuse_color = COLOUR  # type: ignore[assignment]
    for node in material.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = COLOUR
            node.inputs["Emission Color"].default_value = COLOUR
            node.inputs["Emission Strength"].default_value = 0.5
    return material
