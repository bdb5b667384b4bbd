"""Stereographic about any place but a pole.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 21-24 to
21-27 and 21-36 to 21-38. The Netherlands' "double" stereographic (EPSG method 9809) is another projection.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .azimuth import place_on_sphere
from .conformal import conformal_tangent, parallel_radius, planetographic_tangent
from .map_in_metres import MapInMetres
from .projection import Coordinates


@dataclass(frozen=True, kw_only=True)
class ObliqueStereographic(MapInMetres):
    """All of the body but the centre's antipode."""

    name: ClassVar[str] = "oblique stereographic"

    latitude_of_origin: float = 0.0
    """Of the centre, degrees north."""
    scale_factor: float = 1.0
    """At the centre."""

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        centre, diameter = self._centre(ellipsoid)
        conformal = math.atan(conformal_tangent(math.tan(latitude), ellipsoid))
        outward = math.cos(conformal) * math.cos(longitude)
        up = math.sin(conformal)
        scale = diameter / (1.0 + math.sin(centre) * up + math.cos(centre) * outward)
        east = math.cos(conformal) * math.sin(longitude)
        return scale * east, scale * (math.cos(centre) * up - math.sin(centre) * outward)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        centre, diameter = self._centre(ellipsoid)
        if x == y == 0.0:
            return 0.0, math.radians(self.latitude_of_origin)
        distance = 2.0 * math.atan2(math.hypot(x, y), diameter)
        longitude, conformal = place_on_sphere(centre, distance, x, y)
        return longitude, math.atan(planetographic_tangent(math.tan(conformal), ellipsoid))

    def _centre(self, ellipsoid: Ellipsoid) -> tuple[float, float]:
        """The centre's conformal latitude, and the diameter of the sphere that is seen, metres."""
        if not -90.0 < self.latitude_of_origin < 90.0:
            raise ValueError("no such centre")
        latitude = math.radians(self.latitude_of_origin)
        centre = math.atan(conformal_tangent(math.tan(latitude), ellipsoid))
        radius = ellipsoid.semi_major * parallel_radius(latitude, ellipsoid) / math.cos(centre)
        return centre, 2.0 * radius * self.scale_factor
