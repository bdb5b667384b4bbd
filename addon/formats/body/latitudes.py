"""The two kinds of latitude on an ellipsoid: of the vertical, and of the line to the centre.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equation 3-28. They
are the same on a sphere, at the equator and at the poles; on Mars they differ by up to 0.34 degrees (20 km).
"""

from __future__ import annotations

import math

from .ellipsoid import Ellipsoid


def to_planetographic(latitude: float, ellipsoid: Ellipsoid) -> float:
    """From a planetocentric latitude; degrees in and out. Poles stay poles."""
    factor = _steeper(ellipsoid)
    if factor == 1.0 or abs(latitude) >= 90.0:
        return latitude
    return math.degrees(math.atan(factor * math.tan(math.radians(latitude))))


def planetographic_degrees(latitude: float, ellipsoid: Ellipsoid) -> float:
    """By how much the planetographic latitude grows with each degree of a planetocentric one, there."""
    factor = _steeper(ellipsoid)
    sine, cosine = math.sin(math.radians(latitude)), math.cos(math.radians(latitude))
    return factor / (cosine * cosine + factor * factor * sine * sine)


def _steeper(ellipsoid: Ellipsoid) -> float:
    """How many times the planetographic latitude's tangent is as large."""
    return (ellipsoid.semi_major / ellipsoid.semi_minor) ** 2
