"""The triangulated surface in the grid's own frame: columns, rows and metres."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from proxygraph import GridLayout

Place = tuple[float, float]
"""Fractional column and row; on a grid that wraps, columns may lie beyond either edge."""

ON_AN_EDGE = 1e-9
"""Cells: how near to an edge a place belongs to the triangles on either side."""


class Heights(Protocol):
    """What is needed of a ``proxygraph.Grid``."""

    @property
    def layout(self) -> GridLayout:
        """Size, and whether it wraps."""

    def elevation(self, column: int, row: int) -> float | None:
        """A sample in metres; ``None`` where it is void."""


@dataclass(frozen=True)
class TrianglePlane:
    """The plane through a triangle's corners."""

    column: int
    row: int
    """Of its cell's north-west sample."""
    corner: float
    """Metres, of that sample (every triangle has it)."""
    eastward: float
    southward: float
    """Metres from one column, or row, to the next."""

    def height(self, place: Place) -> float:
        """Metres; also beyond the triangle."""
        return self.corner + (place[0] - self.column) * self.eastward + (place[1] - self.row) * self.southward


def plane_under(grid: Heights, place: Place) -> TrianglePlane | None:
    """The triangle under a place; on an edge one that is present. ``None`` in a void and off the map."""
    return next((plane for plane in _planes_around(grid, place) if plane is not None), None)


def _planes_around(grid: Heights, place: Place) -> Iterator[TrianglePlane | None]:
    """The triangles that a place lies in or on, ``None`` for those that are absent."""
    for column in _cells_around(place[0]):
        for row in _cells_around(place[1]):
            # The diagonal runs from the north-west to the south-east sample.
            beyond_diagonal = (place[0] - column) - (place[1] - row)
            if beyond_diagonal >= -ON_AN_EDGE:
                yield _plane(grid, column, row, north_east=True)
            if beyond_diagonal <= ON_AN_EDGE:
                yield _plane(grid, column, row, north_east=False)


def _cells_around(coordinate: float) -> list[int]:
    """The cells, in one direction, that a coordinate lies in or on the border of."""
    low, high = math.floor(coordinate - ON_AN_EDGE), math.floor(coordinate + ON_AN_EDGE)
    return [high] if low == high else [high, low]


def _plane(grid: Heights, column: int, row: int, *, north_east: bool) -> TrianglePlane | None:
    """A triangle of a cell, if its three corners are there."""
    first = _sample(grid, column, row)
    last = _sample(grid, column + 1, row + 1)
    other = _sample(grid, column + 1, row) if north_east else _sample(grid, column, row + 1)
    if first is None or last is None or other is None:
        return None
    if north_east:
        return TrianglePlane(column, row, first, eastward=other - first, southward=last - other)
    return TrianglePlane(column, row, first, eastward=last - other, southward=other - first)


def _sample(grid: Heights, column: int, row: int) -> float | None:
    layout = grid.layout
    if layout.wraps:
        column %= layout.columns
    if not (0 <= column < layout.columns and 0 <= row < layout.rows):
        return None
    return grid.elevation(column, row)
