"""Lambert conformal conic, with one standard parallel or two.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 15-1 to
15-11.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .cone import roll, unroll
from .conformal import isometric_latitude, latitude_of_isometric, parallel_radius
from .map_in_metres import MapInMetres
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class LambertConformalConic(MapInMetres):
    """All of the body but the pole that the cone opens to."""

    name: ClassVar[str] = "Lambert conformal conic"

    latitude_of_origin: float = 0.0
    """Degrees north."""
    standard_parallel_1: float = 0.0
    """Degrees north."""
    standard_parallel_2: float = 0.0
    """Degrees north; the same as the first where there is one only."""
    scale_factor: float = 1.0
    """Along the standard parallels."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        constant, scale = self._cone(ellipsoid)
        if latitude == -math.copysign(math.pi / 2.0, constant):
            return None
        distance = scale * math.exp(-constant * isometric_latitude(latitude, ellipsoid))
        return unroll(constant, distance, self._origin(constant, scale, ellipsoid), longitude)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        constant, scale = self._cone(ellipsoid)
        longitude, distance = roll(constant, self._origin(constant, scale, ellipsoid), x, y)
        if distance == 0.0:
            return 0.0, math.copysign(math.pi / 2.0, constant)
        return longitude, latitude_of_isometric(-math.log(distance / scale) / constant, ellipsoid)

    def _cone(self, ellipsoid: Ellipsoid) -> tuple[float, float]:
        """The constant of the cone, and metres from its apex where the isometric latitude is 0."""
        first, second = math.radians(self.standard_parallel_1), math.radians(self.standard_parallel_2)
        if not max(abs(first), abs(second)) < math.pi / 2.0:
            raise ValueError("no such cone")
        radius = parallel_radius(first, ellipsoid)
        isometric = isometric_latitude(first, ellipsoid)
        if first == second:
            constant = math.sin(first)
        else:
            ratio = math.log(radius / parallel_radius(second, ellipsoid))
            constant = ratio / (isometric_latitude(second, ellipsoid) - isometric)
        share = radius * math.exp(constant * isometric) / constant
        return constant, ellipsoid.semi_major * self.scale_factor * share

    def _origin(self, constant: float, scale: float, ellipsoid: Ellipsoid) -> float:
        """Metres from the apex to the map's origin."""
        latitude = math.radians(self.latitude_of_origin)
        if latitude == math.copysign(math.pi / 2.0, constant):
            return 0.0
        if not abs(latitude) < math.pi / 2.0:
            raise ValueError("no such origin")
        return scale * math.exp(-constant * isometric_latitude(latitude, ellipsoid))
