"""The conformal latitude of an ellipsoid, by which its angles are those of a sphere.

Equations 7 to 9 and 19 to 21 of C. F. F. Karney, "Transverse Mercator with an accuracy of a few
nanometers", Journal of Geodesy 85 (2011): tangents instead of angles, exact near poles too.
"""

from __future__ import annotations

import math

from ..body.ellipsoid import Ellipsoid

STEPS = 8
"""Of Newton's method at most; on planets 2 or 3 are enough for all digits."""


def conformal_tangent(tangent: float, ellipsoid: Ellipsoid) -> float:
    """The tangent of the conformal latitude, from that of the planetographic one."""
    eccentricity = math.sqrt(ellipsoid.eccentricity_squared)
    secant = math.hypot(1.0, tangent)
    sigma = math.sinh(eccentricity * math.atanh(eccentricity * tangent / secant))
    return tangent * math.hypot(1.0, sigma) - sigma * secant


def planetographic_tangent(conformal: float, ellipsoid: Ellipsoid) -> float:
    """The tangent of the planetographic latitude, from that of the conformal one."""
    share = ellipsoid.eccentricity_squared
    eccentricity = math.sqrt(share)
    # The first guess is right at the equator, or far from it.
    far = abs(conformal) > 70.0
    tangent = conformal * (math.exp(eccentricity * math.atanh(eccentricity)) if far else 1.0 / (1.0 - share))
    for _ in range(STEPS):
        reached = conformal_tangent(tangent, ellipsoid)
        slope = (1.0 - share) * math.hypot(1.0, tangent) * math.hypot(1.0, reached)
        change = (conformal - reached) / slope * (1.0 + (1.0 - share) * tangent * tangent)
        tangent += change
        if abs(change) <= 1e-16 * abs(tangent):
            break
    return tangent


def isometric_latitude(latitude: float, ellipsoid: Ellipsoid) -> float:
    """Mercator's northing on a body of radius 1; radians in and out."""
    return math.asinh(conformal_tangent(math.tan(latitude), ellipsoid))


def latitude_of_isometric(isometric: float, ellipsoid: Ellipsoid) -> float:
    """The planetographic latitude; radians in and out."""
    return math.atan(planetographic_tangent(math.sinh(isometric), ellipsoid))


def parallel_radius(latitude: float, ellipsoid: Ellipsoid) -> float:
    """Of the circle of latitude, as a share of the semi-major axis (Snyder 14-15); radians in."""
    sine = math.sin(latitude)
    return math.cos(latitude) / math.sqrt(1.0 - ellipsoid.eccentricity_squared * sine * sine)
