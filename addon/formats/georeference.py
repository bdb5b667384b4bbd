"""Where on its body a grid lies, as the doubles of its header.

A sample is a place: the centre of its cell where the file speaks of cells. Readers that find the corner
of a cell, or its outer limits, work out the centre; ``registration`` remembers what the file spoke of.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

from .body.ellipsoid import Ellipsoid
from .body.latitudes import planetographic_degrees, to_planetographic
from .projections import Coordinates, Projection
from .projections.map_scale import map_scale
from .region import Region

Registration = Literal["cells", "points"]
"""Whether the file gives a height for a whole cell (``cells``: its limits are half a cell beyond the outer
samples) or for a point (``points``: its limits are the outer samples)."""

LatitudeKind = Literal["planetocentric", "planetographic"]
"""Planetocentric: the angle at the body's centre; planetographic (on Earth "geodetic"): of the vertical."""


@dataclass(frozen=True)
class Georeference:
    """The place of a grid on its body."""

    body: str
    """``Mars``, ``Earth``, ``Moon`` ...; empty where the file does not say."""
    ellipsoid: Ellipsoid
    projection: Projection
    first_x: float
    """The map's own coordinate of column 0 (degrees east, or metres)."""
    first_y: float
    """The map's own coordinate of row 0 (degrees north, or metres)."""
    step_x: float
    """From one column to the next, above 0."""
    step_y: float
    """From one row to the next southward, above 0."""
    vertical_reference: str
    """What elevation 0 means: areoid, reference sphere, a datum's name."""
    vertical_unit: str = "m"
    """Of the samples in the file; elevations are given in metres whatever it is."""
    latitude_kind: LatitudeKind = "planetocentric"
    registration: Registration = "cells"
    frame: str = ""
    """Datum and coordinate system in the file's own words, where it has some."""

    def spans_the_globe(self, columns: int) -> bool:
        """Whether so many columns go once around: the map then has neither an east nor a west edge."""
        turn = self.projection.turn(self.ellipsoid)
        return turn is not None and math.isclose(columns * self.step_x, turn, rel_tol=1e-9)

    def closed(self, columns: int) -> Georeference:
        """The same, gone exactly once around where so many columns do, but for digits that a header lacks."""
        turn = self.projection.turn(self.ellipsoid)
        return self if turn is None else replace(self, step_x=step_once_around(self.step_x, columns, turn))

    def cell_size(self, rows: int, columns: int) -> tuple[float, float]:
        """Metres between neighbouring columns and between neighbouring rows.

        A degree of longitude shrinks toward the poles, and a map in metres may be far from true to scale
        (Mercator): taken at the middle of the map, so that slopes there are true.
        """
        if not self.projection.in_degrees:
            scale = map_scale(
                self.projection,
                self.ellipsoid,
                (self.x((columns - 1) / 2.0), self.y((rows - 1) / 2.0)),
            )
            return self.step_x / scale[0], self.step_y / scale[1]
        middle = self.first_y - (rows - 1) / 2.0 * self.step_y
        step_y = self.step_y
        if self.latitude_kind == "planetocentric" and not self.ellipsoid.is_sphere:
            step_y *= planetographic_degrees(middle, self.ellipsoid)
            middle = to_planetographic(middle, self.ellipsoid)
        return (
            self.step_x * self.ellipsoid.degree_of_longitude(middle),
            step_y * self.ellipsoid.degree_of_latitude(middle),
        )

    def x(self, column: float) -> float:
        """The map's own coordinate of a column: degrees east of any turn, or metres."""
        return self.first_x + column * self.step_x

    def y(self, row: float) -> float:
        """The map's own coordinate of a row: degrees north, or metres."""
        return self.first_y - row * self.step_y

    def longitude_latitude(self, column: float, row: float) -> Coordinates | None:
        """Degrees east, 0 up to 360, and north of a place in the grid; ``None`` where nobody can tell."""
        place = self.projection.inverse(self.x(column), self.y(row), self.ellipsoid)
        return None if place is None else (place[0] % 360.0, place[1])

    def column_row(self, longitude: float, latitude: float, columns: int) -> tuple[float, float] | None:
        """Fractional column and row of a place (degrees east of any turn, degrees north).

        ``None`` where the projection does not show it; else it may still lie beside the map.

        Args:
            columns: of the grid; the turn of longitude that is on or nearest to the map is meant.
        """
        place = self.projection.forward(longitude, latitude, self.ellipsoid)
        if place is None:
            return None
        x, y = place
        turn = self.projection.turn(self.ellipsoid)
        if turn is not None:
            middle = self.x((columns - 1) / 2.0)
            x = middle + (x - middle + turn / 2.0) % turn - turn / 2.0
        return (x - self.first_x) / self.step_x, (self.first_y - y) / self.step_y

    def cut(self, region: Region) -> Georeference:
        """The place of a region of the grid."""
        return replace(self, first_x=self.x(region.first_column), first_y=self.y(region.first_row))


def step_once_around(step: float, columns: int, turn: float = 360.0) -> float:
    """The step of a whole turn in so many columns, where the stated one misses that by less than half a step.

    A twelfth of a degree, as 0.0833333, leaves a gap at the seam that no header means.
    """
    return turn / columns if abs(columns * step - turn) < step / 2.0 else step
