"""Grids that cost time to open, decoded or filled, kept open from import to touch."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, field

from proxygraph import Grid, Progress

from .filling import filled
from .kept import KeptTerrain

MOST_BYTES = 1 << 30
"""Of samples in memory that are kept for later; the newest grid is kept whatever its size."""


@dataclass
class OpenedGrids:
    """The grids that were opened last. Mapped ones are not kept: they open at once, and hold their file."""

    most_bytes: int = MOST_BYTES
    _grids: OrderedDict[str, Grid] = field(default_factory=OrderedDict)
    """By what they were made of, the longest unused first."""

    def __len__(self) -> int:
        return len(self._grids)

    def open(self, kept: KeptTerrain, progress: Progress | None = None) -> Grid:
        """Open a terrain's grid as it was imported, or give the one that is open.

        Raises:
            FormatError: the file was changed, or cannot be read.
            CancelledError: ``progress`` was asked to end.
        """
        if kept.stamp is not None:
            kept.stamp.check(kept.grid.data_path)
        key = _key(kept)
        grid = self._grids.get(key)
        if grid is None:
            grid = kept.grid.open(progress)
            if kept.filled:
                grid = filled(kept.grid, grid, progress)
            self.add(kept, grid)
        else:
            self._grids.move_to_end(key)
        return grid

    def add(self, kept: KeptTerrain, grid: Grid) -> None:
        """Keep a grid that was opened, and let go of what becomes too much."""
        if kept.grid.decoding is None and not kept.filled:
            return
        self._grids[_key(kept)] = grid
        self._grids.move_to_end(_key(kept))
        while len(self._grids) > 1 and self._bytes() > self.most_bytes:
            self._grids.popitem(last=False)

    def clear(self) -> None:
        """Let go of all."""
        self._grids.clear()

    def _bytes(self) -> int:
        return sum(grid.layout.byte_length for grid in self._grids.values())


def _key(kept: KeptTerrain) -> str:
    grid = kept.grid
    layout = grid.layout
    made_of = (str(grid.data_path), layout.rows, layout.columns, layout.offset, layout.row_stride)
    return repr((*made_of, layout.void, grid.decoding, kept.filled, kept.stamp))
