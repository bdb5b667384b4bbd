"""What the levels show: heights and slopes of the grid's own samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from proxygraph import Grid

from ..preview import PreviewCells, preview_surface
from ..slope import slopes
from .level import Level, Mask

Numbers = npt.NDArray[np.float64]


@dataclass(frozen=True)
class LevelSamples:
    """Of one level, rows x columns."""

    heights: Numbers
    """Metres, NaN where void."""
    slopes: Numbers
    """Degrees of the true ground."""
    filled: Mask | None
    """Whether the raw grid has a void there; ``None`` where nothing was filled."""


@dataclass
class SampleReader:
    """Reads levels, and keeps those that stay: most do, when the hand moves a little."""

    grid: Grid
    raw: Grid | None = None
    """The grid before its voids were filled; ``None`` where they were not."""
    _kept: dict[Level, LevelSamples] = field(default_factory=dict)

    def read(self, levels: Sequence[Level]) -> list[LevelSamples]:
        """Give the samples of each level."""
        self._kept = {level: self._kept.get(level) or self._read(level) for level in levels}
        return list(self._kept.values())

    def _read(self, level: Level) -> LevelSamples:
        cells = PreviewCells(tuple(level.column_lines.tolist()), tuple(level.row_lines.tolist()))
        surface = preview_surface(self.grid, cells)
        filled = None
        if self.raw is not None:
            filled = np.isnan(preview_surface(self.raw, cells).heights) & np.isfinite(surface.heights)
        return LevelSamples(surface.heights, slopes(self.grid, surface), filled)
