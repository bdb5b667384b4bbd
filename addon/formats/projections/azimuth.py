"""A sphere seen from above one of its places."""

from __future__ import annotations

import math

from .projection import Coordinates


def place_on_sphere(centre: float, distance: float, x: float, y: float) -> Coordinates:
    """Radians from the centre's meridian and from the equator, of a place at an angular distance.

    Args:
        centre: the latitude of the centre.
        x, y: the direction, eastward and northward at the centre, of any length but 0.
    """
    length = math.hypot(x, y)
    sine, cosine = math.sin(distance), math.cos(distance)
    east = sine * x / length
    north = sine * y / length
    outward = math.cos(centre) * cosine - math.sin(centre) * north
    upward = math.sin(centre) * cosine + math.cos(centre) * north
    return math.atan2(east, outward), math.atan2(upward, math.hypot(east, outward))
