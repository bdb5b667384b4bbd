"""Voids filled from their surroundings, where a person wants that."""

from __future__ import annotations

from proxygraph import Grid, Progress

CAN_FILL = hasattr(Grid, "filled")
"""Whether this build of the native module fills voids."""


def filled_grid(grid: Grid, progress: Progress | None = None) -> Grid:
    """A grid whose voids have heights; where it cannot be had, the grid with its voids.

    Raises:
        CancelledError: ``progress`` was asked to end.
    """
    fill = getattr(grid, "filled", None)
    if fill is None:
        return grid
    filled: Grid = fill(progress)
    return filled
