"""A map in metres whose projection is not stated, or not known here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..body.ellipsoid import Ellipsoid
from .projection import Coordinates


@dataclass(frozen=True)
class Unknown:
    """Touch and the map's own metres are right; longitude and latitude cannot be told."""

    name: ClassVar[str] = "unknown projection"
    in_degrees: ClassVar[bool] = False

    def forward(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Not known."""
        return None

    def inverse(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Not known."""
        return None

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """Not known."""
        return None
