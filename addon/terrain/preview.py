"""The part of a grid that is shown: a regular subset of its columns and rows, never resampled."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from proxygraph import Grid, GridLayout

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

    def height_at(self, east: float, north: float) -> float | None:
        """Metres of the shown surface at a place on the map; ``None`` in a hole or off the map."""
        column, along = _cell(self.cells.columns, east / self.layout.cell_width)
        row, down = _cell(self.cells.rows, -north / self.layout.cell_height)
        if column is None or row is None:
            return None
        north_west = self.heights[row, column]
        south_east = self.heights[row + 1, column + 1]
        if along >= down:
            north_east = self.heights[row, column + 1]
            height = north_west + along * (north_east - north_west) + down * (south_east - north_east)
        else:
            south_west = self.heights[row + 1, column]
            height = north_west + down * (south_west - north_west) + along * (south_east - south_west)
        return float(height) if np.isfinite(height) else None


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


def _cell(kept: tuple[int, ...], place: float) -> tuple[int, float] | tuple[None, float]:
    """Find the cell of the subset around a fractional column or row, and the share of it (0 to 1)."""
    if not kept[0] <= place <= kept[-1]:
        return None, 0.0
    number = min(bisect_right(kept, place), len(kept) - 1) - 1
    first, last = kept[number], kept[number + 1]
    return number, (place - first) / (last - first)
