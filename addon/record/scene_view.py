"""A take's places in the scene, as numbers with 32 bits that no ground buries; without Blender."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from ..terrain.frame import TerrainFrame
from .take_data import Numbers

CLEARANCE = 8.0
"""Last places of 32-bit scene coordinates by which a point is held above the ground: Blender rounds a few
times on the way from two keys to a place between them."""

Highest = Callable[[Numbers, Numbers], Numbers]
"""Metres of what must not bury a point, at terrain metres east and north on the map; NaN for nothing."""


@dataclass(frozen=True)
class SceneView:
    """From the terrain frame to scene coordinates and back, many places at once."""

    frame: TerrainFrame
    matrix: Numbers
    """Of the terrain object, 4 x 4."""

    @cached_property
    def units_per_metre(self) -> float:
        """Blender units in the scene."""
        return self.frame.units_per_metre * float(np.linalg.norm(self.matrix[:3, 0]))

    @cached_property
    def units_per_metre_up(self) -> float:
        """The same of heights, which are exaggerated."""
        return (
            self.frame.units_per_metre * self.frame.exaggeration * float(np.linalg.norm(self.matrix[:3, 2]))
        )

    def to_scene(self, places: Numbers) -> Numbers:
        """Scene coordinates of terrain places, n x 3; east runs on beyond a map that wraps."""
        east, north, up = places.T
        return self._shown(self.frame.on_map(east), north, up)

    def to_terrain(self, points: npt.NDArray[np.floating]) -> Numbers:
        """Terrain places on the map of scene coordinates, n x 3."""
        local = points.astype(np.float64) @ self._inverse[:3, :3].T + self._inverse[:3, 3]
        if self.frame.bend is not None:
            return np.array([self.frame.to_terrain(*point) for point in local.tolist()]).reshape(-1, 3)
        return np.stack(self.frame.to_terrain(*local.T), axis=1)

    def above_ground(self, places: Numbers, highest: Highest) -> npt.NDArray[np.float32]:
        """Scene coordinates of terrain places, lifted where the ground would bury them."""
        east, north, up = places.T
        lifted = np.stack((east, north, np.fmax(up, highest(self.frame.on_map(east), north))), axis=1)
        points = self.to_scene(lifted)
        for _rounding in range(
            8
        ):  # a lift is itself rounded, and moves the point sideways where a map is bent
            rounded = points.astype(np.float32)
            missing = self.missing(rounded, highest)
            if not missing.any():
                break
            east, north, up = self.to_terrain(rounded).T
            points = points + self._shown(east, north, up + missing) - self._shown(east, north, up)
        return rounded

    def missing(
        self, points: npt.NDArray[np.floating], highest: Highest, clearance: float = CLEARANCE
    ) -> Numbers:
        """Metres that scene points lack to be clear of the ground; 0 where they are."""
        east, north, up = self.to_terrain(points).T
        margin = clearance * self.rounding(points) / self.units_per_metre_up
        lack = highest(self.frame.on_map(east), north) + margin - up
        return np.where(lack > 0.0, lack, 0.0)

    @staticmethod
    def rounding(points: npt.NDArray[np.floating]) -> float:
        """The last place of the largest coordinate as Blender keeps it, Blender units."""
        return float(np.spacing(np.float32(np.abs(points).max(initial=1e-30))))

    @cached_property
    def _inverse(self) -> Numbers:
        inverse: Numbers = np.linalg.inv(self.matrix)
        return inverse

    def _shown(self, east: Numbers, north: Numbers, up: Numbers) -> Numbers:
        local = np.stack(self.frame.shown(east, north, up), axis=1)
        points: Numbers = local @ self.matrix[:3, :3].T + self.matrix[:3, 3]
        return points
