"""Every tick of a take as a vertex with all its numbers, for Geometry Nodes."""

from __future__ import annotations

import bpy
import numpy as np

from ..terrain.frame import TerrainFrame
from .files.derived import derived_columns
from .ground import Ground
from .take_data import Numbers, TakeData

NAME = "Touch Points"

FORCE, DEPTH = "force", "depth"
"""Attributes beside the columns: newtons, and metres of the hand's motion."""


def point_trail(data: TakeData, frame: TerrainFrame, ground: Ground) -> bpy.types.Object:
    """Make a mesh of vertices alone, in the terrain's own coordinates, where the proxy was at each tick.

    Each column is a float attribute of its name, and so are longitude, latitude and ground elevation, with 32
    bits: places to about a ten-millionth of the map. Seconds begin at the take's first tick. As doubles the
    ticks are in the take's action, and in files.
    """
    mesh = bpy.data.meshes.new(NAME)
    mesh.vertices.add(len(data))
    east, north, up = data.places.T
    on_map = frame.on_map(east)
    places = np.stack(frame.shown(on_map, north, np.fmax(up, ground.highest(on_map, north))), axis=1)
    mesh.attributes["position"].data.foreach_set("vector", places.astype(np.float32).ravel())
    columns = {**data.columns, **derived_columns(data, ground.real), FORCE: data.force, DEPTH: data.depth}
    columns["time"] = columns["time"] - columns["time"][0]
    for name, values in columns.items():
        _add_numbers(mesh, name, values)
    mesh.update()
    return bpy.data.objects.new(NAME, mesh)


def _add_numbers(mesh: bpy.types.Mesh, name: str, values: Numbers) -> None:
    attribute = mesh.attributes.new(name, "FLOAT", "POINT")
    attribute.data.foreach_set("value", values.astype(np.float32))
