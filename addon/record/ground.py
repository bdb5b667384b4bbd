"""What must not bury a take: the ground as it is, and as it is shown."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from proxygraph import Grid

from ..terrain.kept import KeptTerrain
from ..terrain.preview import PreviewSurface, preview_cells, preview_surface
from .take_data import Numbers


@dataclass(frozen=True)
class Ground:
    """A grid, and the samples of it that are shown."""

    grid: Grid
    surface: PreviewSurface

    @staticmethod
    def of(grid: Grid, kept: KeptTerrain) -> Ground:
        """Read the samples that a terrain shows."""
        return Ground(grid, preview_surface(grid, preview_cells(grid.layout, kept.vertex_budget)))

    def real(self, east: Numbers, north: Numbers) -> Numbers:
        """Elevations of the whole grid, metres, at terrain metres on the map; NaN in holes and beside it."""
        found = map(self.grid.elevation_at, east.tolist(), north.tolist())
        return np.fromiter((math.nan if height is None else height for height in found), float, len(east))

    def highest(self, east: Numbers, north: Numbers) -> Numbers:
        """The higher of what is shown and what is there; NaN where there is neither."""
        return np.asarray(np.fmax(self.surface.heights_at(east, north), self.real(east, north)))
