"""The mesh of a preview."""

from __future__ import annotations

import bpy
import numpy as np
import numpy.typing as npt

from .frame import TerrainFrame
from .preview import PreviewSurface, preview_triangles

ELEVATION = "elevation"
"""Vertex attribute, metres: for materials and geometry nodes."""


def preview_mesh(name: str, surface: PreviewSurface, frame: TerrainFrame) -> bpy.types.Mesh:
    """Make the mesh; its vertices are the shown samples, voids left out."""
    triangles = preview_triangles(surface.heights)
    shown = np.isfinite(surface.heights).ravel()
    numbers = (np.cumsum(shown) - 1).astype(np.int32)
    mesh = triangle_mesh(name, _positions(surface, frame)[shown], numbers[triangles])
    elevation = mesh.attributes.new(ELEVATION, "FLOAT", "POINT")
    elevation.data.foreach_set("value", surface.heights.ravel()[shown].astype(np.float32))
    return mesh


def triangle_mesh(
    name: str, positions: npt.NDArray[np.float32], triangles: npt.NDArray[np.int32]
) -> bpy.types.Mesh:
    """Make a mesh through its attributes: many times faster than lists, and half the memory."""
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(positions))
    mesh.loops.add(triangles.size)
    mesh.polygons.add(len(triangles))
    # A mesh has these attributes only when there is something to put into them.
    if len(positions):
        mesh.attributes["position"].data.foreach_set("vector", np.ascontiguousarray(positions).ravel())
    if len(triangles):
        mesh.attributes[".corner_vert"].data.foreach_set("value", np.ascontiguousarray(triangles).ravel())
        mesh.polygons.foreach_set("loop_start", np.arange(0, triangles.size, 3, dtype=np.int32))
    mesh.update(calc_edges=True)
    return mesh


def _positions(surface: PreviewSurface, frame: TerrainFrame) -> npt.NDArray[np.float32]:
    """Object coordinates of every shown sample, voids included; a planet's last column stays in the east."""
    layout = surface.layout
    east = np.array(surface.cells.columns) * layout.cell_width - frame.east
    north = np.array(surface.cells.rows) * -layout.cell_height - frame.north
    positions = np.empty((*surface.heights.shape, 3))
    positions[..., 0] = east * frame.units_per_metre
    positions[..., 1] = north[:, None] * frame.units_per_metre
    positions[..., 2] = (surface.heights - frame.up) * (frame.units_per_metre * frame.exaggeration)
    return positions.reshape(-1, 3).astype(np.float32)
