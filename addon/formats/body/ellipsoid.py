"""The shape of a body: an ellipsoid of revolution, or a sphere where both axes are equal.

Radii of curvature: J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395,
1987), equations 4-18 and 4-20.
"""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Ellipsoid:
    """Semi-axes in metres."""

    semi_major: float
    semi_minor: float

    @staticmethod
    def sphere(radius: float) -> Ellipsoid:
        """A sphere of this radius, metres."""
        return Ellipsoid(radius, radius)

    @staticmethod
    def flattened(semi_major: float, inverse_flattening: float) -> Ellipsoid:
        """An ellipsoid as geodesists write it; an inverse flattening of 0 means a sphere."""
        if inverse_flattening == 0.0:
            return Ellipsoid.sphere(semi_major)
        return Ellipsoid(semi_major, semi_major * (1.0 - 1.0 / inverse_flattening))

    @property
    def is_sphere(self) -> bool:
        """Whether both axes are equal."""
        return self.semi_major == self.semi_minor

    @property
    def eccentricity_squared(self) -> float:
        """(a^2 - b^2) / a^2."""
        return 1.0 - (self.semi_minor / self.semi_major) ** 2

    def degree_of_latitude(self, latitude: float) -> float:
        """Metres along the meridian in a degree at a latitude (degrees)."""
        sine = math.sin(math.radians(latitude))
        share = self.eccentricity_squared
        flattened = 1.0 - share * sine * sine
        curvature = self.semi_major * (1.0 - share) / (flattened * math.sqrt(flattened))
        return math.radians(1.0) * curvature

    def degree_of_longitude(self, latitude: float) -> float:
        """Metres along the parallel in a degree at a latitude (degrees)."""
        sine = math.sin(math.radians(latitude))
        curvature = self.semi_major / math.sqrt(1.0 - self.eccentricity_squared * sine * sine)
        return math.radians(1.0) * curvature * math.cos(math.radians(latitude))
