"""The part of a grid that is shown: a regular subset of its columns and rows, never resampled."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from proxygraph import Grid, GridLayout

Numbers = npt.NDArray[np.float64]

VERTEX_BUDGET = 250_000
"""Vertices that any machine draws smoothly."""


@dataclass(frozen=True)
class PreviewCells:
    """Which samples are shown. On a grid that wraps the last column is column 0 again: the map closes."""

    columns: tuple[int, ...]
    rows: tuple[int, ...]

    @property
    def vertices(self) -> int:
        """How many, voids included."""
        return len(self.columns) * len(self.rows)


@dataclass(frozen=True)
class PreviewSurface:
    """The shown samples and the triangles between them, in the terrain frame."""

    cells: PreviewCells
    layout: GridLayout
    heights: npt.NDArray[np.float64]
    """Metres, rows x columns, NaN where void."""
    filled: npt.NDArray[np.bool_] | None = None
    """Whether a height was filled in, rows x columns; ``None`` where nothing was."""

    def height_at(self, east: float, north: float) -> float | None:
        """Metres of the shown surface at a place on the map; ``None`` in a hole or off the map.

        In plain numbers: the timer asks at every tick, and arrays of one would take half of its time.
        """
        across = _cell(self.cells.columns, east / self.layout.cell_width)
        downward = _cell(self.cells.rows, -north / self.layout.cell_height)
        if across is None or downward is None:
            return None
        (column, along), (row, down) = across, downward
        north_west, south_east = self.heights[row, column], self.heights[row + 1, column + 1]
        if along >= down:
            corner, first, second = self.heights[row, column + 1], along, down
        else:
            corner, first, second = self.heights[row + 1, column], down, along
        height = float(north_west + first * (corner - north_west) + second * (south_east - corner))
        return height if math.isfinite(height) else None

    def heights_at(self, east: Numbers, north: Numbers) -> Numbers:
        """Metres of the shown surface at places on the map; NaN in holes and off the map."""
        column, along = _cells(self.cells.columns, east / self.layout.cell_width)
        row, down = _cells(self.cells.rows, -north / self.layout.cell_height)
        north_west = self.heights[row, column]
        south_east = self.heights[row + 1, column + 1]
        over_north = along >= down
        # The third corner: north-east of the diagonal, or south-west of it.
        corner = self.heights[np.where(over_north, row, row + 1), np.where(over_north, column + 1, column)]
        first, second = np.where(over_north, along, down), np.where(over_north, down, along)
        return np.asarray(north_west + first * (corner - north_west) + second * (south_east - corner))


def preview_cells(layout: GridLayout, budget: int = VERTEX_BUDGET) -> PreviewCells:
    """Choose the most samples that the budget allows, first and last rows and columns among them."""
    last_column = layout.columns if layout.wraps else layout.columns - 1
    last_row = layout.rows - 1
    across, down = _steps(last_column, last_row, budget)
    return PreviewCells(_every(across, last_column), _every(down, last_row))


def preview_surface(grid: Grid, cells: PreviewCells) -> PreviewSurface:
    """Read the shown samples."""
    heights = np.asarray(grid.elevations(cells.columns, cells.rows), dtype=np.float64)
    return PreviewSurface(cells, grid.layout, heights.reshape(len(cells.rows), len(cells.columns)))


def with_filled(surface: PreviewSurface, raw: Grid) -> PreviewSurface:
    """Mark the heights that a grid did not have before its voids were filled."""
    before = preview_surface(raw, surface.cells).heights
    return replace(surface, filled=np.isnan(before) & np.isfinite(surface.heights))


def preview_triangles(heights: npt.NDArray[np.float64]) -> npt.NDArray[np.int32]:
    """Vertex numbers (row-major) of each triangle, counter-clockwise from above.

    Each cell is split as touch splits it, from north-west to south-east; a triangle with a void
    corner is absent.
    """
    rows, columns = heights.shape
    numbers = np.arange(rows * columns, dtype=np.int32).reshape(rows, columns)
    north_west, north_east = numbers[:-1, :-1], numbers[:-1, 1:]
    south_west, south_east = numbers[1:, :-1], numbers[1:, 1:]
    south = np.stack((north_west, south_west, south_east), axis=-1)
    north = np.stack((north_west, south_east, north_east), axis=-1)
    triangles = np.stack((south, north), axis=2).reshape(-1, 3)
    whole: npt.NDArray[np.int32] = triangles[np.isfinite(heights).ravel()[triangles].all(axis=1)]
    return whole


def _steps(last_column: int, last_row: int, budget: int) -> tuple[int, int]:
    """Find the smallest steps along and across that fit; they differ by one at most."""
    step = 1
    while True:
        choices = [(step, step), (step + 1, step), (step, step + 1)]
        fitting = [choice for choice in choices if _vertices(last_column, last_row, choice) <= budget]
        if fitting or step > max(last_column, last_row):
            return max(fitting or choices, key=lambda choice: _vertices(last_column, last_row, choice))
        step += 1


def _vertices(last_column: int, last_row: int, steps: tuple[int, int]) -> int:
    return len(_every(steps[0], last_column)) * len(_every(steps[1], last_row))


def _every(step: int, last: int) -> tuple[int, ...]:
    return (*range(0, last, step), last)


def _cell(kept: tuple[int, ...], place: float) -> tuple[int, float] | None:
    """Find the cell of the subset around a fractional column or row, and the share of it; ``None`` beside."""
    if not kept[0] <= place <= kept[-1]:
        return None
    number = min(bisect_right(kept, place) - 1, len(kept) - 2)
    return number, (place - kept[number]) / (kept[number + 1] - kept[number])


def _cells(kept: tuple[int, ...], places: Numbers) -> tuple[npt.NDArray[np.intp], Numbers]:
    """Find the cells of the subset around fractional columns or rows, and the shares of them; NaN beside."""
    lines = np.array(kept)
    numbers = np.clip(np.searchsorted(lines, places, side="right") - 1, 0, len(kept) - 2)
    shares = (places - lines[numbers]) / (lines[numbers + 1] - lines[numbers])
    return numbers, np.where((places >= kept[0]) & (places <= kept[-1]), shares, np.nan)
