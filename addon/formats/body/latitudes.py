"""The two kinds of latitude on an ellipsoid: of the vertical, and of the line to the centre.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equation 3-28. They
are the same on a sphere, at the equator and at the poles; on Mars they differ by up to 0.34 degrees (20 km).
"""

from __future__ import annotations

import math

from .ellipsoid import Ellipsoid


def to_planetocentric(latitude: float, ellipsoid: Ellipsoid) -> float:
    """From a planetographic latitude; degrees in and out."""
    return _steepened(latitude, (ellipsoid.semi_minor / ellipsoid.semi_major) ** 2)


def to_planetographic(latitude: float, ellipsoid: Ellipsoid) -> float:
    """From a planetocentric latitude; degrees in and out."""
    return _steepened(latitude, (ellipsoid.semi_major / ellipsoid.semi_minor) ** 2)


def _steepened(latitude: float, factor: float) -> float:
    """The angle whose tangent is so many times as large; poles stay poles."""
    if factor == 1.0 or abs(latitude) >= 90.0:
        return latitude
    return math.degrees(math.atan(factor * math.tan(math.radians(latitude))))
