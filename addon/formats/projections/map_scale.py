"""How many metres of a map stand for one metre of ground.

Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), calls them the scale
factors along the axes; here they are measured by the projection itself, over a few metres.
"""

from __future__ import annotations

import math

from ..body.ellipsoid import Ellipsoid
from .projection import Coordinates, Projection

STRETCH = 1e-6
"""Of the semi-major axis (6 m on Earth): long enough for doubles, short enough for the map to be straight."""

TRUE_TO_SCALE = 0.01
"""Scales as near to 1 count as 1: a cell of 30 m on a UTM map, 0.04% off, is called one of 30 m."""


def map_scale(projection: Projection, ellipsoid: Ellipsoid, place: Coordinates) -> tuple[float, float]:
    """Metres of the map for one of ground, along its x and along its y; 1 where the map cannot tell.

    Args:
        place: on the map, in its metres.
    """
    half = STRETCH * ellipsoid.semi_major / 2.0
    (x, y), along = place, 2.0 * half
    across = _ground(projection, ellipsoid, (x - half, y), (x + half, y))
    upward = _ground(projection, ellipsoid, (x, y - half), (x, y + half))
    return _scale(along, across), _scale(along, upward)


def _scale(along: float, ground: float | None) -> float:
    if ground is None or ground <= 0.0:
        return 1.0
    scale = along / ground
    return 1.0 if abs(scale - 1.0) <= TRUE_TO_SCALE or not math.isfinite(scale) else scale


def _ground(
    projection: Projection, ellipsoid: Ellipsoid, start: Coordinates, end: Coordinates
) -> float | None:
    """Metres between two places of the map, straight through the ground: they are near."""
    places = [projection.inverse(*place, ellipsoid) for place in (start, end)]
    if places[0] is None or places[1] is None:
        return None
    return math.dist(_geocentric(*places[0], ellipsoid), _geocentric(*places[1], ellipsoid))


def _geocentric(longitude: float, latitude: float, ellipsoid: Ellipsoid) -> tuple[float, float, float]:
    """Metres from the body's centre (planetographic degrees)."""
    sine, cosine = math.sin(math.radians(latitude)), math.cos(math.radians(latitude))
    share = ellipsoid.eccentricity_squared
    radius = ellipsoid.semi_major / math.sqrt(1.0 - share * sine * sine)
    east = math.radians(longitude)
    return (
        radius * cosine * math.cos(east),
        radius * cosine * math.sin(east),
        radius * (1.0 - share) * sine,
    )
