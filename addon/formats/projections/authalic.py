"""The authalic latitude of an ellipsoid, by which its areas are those of a sphere.

J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), equations 3-11 to
3-13, turned so that they count from the nearer pole: what is left of q there keeps its digits.
"""

from __future__ import annotations

import math

from ..body.ellipsoid import Ellipsoid

STEPS = 12
"""Of Newton's method at most; on planets 3 or 4 are enough for all digits."""


def authalic_latitude(latitude: float, ellipsoid: Ellipsoid) -> float:
    """From the planetographic latitude; radians in and out."""
    left = _left_to_pole(_rest_of_sine(abs(latitude)), ellipsoid)
    return math.copysign(_latitude_of_rest(left / polar_q(ellipsoid)), latitude)


def planetographic_latitude(authalic: float, ellipsoid: Ellipsoid) -> float:
    """From the authalic latitude; radians in and out."""
    share = ellipsoid.eccentricity_squared
    rest = _rest_of_sine(abs(authalic))
    wanted = rest * polar_q(ellipsoid)
    for _ in range(STEPS):
        flattened = 1.0 - share * (1.0 - rest) ** 2
        slope = 2.0 * (1.0 - share) / (flattened * flattened)
        change = (wanted - _left_to_pole(rest, ellipsoid)) / slope
        rest = min(max(rest + change, 0.0), 1.0)
        if abs(change) <= 1e-16 * rest:
            break
    return math.copysign(_latitude_of_rest(rest), authalic)


def polar_q(ellipsoid: Ellipsoid) -> float:
    """Snyder's q of the pole: 2 on a sphere."""
    return _left_to_pole(1.0, ellipsoid)


def _left_to_pole(rest: float, ellipsoid: Ellipsoid) -> float:
    """What q lacks of the pole's at a latitude, from 1 - its sine."""
    share = ellipsoid.eccentricity_squared
    if share == 0.0:
        return 2.0 * rest
    eccentricity = math.sqrt(share)
    sine = 1.0 - rest
    algebraic = rest * (1.0 + share * sine) / (1.0 - share * sine * sine)
    logarithmic = math.atanh(eccentricity * rest / (1.0 - share * sine)) / eccentricity
    return algebraic + (1.0 - share) * logarithmic


def _rest_of_sine(latitude: float) -> float:
    """1 - sine, without loss near the pole."""
    return 2.0 * math.sin((math.pi / 2.0 - latitude) / 2.0) ** 2


def _latitude_of_rest(rest: float) -> float:
    """The latitude whose sine is 1 - rest."""
    return math.pi / 2.0 - 2.0 * math.asin(math.sqrt(min(rest / 2.0, 1.0)))
