"""Between the terrain frame and the scene: the terrain object may have been moved, turned and scaled."""

from __future__ import annotations

from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector
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

    def to_scene(self, east: float, north: float, up: float) -> Vector:
        """Scene coordinates of a terrain place."""
        return self.matrix @ Vector(self.frame.to_object(east, north, up))

    def to_terrain(self, place: Vector) -> Point:
        """Terrain metres of a place in the scene."""
        return self.frame.to_terrain(*(self.matrix.inverted_safe() @ place))

    @property
    def exaggeration(self) -> float:
        """Of heights as they are seen: a terrain stretched upwards in the scene is exaggerated more."""
        along, _north, up = self.matrix.to_scale()
        return self.frame.exaggeration * abs(up / along) if along and up else self.frame.exaggeration

    def longest_side(self, layout: GridLayout) -> float:
        """Of the map, Blender units in the scene."""
        return max(map_size(layout)) * self.frame.units_per_metre * abs(self.matrix.to_scale().x)
