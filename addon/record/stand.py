"""Where a terrain stands in the scene, in doubles: what is baked must not lose what the hand could feel."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from mathutils import Matrix

from ..terrain.frame import Point, TerrainFrame
from ..touch.placement import Placement
from .affine import Affine


@dataclass(frozen=True)
class Stand:
    """A terrain frame, and the matrix of its object."""

    frame: TerrainFrame
    matrix: Affine

    @cached_property
    def placement(self) -> Placement:
        """The same for those who draw."""
        rows = [(*row, shift) for row, shift in zip(self.matrix.linear, self.matrix.shift, strict=True)]
        return Placement(self.frame, Matrix((*rows, (0.0, 0.0, 0.0, 1.0))))

    def to_terrain(self, place: Point) -> Point:
        """Terrain metres of a place in the scene."""
        return self.frame.to_terrain(*self._inverse.point(place))

    def to_scene(self, east: float, north: float, up: float) -> Point:
        """Scene coordinates of a terrain place."""
        return self.matrix.point(self.frame.to_object(east, north, up))

    @property
    def across(self) -> float:
        """Scene units in a unit of the object, across."""
        return _length(self.matrix.column(0))

    @property
    def exaggeration(self) -> float:
        """Of heights as they are seen."""
        return self.frame.exaggeration * (_length(self.matrix.column(2)) / self.across)

    @cached_property
    def _inverse(self) -> Affine:
        return self.matrix.inverse()


def _length(vector: Point) -> float:
    x, y, z = vector
    return math.sqrt(x * x + y * y + z * z)
