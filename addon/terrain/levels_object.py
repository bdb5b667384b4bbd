"""Nested levels in the place of a terrain's own mesh, in the viewports only.

The terrain gets a modifier of geometry nodes that is off in renders, and takes the mesh of an object of ours
that is in no scene. So the terrain object is what is seen, chosen, hidden, moved and parented, as before, in
every scene that has it, while its own mesh stays as it is, and is what renders show, as always.
"""

from __future__ import annotations

import bpy
from bpy.types import NodeTree, Object

from .levels.standing import Room
from .levels_mesh import fits, standing_mesh

NAME = "Terrain Near the Hand"

MARK = "haptic_terrain_levels"
"""ID property of object, mesh and nodes, which a person may rename."""


def can_show_levels(terrain: Object) -> bool:
    """Whether the terrain can have a modifier: not where it lies in another file."""
    return terrain.library is None and terrain.type == "MESH"


def show_levels(terrain: Object, mesh: bpy.types.Mesh) -> None:
    """Show a mesh in the place of the terrain's own, in object coordinates of the terrain."""
    put_away_levels(keep=mesh)
    levels = bpy.data.objects.new(NAME, mesh)
    nodes = _nodes(levels)
    levels[MARK] = nodes[MARK] = mesh[MARK] = True
    modifier = terrain.modifiers.new(NAME, "NODES")
    modifier.node_group = nodes
    modifier.show_render = modifier.show_in_editmode = modifier.show_expanded = False
    # The person's own modifiers go on with what is shown.
    terrain.modifiers.move(len(terrain.modifiers) - 1, 0)


def shown_levels(terrain: Object) -> bpy.types.Mesh | None:
    """The mesh that a terrain shows; ``None`` where some of it is gone, by a person's hand or an undo."""
    for modifier in terrain.modifiers:
        nodes = _marked_nodes(modifier)
        if nodes is None:
            continue
        source = nodes.nodes.get(NAME)
        levels = None if source is None else source.inputs["Object"].default_value
        return levels.data if levels is not None and levels.type == "MESH" else None
    return None


def mesh_for_levels(room: Room) -> bpy.types.Mesh:
    """Find a mesh of that size that is not shown yet, or make it, which takes a tenth of a second."""
    for mesh in bpy.data.meshes:
        if mesh.library is None and mesh.get(MARK) and not mesh.users and fits(mesh, room):
            return mesh
    mesh = standing_mesh(NAME, room)
    mesh[MARK] = True
    return mesh


def wear_materials(levels: bpy.types.Mesh, terrain: Object) -> None:
    """Give the levels the materials that the terrain has now."""
    wanted = [slot.material for slot in terrain.material_slots]
    materials = levels.materials
    if list(materials) != wanted:
        materials.clear()
        for material in wanted:
            materials.append(material)


def put_away_levels(keep: bpy.types.Mesh | None = None) -> None:
    """Show every terrain's own mesh again, and leave nothing but ``keep``; harmless where nothing is."""
    for thing in bpy.data.objects:
        if thing.library is None:
            for modifier in [kept for kept in thing.modifiers if _is_ours(kept)]:
                thing.modifiers.remove(modifier)
    for things in (bpy.data.objects, bpy.data.meshes, bpy.data.node_groups):
        bpy.data.batch_remove(
            [thing for thing in things if thing.library is None and thing.get(MARK) and thing != keep]
        )


def _is_ours(modifier: bpy.types.Modifier) -> bool:
    """Whether a modifier has our nodes, or had them before someone deleted those."""
    if _marked_nodes(modifier) is not None:
        return True
    return modifier.type == "NODES" and modifier.node_group is None and modifier.name.startswith(NAME)


def _marked_nodes(modifier: bpy.types.Modifier) -> NodeTree | None:
    nodes = modifier.node_group if modifier.type == "NODES" else None
    return nodes if nodes is not None and nodes.get(MARK) else None


def _nodes(levels: Object) -> NodeTree:
    """Geometry nodes that give the geometry of an object, whatever they get."""
    nodes: NodeTree = bpy.data.node_groups.new(NAME, "GeometryNodeTree")  # type: ignore[assignment]
    for way in ("INPUT", "OUTPUT"):
        nodes.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")  # type: ignore[arg-type]
    source = nodes.nodes.new("GeometryNodeObjectInfo")
    source.name = NAME
    source.inputs["Object"].default_value = levels
    output = nodes.nodes.new("NodeGroupOutput")
    nodes.links.new(source.outputs["Geometry"], output.inputs["Geometry"])
    return nodes
