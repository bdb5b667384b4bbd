"""Polar stereographic, about either pole.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 21-33 to
21-40 with 15-9 and 14-15. On a sphere they are 21-5 to 21-12.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .conformal import isometric_latitude, latitude_of_isometric, parallel_radius
from .map_in_metres import MapInMetres
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class PolarStereographic(MapInMetres):
    """The central longitude runs down from the north pole, or up from the south pole."""

    name: ClassVar[str] = "polar stereographic"

    latitude_of_origin: float = 90.0
    """90 or -90: the pole."""
    standard_parallel_1: float = 90.0
    """The latitude of true scale, degrees; its sign does not matter. 90: the scale is stated at the pole."""
    scale_factor: float = 1.0
    """At the standard parallel."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        side = self._side()
        if side is None or latitude == -side * math.pi / 2.0:
            return None
        distance = self._scale(ellipsoid) * math.exp(-isometric_latitude(side * latitude, ellipsoid))
        return distance * math.sin(longitude), -side * distance * math.cos(longitude)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        side = self._side()
        if side is None:
            return None
        distance = math.hypot(x, y) / self._scale(ellipsoid)
        if distance == 0.0:
            return 0.0, side * math.pi / 2.0
        latitude = latitude_of_isometric(-math.log(distance), ellipsoid)
        return math.atan2(x, -side * y), side * latitude

    def _side(self) -> float | None:
        """1 for the north pole, -1 for the south pole."""
        return math.copysign(1.0, self.latitude_of_origin) if abs(self.latitude_of_origin) == 90.0 else None

    def _scale(self, ellipsoid: Ellipsoid) -> float:
        """Metres from the pole where the isometric latitude is 0."""
        true = math.radians(abs(self.standard_parallel_1))
        if abs(self.standard_parallel_1) == 90.0:
            eccentricity = math.sqrt(ellipsoid.eccentricity_squared)
            share = 2.0 / (
                math.sqrt(1.0 - ellipsoid.eccentricity_squared)
                * math.exp(eccentricity * math.atanh(eccentricity))
            )
        elif true < math.pi / 2.0:
            share = parallel_radius(true, ellipsoid) * math.exp(isometric_latitude(true, ellipsoid))
        else:
            raise ValueError("no such parallel")
        return ellipsoid.semi_major * self.scale_factor * share
