"""What every projection gives."""

from __future__ import annotations

from typing import ClassVar, Protocol

from ..body.ellipsoid import Ellipsoid

Coordinates = tuple[float, float]
"""(east, north) of a place: degrees, or a map's metres."""


class Projection(Protocol):
    """A frozen dataclass whose fields, numbers and nothing else, are its parameters (degrees and metres)."""

    name: ClassVar[str]
    """As people know it."""
    in_degrees: ClassVar[bool]
    """Whether the map's own coordinates are degrees; they are metres otherwise."""

    def forward(self, longitude: float, latitude: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """The map's own coordinates of a place (degrees east, degrees north).

        ``None`` where the map does not show it.
        """

    def inverse(self, x: float, y: float, ellipsoid: Ellipsoid) -> Coordinates | None:
        """Degrees east (of any turn) and north of a place on the map; ``None`` where it shows no place."""

    def turn(self, ellipsoid: Ellipsoid) -> float | None:
        """How far east the map repeats itself, in its own coordinates; ``None`` where it does not."""
