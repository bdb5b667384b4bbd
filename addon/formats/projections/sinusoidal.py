"""Sinusoidal, as many planetary tiles have it.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 30-1 to
30-11.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .conformal import parallel_radius
from .map_in_metres import MapInMetres
from .meridian import latitude_at, meridian_distance
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class Sinusoidal(MapInMetres):
    """True along all parallels and the central meridian."""

    name: ClassVar[str] = "sinusoidal"

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        radius = ellipsoid.semi_major * parallel_radius(latitude, ellipsoid)
        return radius * longitude, meridian_distance(latitude, ellipsoid)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        latitude = latitude_at(y, ellipsoid)
        if latitude is None:
            return None
        longitude = x / (ellipsoid.semi_major * parallel_radius(latitude, ellipsoid)) if x != 0.0 else 0.0
        # The outline itself may be missed by rounding.
        if math.pi < abs(longitude) <= math.pi * (1.0 + 1e-12):
            longitude = math.copysign(math.pi, longitude)
        return longitude, latitude
