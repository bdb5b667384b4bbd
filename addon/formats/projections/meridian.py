"""Krueger's series in the third flattening n, to n^6: conformal and rectifying latitude, and back.

Equations 14, 35 and 36 of C. F. F. Karney, "Transverse Mercator with an accuracy of a few nanometers",
Journal of Geodesy 85 (2011). What is left out is n^7: 5 nm on Earth, 1 nm on Mars, 20 cm on Saturn.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from ..body.ellipsoid import Ellipsoid
from .conformal import conformal_tangent, planetographic_tangent

TO_RECTIFYING = (
    (1 / 2, -2 / 3, 5 / 16, 41 / 180, -127 / 288, 7891 / 37800),
    (0.0, 13 / 48, -3 / 5, 557 / 1440, 281 / 630, -1983433 / 1935360),
    (0.0, 0.0, 61 / 240, -103 / 140, 15061 / 26880, 167603 / 181440),
    (0.0, 0.0, 0.0, 49561 / 161280, -179 / 168, 6601661 / 7257600),
    (0.0, 0.0, 0.0, 0.0, 34729 / 80640, -3418889 / 1995840),
    (0.0, 0.0, 0.0, 0.0, 0.0, 212378941 / 319334400),
)
"""Karney's alpha: a row for each harmonic, a column for each power of n from 1."""

TO_CONFORMAL = (
    (1 / 2, -2 / 3, 37 / 96, -1 / 360, -81 / 512, 96199 / 604800),
    (0.0, 1 / 48, 1 / 15, -437 / 1440, 46 / 105, -1118711 / 3870720),
    (0.0, 0.0, 17 / 480, -37 / 840, -209 / 4480, 5569 / 90720),
    (0.0, 0.0, 0.0, 4397 / 161280, -11 / 504, -830251 / 7257600),
    (0.0, 0.0, 0.0, 0.0, 4583 / 161280, -108847 / 3991680),
    (0.0, 0.0, 0.0, 0.0, 0.0, 20648693 / 638668800),
)
"""Karney's beta."""


@dataclass(frozen=True)
class MeridianSeries:
    """The series of one ellipsoid."""

    radius: float
    """Of the circle as long as a meridian, metres."""
    to_rectifying: tuple[float, ...]
    to_conformal: tuple[float, ...]


@lru_cache(maxsize=32)
def meridian_series(ellipsoid: Ellipsoid) -> MeridianSeries:
    """Work the coefficients out, once for each ellipsoid."""
    major, minor = ellipsoid.semi_major, ellipsoid.semi_minor
    n = (major - minor) / (major + minor)
    return MeridianSeries(
        radius=major / (1.0 + n) * (1.0 + n**2 / 4.0 + n**4 / 64.0 + n**6 / 256.0),
        to_rectifying=tuple(_polynomial(row, n) for row in TO_RECTIFYING),
        to_conformal=tuple(_polynomial(row, n) for row in TO_CONFORMAL),
    )


def meridian_distance(latitude: float, ellipsoid: Ellipsoid) -> float:
    """Metres along the meridian from the equator to a planetographic latitude (radians)."""
    series = meridian_series(ellipsoid)
    conformal = math.atan(conformal_tangent(math.tan(latitude), ellipsoid))
    harmonics = enumerate(series.to_rectifying, start=1)
    return series.radius * (conformal + sum(c * math.sin(2 * k * conformal) for k, c in harmonics))


def latitude_at(distance: float, ellipsoid: Ellipsoid) -> float | None:
    """The planetographic latitude (radians) so many metres along the meridian; ``None`` beyond a pole."""
    series = meridian_series(ellipsoid)
    rectifying = distance / series.radius
    if abs(rectifying) > math.pi / 2.0 + 1e-12:  # a pole may be missed by rounding
        return None
    harmonics = enumerate(series.to_conformal, start=1)
    conformal = rectifying - sum(c * math.sin(2 * k * rectifying) for k, c in harmonics)
    if abs(conformal) >= math.pi / 2.0:
        return math.copysign(math.pi / 2.0, conformal)
    return math.atan(planetographic_tangent(math.tan(conformal), ellipsoid))


def _polynomial(coefficients: tuple[float, ...], n: float) -> float:
    """Coefficients of n, n^2, ... by Horner's rule."""
    value = 0.0
    for coefficient in reversed(coefficients):
        value = (value + coefficient) * n
    return value
