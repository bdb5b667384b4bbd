"""What all projections in metres have in common: origin, and what is refused.

Parameters come from files that may be damaged or hostile. They are taken as they are: where they make no
map, no place has coordinates and no coordinates a place. Neither direction raises or gives NaN.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .projection import Coordinates

AGREEMENT = 1e-8
"""How near a place found must come to where it was looked for, in semi-major axes (6 cm on Earth).

Where series or iterations have left their ground, they miss by more: such a place is none.
"""
TURNS = 2.0
"""How many turns away from the central longitude a map that repeats itself may be asked."""


@dataclass(frozen=True, kw_only=True)
class MapInMetres(ABC):
    """Longitudes are counted from a central one; the map's origin has false coordinates."""

    in_degrees: ClassVar[bool] = False

    central_longitude: float = 0.0
    """Degrees east."""
    false_easting: float = 0.0
    """Metres, of the map's origin."""
    false_northing: float = 0.0

    def forward(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Metres east and north of a place (degrees east of any turn, planetographic degrees north)."""
        if not (-90.0 <= latitude <= 90.0 and _is_body(ellipsoid)):
            return None
        try:
            east_of_centre = math.remainder(longitude - self.central_longitude, 360.0)
            shown = self._project(math.radians(east_of_centre), math.radians(latitude), ellipsoid)
        except (ArithmeticError, ValueError):  # the two that mathematics raises
            return None
        return (
            None if shown is None else _finite(shown[0] + self.false_easting, shown[1] + self.false_northing)
        )

    def inverse(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Degrees east of any turn and planetographic degrees north of a place on the map."""
        if not (math.isfinite(x) and math.isfinite(y) and _is_body(ellipsoid)):
            return None
        try:
            found = self._unproject(x - self.false_easting, y - self.false_northing, ellipsoid)
        except (ArithmeticError, ValueError):
            return None
        if found is None:
            return None
        longitude = self.central_longitude + math.degrees(found[0])
        latitude = math.degrees(found[1])
        return _finite(longitude, latitude) if self._shows(longitude, latitude, x, y, ellipsoid) else None

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """Metres eastward after which the map repeats itself; ``None`` where it does not."""
        return None

    @abstractmethod
    def _project(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Metres from the origin; radians from the central longitude (-pi to pi) and from the equator."""

    @abstractmethod
    def _unproject(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Radians from the central longitude and from the equator; metres from the origin."""

    def _shows(self, longitude: float, latitude: float, x: float, y: float, ellipsoid: Ellipsoid) -> bool:
        """Whether the map has this place at these coordinates."""
        there = self.forward(longitude, latitude, ellipsoid)
        if there is None:
            return False
        miss = there[0] - x
        turn = self.turn(ellipsoid)
        if turn is not None:
            if abs(x - self.false_easting) > TURNS * turn:
                return False
            miss = math.remainder(miss, turn)
        allowed = AGREEMENT * max(ellipsoid.semi_major, abs(x), abs(y))
        return math.hypot(miss, there[1] - y) <= allowed


def _is_body(ellipsoid: Ellipsoid) -> bool:
    """Whether the axes make a sphere or an oblate ellipsoid."""
    return 0.0 < ellipsoid.semi_minor <= ellipsoid.semi_major < math.inf


def _finite(x: float, y: float) -> Coordinates | None:
    return (x, y) if math.isfinite(x) and math.isfinite(y) else None
