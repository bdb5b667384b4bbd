"""Where on its body a grid lies.

Samples are at cell centres, so column 0 is half a cell east of the westernmost longitude and row 0
half a cell south of the maximum latitude. Geometry comes from the resolution and the limits: the
``MAP_SCALE`` of planetary labels is rounded.
"""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Georeference:
    """The place of a simple cylindrical grid on its body."""

    body: str
    radius: float
    """Of the body's sphere, metres."""
    projection: str
    westernmost_longitude: float
    """Degrees east, at the outer edge of column 0's cell."""
    easternmost_longitude: float
    """Degrees east, more than ``westernmost_longitude`` and at most 360 degrees from it."""
    minimum_latitude: float
    """Degrees north, at the outer edge of the last row's cell."""
    maximum_latitude: float
    """Degrees north, at the outer edge of row 0's cell."""
    pixels_per_degree: float
    vertical_reference: str
    """What elevation 0 means."""
    vertical_unit: str = "m"

    @property
    def spans_the_globe(self) -> bool:
        """Whether the map has neither an east nor a west edge."""
        return math.isclose(self.easternmost_longitude - self.westernmost_longitude, 360.0)

    @property
    def cell_height(self) -> float:
        """Metres between neighbouring rows."""
        return math.pi * self.radius / (180.0 * self.pixels_per_degree)

    @property
    def cell_width(self) -> float:
        """Metres between neighbouring columns along the map's centre latitude."""
        centre = (self.minimum_latitude + self.maximum_latitude) / 2.0
        return self.cell_height * math.cos(math.radians(centre))

    def longitude(self, column: float) -> float:
        """Degrees east, 0 up to 360, of a column."""
        return (self.westernmost_longitude + (column + 0.5) / self.pixels_per_degree) % 360.0

    def latitude(self, row: float) -> float:
        """Degrees north of a row."""
        return self.maximum_latitude - (row + 0.5) / self.pixels_per_degree

    def longitude_latitude(self, east: float, north: float) -> tuple[float, float]:
        """Degrees east and north of a place in the terrain frame (metres from sample (0, 0))."""
        return self.longitude(east / self.cell_width), self.latitude(-north / self.cell_height)
