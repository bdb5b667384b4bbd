"""Albers equal-area conic.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 14-1 to
14-14.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .authalic import authalic_latitude, planetographic_latitude, polar_q
from .cone import roll, unroll
from .conformal import parallel_radius
from .map_in_metres import MapInMetres
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class Albers(MapInMetres):
    """The contiguous United States are often drawn so."""

    name: ClassVar[str] = "Albers equal area"

    latitude_of_origin: float = 0.0
    """Degrees north."""
    standard_parallel_1: float = 0.0
    """Degrees north."""
    standard_parallel_2: float = 0.0
    """Degrees north; the same as the first where there is one only."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        constant, whole = self._cone(ellipsoid)
        distance = self._distance(latitude, constant, whole, ellipsoid)
        return unroll(constant, distance, self._origin(constant, whole, ellipsoid), longitude)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        constant, whole = self._cone(ellipsoid)
        longitude, distance = roll(constant, self._origin(constant, whole, ellipsoid), x, y)
        share = distance * constant / ellipsoid.semi_major
        sine = (whole - share * share) / (constant * polar_q(ellipsoid))
        if abs(sine) > 1.0 + 1e-12:  # a pole may be missed by rounding
            return None
        authalic = math.asin(min(max(sine, -1.0), 1.0))
        return longitude, planetographic_latitude(authalic, ellipsoid)

    def _cone(self, ellipsoid: Ellipsoid) -> tuple[float, float]:
        """Snyder's n, the constant of the cone, and his C."""
        first, second = math.radians(self.standard_parallel_1), math.radians(self.standard_parallel_2)
        if not max(abs(first), abs(second)) <= math.pi / 2.0:
            raise ValueError("no such cone")
        radius = parallel_radius(first, ellipsoid)
        q = self._q(first, ellipsoid)
        if first == second:
            constant = math.sin(first)
        else:
            other = parallel_radius(second, ellipsoid)
            constant = (radius - other) * (radius + other) / (self._q(second, ellipsoid) - q)
        return constant, radius * radius + constant * q

    def _origin(self, constant: float, whole: float, ellipsoid: Ellipsoid) -> float:
        """Metres from the apex to the map's origin."""
        if not -90.0 <= self.latitude_of_origin <= 90.0:
            raise ValueError("no such origin")
        return self._distance(math.radians(self.latitude_of_origin), constant, whole, ellipsoid)

    def _distance(self, latitude: float, constant: float, whole: float, ellipsoid: Ellipsoid) -> float:
        """Metres from the apex to a latitude."""
        square = whole - constant * self._q(latitude, ellipsoid)
        return ellipsoid.semi_major * math.sqrt(max(square, 0.0)) / constant

    @staticmethod
    def _q(latitude: float, ellipsoid: Ellipsoid) -> float:
        return polar_q(ellipsoid) * math.sin(authalic_latitude(latitude, ellipsoid))
