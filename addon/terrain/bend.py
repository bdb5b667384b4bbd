"""A flat map laid onto a sphere, for the eye only: grid and touch stay as they are.

Object space then has the middle of the map on top, at its origin. A map in degrees becomes the part of the
globe that it is (with all its meridians, a whole globe); a map in metres is laid around its middle with
distances and directions from there kept (azimuthal equidistant: J. P. Snyder, "Map Projections: A Working
Manual", USGS Professional Paper 1395, 1987, section 25).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ..formats import Georeference


@dataclass(frozen=True)
class Bend:
    """The sphere, and how the map lies on it. Places are metres east and north of the map's middle."""

    radius: float
    """Metres."""
    latitude: float | None = None
    """Degrees, of the map's middle; ``None`` on a map in metres."""
    parallel: float | None = None
    """Metres in a radian of longitude, as the map has them; ``None`` on a map in metres."""

    @staticmethod
    def of(georeference: Georeference, rows: int) -> Bend:
        """The sphere that fits a map in its middle."""
        ellipsoid = georeference.ellipsoid
        if not georeference.projection.in_degrees:
            return Bend(radius=ellipsoid.semi_major)
        middle = georeference.y((rows - 1) / 2.0)
        return Bend(
            radius=math.degrees(ellipsoid.degree_of_latitude(middle)),
            latitude=middle,
            parallel=math.degrees(ellipsoid.degree_of_longitude(middle)),
        )

    def bent(self, east: Any, north: Any, up: Any) -> tuple[Any, Any, Any]:
        """Where a place of the flat map comes to lie, metres; numbers or arrays."""
        x, y, z = self._direction(east, north)
        away = self.radius + up
        return away * x, away * y, away * z - self.radius

    def flat(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """The place on the flat map, metres, of one that was bent; below the sphere's centre too."""
        away = math.hypot(x, y, z + self.radius)
        if self.latitude is None or self.parallel is None:
            across = math.hypot(x, y)
            arc = self.radius * math.atan2(across, z + self.radius)
            share = arc / across if across > 0.0 else 1.0
            return share * x, share * y, away - self.radius
        middle = math.radians(self.latitude)
        toward_pole = math.sin(middle) * (z + self.radius) + math.cos(middle) * y
        toward_equator = math.cos(middle) * (z + self.radius) - math.sin(middle) * y
        latitude = math.atan2(toward_pole, math.hypot(x, toward_equator))
        return (
            self.parallel * math.atan2(x, toward_equator),
            self.radius * (latitude - middle),
            away - self.radius,
        )

    def _direction(self, east: Any, north: Any) -> tuple[Any, Any, Any]:
        """From the sphere's centre, of length 1: east, north and up at the map's middle."""
        import numpy as np  # only Blender is sure to have it, and only pictures are bent

        if self.latitude is None or self.parallel is None:
            across = np.hypot(east, north)
            angle = across / self.radius
            share = np.sinc(angle / math.pi) / self.radius
            return share * east, share * north, np.cos(angle)
        middle = math.radians(self.latitude)
        longitude, latitude = east / self.parallel, middle + north / self.radius
        toward_equator = np.cos(latitude) * np.cos(longitude)
        return (
            np.cos(latitude) * np.sin(longitude),
            math.cos(middle) * np.sin(latitude) - math.sin(middle) * toward_equator,
            math.sin(middle) * np.sin(latitude) + math.cos(middle) * toward_equator,
        )
