"""One level: the part of the grid that it covers, and the columns and rows that it takes there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from proxygraph import GridLayout

Lines = npt.NDArray[np.int64]
"""Columns or rows of the grid, rising."""

Mask = npt.NDArray[np.bool_]

Interval = tuple[int, int]
"""First and last column, or row."""


@dataclass(frozen=True)
class Extent:
    """What of a grid's layout says where columns and rows end, and what shape cells have."""

    last_column: int
    """On a map that wraps it is one more than the grid's last: column 0 again."""
    last_row: int
    wraps: bool
    tallness: float
    """Of a cell: its height by its width."""

    @staticmethod
    def of(layout: GridLayout) -> Extent:
        """Take it from a layout."""
        last_column = layout.columns if layout.wraps else layout.columns - 1
        return Extent(last_column, layout.rows - 1, layout.wraps, layout.cell_height / layout.cell_width)


@dataclass(frozen=True)
class Level:
    """Every ``step``-th column and row of a rectangle, its edges included.

    An edge is on the next coarser level's lines too (a multiple of ``2 * step``), or is the map's.
    """

    step: int
    """Cells of the grid, a power of two."""
    columns: tuple[Interval, ...]
    """One interval, or two where the rectangle goes across a wrapping map's seam, the western first."""
    rows: Interval

    @property
    def column_lines(self) -> Lines:
        """The columns; on a map that wraps the last one may be column 0 again, as in ``Extent``."""
        return np.concatenate([_lines(interval, self.step) for interval in self.columns])

    @property
    def row_lines(self) -> Lines:
        """The rows."""
        return _lines(self.rows, self.step)

    @property
    def gap(self) -> int | None:
        """Which pair of neighbouring columns has the rest of the map between it; ``None`` where none has."""
        return None if len(self.columns) == 1 else len(_lines(self.columns[0], self.step)) - 1

    def covers(self, column: float, row: float) -> bool:
        """Whether a place on the map is in the rectangle."""
        in_columns = any(first <= column <= last for first, last in self.columns)
        return in_columns and self.rows[0] <= row <= self.rows[1]

    def covers_cells(self, columns: Lines, rows: Lines) -> Mask:
        """Which cells between these columns and rows are in the rectangle, rows x columns."""
        across = np.zeros(len(columns) - 1, dtype=bool)
        for first, last in self.columns:
            across |= (columns[:-1] >= first) & (columns[1:] <= last)
        along = (rows[:-1] >= self.rows[0]) & (rows[1:] <= self.rows[1])
        return np.asarray(along[:, None] & across)


def _lines(interval: Interval, step: int) -> Lines:
    first, last = interval
    return np.append(np.arange(first, last, step, dtype=np.int64), np.int64(last))
