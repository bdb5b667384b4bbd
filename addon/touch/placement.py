"""Between the terrain frame and the scene: the terrain object may have been moved, turned and scaled."""

from __future__ import annotations

import math
from dataclasses import dataclass

import bpy
from mathutils import Matrix, Quaternion, Vector
from proxygraph import GridLayout

from ..terrain.frame import Point, TerrainFrame, map_size


@dataclass(frozen=True)
class Placement:
    """A terrain frame, and where its object stands in the scene."""

    frame: TerrainFrame
    matrix: Matrix

    @staticmethod
    def of(terrain: bpy.types.Object, frame: TerrainFrame) -> Placement:
        """Take the object's present place."""
        return Placement(frame, terrain.matrix_world.copy())

    @property
    def is_usable(self) -> bool:
        """Whether scene places can be brought to the terrain: not where a scale is 0 or no number."""
        try:
            inverse = self.matrix.inverted()
        except ValueError:
            return False
        numbers = [number for matrix in (self.matrix, inverse) for row in matrix for number in row]
        return all(map(math.isfinite, numbers)) and 0.0 < self.exaggeration < math.inf

    def to_scene(self, east: float, north: float, up: float) -> Vector:
        """Scene coordinates of a terrain place."""
        return self.matrix @ Vector(self.frame.to_object(east, north, up))

    def to_terrain(self, place: Vector) -> Point:
        """Terrain metres of a place in the scene."""
        local = self.matrix.inverted_safe() @ place
        return self.frame.to_terrain(local.x, local.y, local.z)

    def between(self, one: Point, other: Point) -> Vector:
        """The way from one terrain place to another, in the scene.

        It is finer than the difference of two places in Blender's 32 bits, and goes on across the seam of a
        map that wraps.
        """
        east = self.frame.on_map(one[0])
        here = self.frame.shown(east, *one[1:])
        there = self.frame.shown(east + (other[0] - one[0]), *other[1:])
        way = Vector([after - before for before, after in zip(here, there, strict=True)])
        return self.matrix.to_3x3() @ way

    @property
    def units_per_metre(self) -> float:
        """Blender units in the scene for a metre of terrain along the ground."""
        return self.frame.units_per_metre * abs(self.matrix.to_scale().x)

    @property
    def exaggeration(self) -> float:
        """Of heights as they are seen: a terrain stretched upwards in the scene is exaggerated more."""
        scale = self.matrix.to_scale()
        stretched = abs(scale.z / scale.x) if scale.x and scale.z else 1.0
        return self.frame.exaggeration * stretched

    @property
    def is_mirrored(self) -> bool:
        """Whether left and right are exchanged."""
        return self.matrix.determinant() < 0.0

    @property
    def shear(self) -> float:
        """How far the object's axes are from right angles: 0, or up to 1 where two of them coincide."""
        x, y, z = self._axes
        return max(abs(one.normalized().dot(other.normalized())) for one, other in ((x, y), (y, z), (z, x)))

    @property
    def unevenness(self) -> float:
        """How much longer the object's y is than its x, as a share; below 0 where it is shorter."""
        x, y, _z = self._axes
        return float(y.length / x.length) - 1.0

    @property
    def _axes(self) -> tuple[Vector, Vector, Vector]:
        """The object's own, in the scene."""
        turned = self.matrix.to_3x3().transposed()
        return turned[0], turned[1], turned[2]

    @property
    def rotation(self) -> Quaternion:
        """How the object is turned. A mirrored one is taken unmirrored: its up stays up."""
        axes = self.matrix.to_3x3().normalized()
        if axes.determinant() < 0.0:
            axes @= Matrix.Diagonal((-1.0, 1.0, 1.0))
        return axes.to_quaternion()

    def upright(self, east: float, north: float) -> Quaternion:
        """How something is turned that stands upright at a terrain place."""
        if self.frame.bend is None:
            return self.rotation
        ground = Vector(self.frame.to_object(east, north, self.frame.up))
        above = Vector(self.frame.to_object(east, north, self.frame.up + self.frame.bend.radius))
        return self.rotation @ Vector((0.0, 0.0, 1.0)).rotation_difference(above - ground)

    def longest_side(self, layout: GridLayout) -> float:
        """Of the map, Blender units in the scene."""
        return max(map_size(layout)) * self.units_per_metre
