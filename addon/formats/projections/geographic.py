"""Longitude and latitude themselves ("simple cylindrical", "plate carree" in degrees)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .projection import Coordinates


@dataclass(frozen=True)
class Geographic:
    """The map's coordinates are degrees."""

    name: ClassVar[str] = "longitude and latitude"
    in_degrees: ClassVar[bool] = True

    def forward(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Degrees, as they are."""
        return (longitude, latitude) if math.isfinite(longitude) and math.isfinite(latitude) else None

    def inverse(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Degrees, as they are."""
        return (x, y) if math.isfinite(x) and -90.0 <= y <= 90.0 else None

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """Degrees of a full turn."""
        return 360.0
