"""The mesh of nested levels in Blender: made once, then refreshed through its attributes."""

from __future__ import annotations

import bpy
import numpy as np

from .levels.standing import Filling, Room


def standing_mesh(name: str, room: Room) -> bpy.types.Mesh:
    """Make a mesh of that size, with nothing to see yet."""
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(room.vertices)
    mesh.edges.add(room.edges)
    mesh.loops.add(3 * room.triangles)
    mesh.polygons.add(room.triangles)
    mesh.polygons.foreach_set("loop_start", np.arange(0, 3 * room.triangles, 3, dtype=np.int32))
    return mesh


def fits(mesh: bpy.types.Mesh, room: Room) -> bool:
    """Whether a mesh is of that size, and has room for one refresh more."""
    has_room = room.vertices <= len(mesh.vertices) < room.most_vertices
    return has_room and len(mesh.edges) == room.edges and len(mesh.polygons) == room.triangles


def refresh(mesh: bpy.types.Mesh, filling: Filling, room: Room) -> bool:
    """Write new content into a standing mesh.

    Blender remembers which faces a vertex has, for shading, and does not notice that other corners were
    written; it forgets when a vertex is added, so each refresh adds one.

    Returns:
        Whether that was possible: not where the mesh does not fit.
    """
    if not fits(mesh, room):
        return False
    count = len(mesh.vertices) + 1
    mesh.vertices.add(1)
    mesh.attributes["position"].data.foreach_set("vector", filling.positions[:count].ravel())
    mesh.attributes[".edge_verts"].data.foreach_set("value", filling.edges.ravel())
    mesh.attributes[".corner_vert"].data.foreach_set("value", filling.triangles.ravel())
    mesh.attributes[".corner_edge"].data.foreach_set("value", filling.triangle_edges.ravel())
    for name, values in filling.numbers.items():
        attribute = mesh.attributes.get(name) or mesh.attributes.new(name, "FLOAT", "POINT")
        attribute.data.foreach_set("value", values[:count])
    mesh.update()
    return True
