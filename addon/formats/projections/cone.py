"""A cone unrolled: what conic projections have in common.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 14-1 to
14-11: the same for all conics once the distance from the apex is known.
"""

from __future__ import annotations

import math

from .projection import Coordinates


def unroll(constant: float, distance: float, origin: float, longitude: float) -> Coordinates:
    """Metres from the origin.

    Args:
        constant: of the cone, below 0 where it opens to the south.
        distance, origin: metres from the apex, of the place and of the map's origin.
        longitude: radians from the central meridian.
    """
    angle = constant * longitude
    return distance * math.sin(angle), origin - distance * math.cos(angle)


def roll(constant: float, origin: float, x: float, y: float) -> tuple[float, float]:
    """(longitude, distance) as ``unroll`` takes them; the distance has the sign of ``origin``."""
    side = math.copysign(1.0, constant)
    down = origin - y
    return math.atan2(side * x, side * down) / constant, side * math.hypot(x, down)
