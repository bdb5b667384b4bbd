"""Equirectangular (equidistant cylindrical, "simple cylindrical" in metres).

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 12-1 to
12-4 on a sphere; on an ellipsoid northings are metres along the meridian and eastings along the standard
parallel (IOGP Geomatics Guidance Note 7-2, method 1028). Maps that take an ellipsoid's latitudes as a
sphere's (method 1029) are read with a sphere.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .cylinder import share_of_equator, turn_of
from .map_in_metres import MapInMetres
from .meridian import latitude_at, meridian_distance
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class Equirectangular(MapInMetres):
    """True along meridians and along the standard parallel."""

    name: ClassVar[str] = "equirectangular"

    standard_parallel_1: float = 0.0
    """The latitude of true scale, degrees north or south."""
    latitude_of_origin: float = 0.0
    """Degrees north."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        north = meridian_distance(latitude, ellipsoid) - self._origin(ellipsoid)
        return self._scale(ellipsoid) * longitude, north

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        latitude = latitude_at(y + self._origin(ellipsoid), ellipsoid)
        return None if latitude is None else (x / self._scale(ellipsoid), latitude)

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """The length of the standard parallel."""
        return turn_of(self._scale, ellipsoid)

    def _origin(self, ellipsoid: Ellipsoid) -> float:
        """Metres from the equator."""
        return meridian_distance(math.radians(self.latitude_of_origin), ellipsoid)

    def _scale(self, ellipsoid: Ellipsoid) -> float:
        """Metres on the map for a radian of longitude."""
        return ellipsoid.semi_major * share_of_equator(self.standard_parallel_1, ellipsoid)
