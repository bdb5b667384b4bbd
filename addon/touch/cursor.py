"""The cursor: one object with a mesh for each thing that the hand can do (MarsView, section 4.2).

| mode | mesh |
| --- | --- |
| normal, free | a sphere |
| normal, in contact | a cone that stands on its tip |
| pan | a flattened sphere |
| zoom | an elongated sphere |

It is never keyed: a frame change would take it away from the hand.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import bmesh
import bpy
from mathutils import Matrix, Quaternion, Vector

from ..terrain.palettes import BLUISH_GREEN, REDDISH_PURPLE, SKY_BLUE, VERMILLION, Colour
from .own_object import mark_own, own_object

if TYPE_CHECKING:
    from proxygraph import Mode

NAME = "Haptic Cursor"

MARK = "haptic_terrain_cursor"
"""ID property of the cursor."""

SIZE = 0.02
"""Of the terrain's longest side: ten pixels where all of it is in view, and small enough to point."""

ROUNDING = 1e-5
"""Of the cursor's size: less is neither seen nor, in Blender's 32 bits, always kept."""


@dataclass(frozen=True)
class Shape:
    """One look of the cursor; a sphere is one unit high, and the origin is the point that touches."""

    name: str
    colour: Colour
    build: Callable[[bmesh.types.BMesh], None]
    is_smooth: bool = True


def _build_sphere(mesh: bmesh.types.BMesh) -> None:
    bmesh.ops.create_uvsphere(mesh, u_segments=24, v_segments=12, radius=0.5)


def _build_cone(mesh: bmesh.types.BMesh) -> None:
    """Stand a cone on its tip."""
    tip_down = Matrix.Translation((0.0, 0.0, 0.75)) @ Matrix.Rotation(3.141592653589793, 4, "X")
    bmesh.ops.create_cone(
        mesh, cap_ends=True, segments=24, radius1=0.45, radius2=0.0, depth=1.5, matrix=tip_down
    )


def _build_flat(mesh: bmesh.types.BMesh) -> None:
    """Lay a flattened sphere on the point that is held."""
    _build_ellipsoid(mesh, across=1.3, high=0.45, middle=0.225)


def _build_tall(mesh: bmesh.types.BMesh) -> None:
    """Put an elongated sphere around the point that is held."""
    _build_ellipsoid(mesh, across=0.55, high=1.8, middle=0.0)


def _build_ellipsoid(mesh: bmesh.types.BMesh, *, across: float, high: float, middle: float) -> None:
    squeezed = Matrix.LocRotScale((0.0, 0.0, middle), None, (across, across, high))
    bmesh.ops.create_uvsphere(mesh, u_segments=24, v_segments=12, radius=0.5, matrix=squeezed)


FREE = Shape("Haptic Cursor Free", SKY_BLUE, _build_sphere)
CONTACT = Shape("Haptic Cursor Contact", BLUISH_GREEN, _build_cone, is_smooth=False)
PAN = Shape("Haptic Cursor Pan", VERMILLION, _build_flat)
ZOOM = Shape("Haptic Cursor Zoom", REDDISH_PURPLE, _build_tall)
LOOKS = (FREE, CONTACT, PAN, ZOOM)
"""Of the cursor."""

TAKE_COLOURS: tuple[Colour, ...] = (
    (1.0, 0.75, 0.1),
    (0.0, 0.168, 0.445),
    (0.9, 0.9, 0.9),
    (0.791, 0.347, 0.0),
    (0.03, 0.03, 0.03),
)
"""Yellow, then blue, white, orange and black: none is the cursor's, and everyone tells them apart."""


def take_shape(number: int) -> Shape:
    """The look of a take: a cone like the cursor in contact, in one of ``TAKE_COLOURS``."""
    name = f"Haptic Take {number + 1}" if number else "Haptic Take"
    return Shape(name, TAKE_COLOURS[number], _build_cone, is_smooth=False)


def shape_of(mode: Mode, *, in_contact: bool) -> Shape:
    """Choose the look of what the hand does."""
    if mode == "pan":
        return PAN
    if mode == "zoom":
        return ZOOM
    return CONTACT if in_contact else FREE


def make_cursor(scene: bpy.types.Scene) -> bpy.types.Object:
    """Find a scene's cursor, or make it, with all of its looks; for operators, never for the timer."""
    for shape in LOOKS:
        shape_mesh(shape)
    cursor = own_object(scene, MARK)
    if cursor is None:
        cursor = bpy.data.objects.new(NAME, shape_mesh(FREE))
        mark_own(cursor, MARK)
        cursor.hide_select = True
        scene.collection.objects.link(cursor)
    return cursor


def find_cursor(scene: bpy.types.Scene) -> bpy.types.Object | None:
    """Find a scene's cursor; ``None`` where it, or one of its looks, was deleted or undone.

    The timer makes nothing anew. What is made between two steps of undo, and linked to what both of them
    have, is a dead pointer after the next undo, and Blender crashes.
    """
    if any(shape.name not in bpy.data.meshes for shape in LOOKS):
        return None
    return own_object(scene, MARK)


def show_cursor(cursor: bpy.types.Object, place: Vector, turn: Quaternion, size: float, shape: Shape) -> None:
    """Move the cursor and give it its shape.

    Args:
        place: of the touching point, scene coordinates.
        turn: the terrain's rotation.
        size: Blender units.
    """
    mesh = shape_mesh(shape)
    if cursor.data is not mesh:
        cursor.data = mesh
    there = Matrix.LocRotScale(place[:], turn, (size, size, size))
    if not _is_there(cursor.matrix_world, there, size):  # writing it makes Blender draw every view again
        cursor.matrix_world = there


def _is_there(matrix: Matrix, there: Matrix, size: float) -> bool:
    """Whether two places differ by rounding only."""
    apart = max(abs(matrix[row][column] - there[row][column]) for row in range(4) for column in range(4))
    return bool(apart <= ROUNDING * size)


def shape_mesh(shape: Shape) -> bpy.types.Mesh:
    """Find a shape's mesh, or build it."""
    mesh = bpy.data.meshes.get(shape.name)
    if mesh is not None:
        return mesh
    mesh = bpy.data.meshes.new(shape.name)
    building = bmesh.new()
    shape.build(building)
    building.to_mesh(mesh)
    building.free()
    mesh.shade_smooth() if shape.is_smooth else mesh.shade_flat()
    mesh.materials.append(_material(shape))
    return mesh


def _material(shape: Shape) -> bpy.types.Material:
    material = bpy.data.materials.new(shape.name)
    if material.node_tree is None:  # older than 5.0
        material.use_nodes = True
    colour = (*shape.colour, 1.0)
    material.diffuse_color = colour  # type: ignore[assignment]
    surface = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    surface.inputs["Base Color"].default_value = colour
    surface.inputs["Emission Color"].default_value = colour
    surface.inputs["Emission Strength"].default_value = 0.3
    return material
