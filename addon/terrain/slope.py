"""How steep the ground is at the shown samples: of the true heights, at exaggeration 1."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from proxygraph import Grid

from .preview import PreviewSurface

Numbers = npt.NDArray[np.float64]


def slopes(grid: Grid, surface: PreviewSurface) -> Numbers:
    """Degrees from the horizontal at each shown sample, from its neighbours in the whole grid.

    Beside a void or the map's edge it is the slope toward the other side; 0 where no side has a neighbour.

    Returns:
        Rows x columns.
    """
    layout, columns, rows = surface.layout, surface.cells.columns, surface.cells.rows
    west = _neighbours(columns, -1, layout.columns, wraps=layout.wraps)
    east = _neighbours(columns, 1, layout.columns, wraps=layout.wraps)
    north = _neighbours(rows, -1, layout.rows, wraps=False)
    south = _neighbours(rows, 1, layout.rows, wraps=False)
    across = _rise(
        surface.heights,
        np.where(east.missing, np.nan, _heights(grid, east.lines, rows)),
        np.where(west.missing, np.nan, _heights(grid, west.lines, rows)),
        layout.cell_width,
    )
    along = _rise(
        surface.heights,
        np.where(north.missing[:, None], np.nan, _heights(grid, columns, north.lines)),
        np.where(south.missing[:, None], np.nan, _heights(grid, columns, south.lines)),
        layout.cell_height,
    )
    return np.asarray(np.degrees(np.arctan(np.hypot(across, along))))


@dataclass(frozen=True)
class _Neighbours:
    """Columns or rows beside the shown ones."""

    lines: tuple[int, ...]
    missing: npt.NDArray[np.bool_]
    """Whether there is none, beyond the edge; the line is then the shown one itself."""


def _neighbours(lines: tuple[int, ...], step: int, count: int, *, wraps: bool) -> _Neighbours:
    beside = [line + step for line in lines]
    if wraps:
        return _Neighbours(tuple(line % count for line in beside), np.zeros(len(lines), dtype=bool))
    inside = [min(max(line, 0), count - 1) for line in beside]
    return _Neighbours(tuple(inside), np.array(inside) != np.array(beside))


def _heights(grid: Grid, columns: tuple[int, ...], rows: tuple[int, ...]) -> Numbers:
    heights = np.asarray(grid.elevations(columns, rows), dtype=np.float64)
    return heights.reshape(len(rows), len(columns))


def _rise(here: Numbers, after: Numbers, before: Numbers, cell: float) -> Numbers:
    """Metres upward a metre of the way: over both neighbouring cells, or the one that has heights."""
    onward, up_to = after - here, here - before
    total = np.nan_to_num(onward, nan=0.0) + np.nan_to_num(up_to, nan=0.0)
    sides = np.isfinite(onward).astype(float) + np.isfinite(up_to)
    return np.asarray(total / (cell * np.maximum(sides, 1.0)))
