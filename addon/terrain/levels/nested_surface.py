"""How high the shown surface is at a place: what is shown coarsely may lie above the ground that is felt."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from proxygraph import GridLayout

from .level import Level, Lines
from .samples import LevelSamples

Corner = tuple[float, float, float]
"""Column, row and height."""


@dataclass(frozen=True)
class NestedSurface:
    """Levels as they are shown, in the terrain frame."""

    layout: GridLayout
    levels: tuple[Level, ...]
    samples: tuple[LevelSamples, ...]

    def height_at(self, east: float, north: float) -> float | None:
        """Metres of the shown surface at a place on the map; ``None`` in a hole or off the map."""
        column, row = east / self.layout.cell_width, -north / self.layout.cell_height
        for number, level in enumerate(self.levels):
            if level.covers(column, row):
                return self._height_in(number, column, row)
        return None

    def _height_in(self, number: int, column: float, row: float) -> float | None:
        """The height in the cell of a level, whose sides the next finer one may split."""
        level, heights = self.levels[number], self.samples[number].heights
        columns, rows = level.column_lines, level.row_lines
        west, east = _cell(columns, column)
        north, south = _cell(rows, row)

        def corner(at_row: int, at_column: int) -> Corner:
            return float(columns[at_column]), float(rows[at_row]), float(heights[at_row, at_column])

        north_west, south_east = corner(north, west), corner(south, east)
        along = (column - north_west[0]) / (south_east[0] - north_west[0])
        down = (row - north_west[1]) / (south_east[1] - north_west[1])
        if along >= down:
            triangle = (north_west, south_east, corner(north, east))
        else:
            triangle = (south_east, north_west, corner(south, west))
        return self._height_on(number, triangle, column, row)

    def _height_on(
        self, number: int, triangle: tuple[Corner, Corner, Corner], column: float, row: float
    ) -> float | None:
        """The height on a triangle, or on that half of it which has the place."""
        first, second, third = triangle
        if number > 0:
            # Both sides beside the diagonal end in the third corner; at most one of them is split.
            for tip, end in ((first, second), (second, first)):
                middle = self._middle(number - 1, end, third)
                if middle is not None:
                    halves = ((tip, end, middle), (tip, middle, third))
                    shares = [_shares(half, column, row) for half in halves]
                    best = 0 if min(shares[0]) >= min(shares[1]) else 1
                    return _mixed(halves[best], shares[best])
        return _mixed(triangle, _shares(triangle, column, row))

    def _middle(self, number: int, start: Corner, end: Corner) -> Corner | None:
        """The finer level's sample between two corners of one side of a cell, where it has one."""
        level, heights = self.levels[number], self.samples[number].heights
        if not (level.covers(start[0], start[1]) and level.covers(end[0], end[1])):
            return None
        columns, rows = level.column_lines, level.row_lines
        at = [int(place) for place in np.searchsorted(columns, (start[0], end[0]))]
        down = [int(place) for place in np.searchsorted(rows, (start[1], end[1]))]
        if abs(at[1] - at[0]) + abs(down[1] - down[0]) != 2:
            return None
        column, row = sum(at) // 2, sum(down) // 2
        return float(columns[column]), float(rows[row]), float(heights[row, column])


def _cell(lines: Lines, place: float) -> tuple[int, int]:
    """Numbers of the lines before and after a place."""
    before = min(max(int(np.searchsorted(lines, place, side="right")) - 1, 0), len(lines) - 2)
    return before, before + 1


def _shares(triangle: tuple[Corner, Corner, Corner], column: float, row: float) -> tuple[float, float, float]:
    """Barycentric coordinates of a place; the smallest is below 0 outside."""
    (x0, y0, _), (x1, y1, _), (x2, y2, _) = triangle
    area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    second = ((column - x0) * (y2 - y0) - (x2 - x0) * (row - y0)) / area
    third = ((x1 - x0) * (row - y0) - (column - x0) * (y1 - y0)) / area
    return 1.0 - second - third, second, third


def _mixed(triangle: tuple[Corner, Corner, Corner], shares: tuple[float, float, float]) -> float | None:
    height = sum(share * corner[2] for share, corner in zip(shares, triangle, strict=True))
    return height if math.isfinite(height) else None
