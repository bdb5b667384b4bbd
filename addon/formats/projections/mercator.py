"""Mercator, of the ellipsoid and of the web.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 7-6 to
7-9; web Mercator (EPSG 3857) is method 1024 of IOGP's Geomatics Guidance Note 7-2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .conformal import isometric_latitude, latitude_of_isometric
from .cylinder import share_of_equator, turn_of
from .map_in_metres import MapInMetres
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class Mercator(MapInMetres):
    """EPSG's variant A by its scale factor, variant B by its standard parallel; not the poles."""

    name: ClassVar[str] = "Mercator"

    standard_parallel_1: float = 0.0
    """Degrees north or south: where the scale is stated."""
    scale_factor: float = 1.0
    """At the standard parallel."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        if abs(latitude) == math.pi / 2.0:
            return None
        scale = self._scale(ellipsoid)
        return scale * longitude, scale * isometric_latitude(latitude, ellipsoid)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        scale = self._scale(ellipsoid)
        return x / scale, latitude_of_isometric(y / scale, ellipsoid)

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """The length of the equator on the map."""
        return turn_of(self._scale, ellipsoid)

    def _scale(self, ellipsoid: Ellipsoid) -> float:
        """Metres on the map for a radian of longitude."""
        return (
            ellipsoid.semi_major * self.scale_factor * share_of_equator(self.standard_parallel_1, ellipsoid)
        )


@dataclass(frozen=True, kw_only=True)
class WebMercator(MapInMetres):
    """Planetographic latitudes drawn as if on a sphere of the semi-major axis."""

    name: ClassVar[str] = "web Mercator"

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        if abs(latitude) == math.pi / 2.0:
            return None
        return ellipsoid.semi_major * longitude, ellipsoid.semi_major * math.asinh(math.tan(latitude))

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        return x / ellipsoid.semi_major, math.atan(math.sinh(y / ellipsoid.semi_major))

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """The length of the equator."""
        return turn_of(lambda body: body.semi_major, ellipsoid)
