"""Transverse Mercator (Gauss-Krueger), on which UTM rests.

Krueger's series to n^6, equations 7 to 36 of C. F. F. Karney, "Transverse Mercator with an accuracy of a
few nanometers", Journal of Geodesy 85 (2011). On a sphere the formulas are exact. UTM's parameters:
J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), pages 57 and 58.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .conformal import conformal_tangent, planetographic_tangent
from .map_in_metres import MapInMetres
from .meridian import meridian_distance, meridian_series
from .projection import Coordinates

WIDEST = 2.0
"""East of the central meridian at most, in radii (75 degrees at the equator): the series are left beyond."""


@dataclass(frozen=True, kw_only=True)
class TransverseMercator(MapInMetres):
    """Right to a millimetre within 40 degrees of the central meridian (planets from Mercury to Mars)."""

    name: ClassVar[str] = "transverse Mercator"

    latitude_of_origin: float = 0.0
    """Degrees north."""
    scale_factor: float = 1.0
    """Along the central meridian."""

    @staticmethod
    def utm(zone: int, north: bool) -> TransverseMercator:
        """A zone of UTM, 1 to 60, on either half of the globe.

        Raises:
            ValueError: there is no such zone.
        """
        if not 1 <= zone <= 60:
            raise ValueError(f"UTM zone: found {zone}, expected 1 to 60")
        return TransverseMercator(
            central_longitude=6.0 * zone - 183.0,
            scale_factor=0.9996,
            false_easting=500_000.0,
            false_northing=0.0 if north else 10_000_000.0,
        )

    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        tangent = conformal_tangent(math.tan(latitude), ellipsoid)
        cosine = math.cos(longitude)
        north = math.atan2(tangent, cosine)
        east = math.asinh(math.sin(longitude) / math.hypot(tangent, cosine))
        if abs(east) > WIDEST:
            return None
        series = meridian_series(ellipsoid)
        sphere = complex(north, east)
        harmonics = enumerate(series.to_rectifying, start=1)
        there = sphere + sum(c * cmath.sin(2 * k * sphere) for k, c in harmonics)
        scale = self.scale_factor * series.radius
        return scale * there.imag, scale * there.real - self._origin(ellipsoid)

    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        series = meridian_series(ellipsoid)
        scale = self.scale_factor * series.radius
        there = complex((y + self._origin(ellipsoid)) / scale, x / scale)
        if abs(there.imag) > WIDEST + 1.0:  # nothing is shown there, and the series would overflow
            return None
        harmonics = enumerate(series.to_conformal, start=1)
        sphere = there - sum(c * cmath.sin(2 * k * there) for k, c in harmonics)
        east, cosine = math.sinh(sphere.imag), math.cos(sphere.real)
        tangent = math.sin(sphere.real) / math.hypot(east, cosine)
        return math.atan2(east, cosine), math.atan(planetographic_tangent(tangent, ellipsoid))

    def _origin(self, ellipsoid: Ellipsoid) -> float:
        """The origin's metres north of the equator, on the map."""
        return self.scale_factor * meridian_distance(math.radians(self.latitude_of_origin), ellipsoid)
