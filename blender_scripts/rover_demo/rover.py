"""A rover, built from primitives: six wheels, rockers, a body, a mast with eyes, an antenna.

Lengths are shares of its own length; its origin is on the ground between the wheels, and it looks along Y.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import bmesh
import bpy
from mathutils import Matrix

Triple = tuple[float, float, float]

WHEELS = tuple((side, ahead) for ahead in (-0.4, 0.0, 0.4) for side in (-0.38, 0.38))
"""Middles of the wheels, right and forward."""

WHEEL_RADIUS = 0.14

FOOTPRINT = (0.9, 1.08)
"""Width and length of what stands on the ground."""


@dataclass(frozen=True)
class Paint:
    """Of a part."""

    name: str
    colour: Triple
    metallic: float = 0.0
    roughness: float = 0.6


WHITE = Paint("Rover white", (0.8, 0.78, 0.72))
GOLD = Paint("Rover gold", (0.83, 0.5, 0.12), metallic=0.9, roughness=0.35)
DARK = Paint("Rover dark", (0.03, 0.03, 0.035), roughness=0.5)
CELLS = Paint("Rover cells", (0.015, 0.03, 0.11), metallic=0.3, roughness=0.25)
PAINTS = (WHITE, GOLD, DARK, CELLS)


def add_rover(scene: bpy.types.Scene, length: float) -> bpy.types.Object:
    """Build a rover.

    Args:
        length: Blender units.
    """
    shape = bmesh.new()
    _wheels(shape)
    _body(shape)
    _mast(shape)
    _antenna(shape)
    mesh = bpy.data.meshes.new("Rover")
    shape.to_mesh(mesh)
    shape.free()
    for paint in PAINTS:
        mesh.materials.append(_material(paint))
    mesh.transform(Matrix.Scale(length, 4))
    rover = bpy.data.objects.new("Rover", mesh)
    scene.collection.objects.link(rover)
    return rover


def _wheels(shape: bmesh.types.BMesh) -> None:
    for side, ahead in WHEELS:
        middle = (side, ahead, WHEEL_RADIUS)
        _rod(shape, DARK, middle, WHEEL_RADIUS, 0.13, "X")
        _rod(shape, WHITE, middle, 0.6 * WHEEL_RADIUS, 0.14, "X")
    for side in (-0.29, 0.29):
        _box(shape, DARK, (side, -0.2, 0.24), (0.03, 0.5, 0.05), tilt=0.28)
        _box(shape, DARK, (side, 0.2, 0.24), (0.03, 0.5, 0.05), tilt=-0.28)


def _body(shape: bmesh.types.BMesh) -> None:
    _box(shape, GOLD, (0.0, -0.02, 0.36), (0.48, 0.78, 0.18))
    _box(shape, WHITE, (0.0, -0.02, 0.455), (0.52, 0.82, 0.02))
    for side in (-0.31, 0.31):
        _box(shape, CELLS, (side, -0.08, 0.475), (0.3, 0.66, 0.012))
    _box(shape, CELLS, (0.0, -0.16, 0.475), (0.28, 0.48, 0.012))
    _rod(shape, DARK, (0.0, -0.5, 0.42), 0.07, 0.24, "Y", tilt=0.5)


def _mast(shape: bmesh.types.BMesh) -> None:
    _rod(shape, WHITE, (0.14, 0.3, 0.68), 0.028, 0.46, "Z")
    _box(shape, WHITE, (0.14, 0.3, 0.94), (0.26, 0.1, 0.12))
    for side in (0.07, 0.21):
        _rod(shape, DARK, (side, 0.36, 0.94), 0.035, 0.04, "Y")


def _antenna(shape: bmesh.types.BMesh) -> None:
    _rod(shape, WHITE, (-0.17, -0.3, 0.6), 0.012, 0.26, "Z")
    bowl = Matrix.Translation((-0.17, -0.3, 0.76)) @ Matrix.Rotation(math.radians(40.0), 4, "X")
    made = bmesh.ops.create_cone(
        shape, cap_ends=True, segments=24, radius1=0.03, radius2=0.15, depth=0.08, matrix=bowl
    )
    _paint(made["verts"], WHITE)


def _box(shape: bmesh.types.BMesh, paint: Paint, middle: Triple, size: Triple, *, tilt: float = 0.0) -> None:
    """Add a box, turned about X by ``tilt`` radians."""
    matrix = Matrix.Translation(middle) @ Matrix.Rotation(tilt, 4, "X") @ Matrix.Diagonal((*size, 1.0))
    made = bmesh.ops.create_cube(shape, size=1.0, matrix=matrix)
    _paint(made["verts"], paint)


def _rod(
    shape: bmesh.types.BMesh,
    paint: Paint,
    middle: Triple,
    radius: float,
    length: float,
    axis: str,
    *,
    tilt: float = 0.0,
) -> None:
    """Add a cylinder along an axis, turned about X by ``tilt`` radians."""
    along = {
        "X": Matrix.Rotation(math.pi / 2.0, 4, "Y"),
        "Y": Matrix.Rotation(math.pi / 2.0, 4, "X"),
        "Z": Matrix.Identity(4),
    }[axis]
    matrix = Matrix.Translation(middle) @ Matrix.Rotation(tilt, 4, "X") @ along
    made = bmesh.ops.create_cone(
        shape, cap_ends=True, segments=32, radius1=radius, radius2=radius, depth=length, matrix=matrix
    )
    _paint(made["verts"], paint)


def _paint(vertices: list[bmesh.types.BMVert], paint: Paint) -> None:
    number = PAINTS.index(paint)
    for face in {face for vertex in vertices for face in vertex.link_faces}:
        face.material_index = number


def _material(paint: Paint) -> bpy.types.Material:
    material = bpy.data.materials.new(paint.name)
    if material.node_tree is None:  # older than 5.0
        material.use_nodes = True
    colour = (*paint.colour, 1.0)
    material.diffuse_color = colour  # type: ignore[assignment]
    surface = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    surface.inputs["Base Color"].default_value = colour
    surface.inputs["Metallic"].default_value = paint.metallic
    surface.inputs["Roughness"].default_value = paint.roughness
    return material
