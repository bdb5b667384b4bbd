"""Lambert azimuthal equal area, of any aspect, as Europe's grids (EPSG 3035) have it.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 24-17 to
24-30; about a pole they become 24-23 to 24-26, which lose nothing here.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .authalic import authalic_latitude, planetographic_latitude, polar_q
from .azimuth import place_on_sphere
from .conformal import parallel_radius
from .map_in_metres import MapInMetres
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class LambertAzimuthalEqualArea(MapInMetres):
    """All of the body but the centre's antipode."""

    name: ClassVar[str] = "Lambert azimuthal equal area"

    latitude_of_origin: float = 0.0
    """Of the centre, degrees north."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        centre, radius, stretch = self._centre(ellipsoid)
        authalic = authalic_latitude(latitude, ellipsoid)
        east = math.cos(authalic) * math.sin(longitude)
        outward = math.cos(authalic) * math.cos(longitude)
        up = math.sin(authalic)
        facing = 1.0 + math.sin(centre) * up + math.cos(centre) * outward
        scale = radius * math.sqrt(2.0 / facing)
        return scale * stretch * east, scale / stretch * (math.cos(centre) * up - math.sin(centre) * outward)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        centre, radius, stretch = self._centre(ellipsoid)
        x, y = x / stretch, y * stretch
        if x == y == 0.0:
            return 0.0, math.radians(self.latitude_of_origin)
        distance = 2.0 * math.asin(math.hypot(x, y) / (2.0 * radius))
        longitude, authalic = place_on_sphere(centre, distance, x, y)
        return longitude, planetographic_latitude(authalic, ellipsoid)

    def _centre(self, ellipsoid: Ellipsoid) -> tuple[float, float, float]:
        """The centre's authalic latitude, the authalic radius, and the stretch that makes the centre true."""
        if not -90.0 <= self.latitude_of_origin <= 90.0:
            raise ValueError("no such latitude")
        latitude = math.radians(self.latitude_of_origin)
        centre = authalic_latitude(latitude, ellipsoid)
        radius = ellipsoid.semi_major * math.sqrt(polar_q(ellipsoid) / 2.0)
        if abs(self.latitude_of_origin) == 90.0:
            return centre, radius, 1.0
        stretch = ellipsoid.semi_major * parallel_radius(latitude, ellipsoid) / (radius * math.cos(centre))
        return centre, radius, stretch
