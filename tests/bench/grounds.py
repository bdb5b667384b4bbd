"""What the benches touch."""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from proxygraph import Grid, GridLayout

from addon.formats.megdr import read_megdr
from tests.bench.hand import Field
from tests.bench.oracle import Oracle

ROOT = Path(__file__).resolve().parents[2]
MOLA = ROOT.parent / "shared" / "data" / "mola" / "megt90n000cb.lbl"
SAMPLE = ROOT / "build" / "sample" / "sample.lbl"

NOISE_SIDE = 512
NOISE_CELL = 1000.0
"""Metres; unscaled, heights are even between 0 and one cell."""


@dataclass(frozen=True)
class Ground:
    """A grid, a part of it to wander over, and its name in tables and in figures."""

    title: str
    key: str
    grid: Grid
    heights: Sequence[float]
    """All samples in metres, row-major, for the oracle."""
    field: Field
    exaggerations: tuple[int, ...]

    def oracle(self, exaggeration: float) -> Oracle:
        """A judge for this ground."""
        layout, heights = self.grid.layout, self.heights
        columns, cells = layout.columns, exaggeration / layout.cell_width

        def sample(column: int, row: int) -> float:
            return cells * heights[row * columns + column % columns]

        return Oracle(sample, layout.cell_height / layout.cell_width)


def planet(label: Path | None) -> list[Ground]:
    """Mars as measured, and its canyon's walls; without a label, the synthetic sample alone.

    Args:
        label: of the MEGDR topography at 4 pixels per degree.
    """
    if label is None and not MOLA.is_file():
        sample = read_megdr(SAMPLE)
        return [whole(sample.title, "sample", sample.open())]
    grid = read_megdr(label or MOLA).open()
    if (grid.layout.rows, grid.layout.columns) != (720, 1440):
        raise SystemExit(f"{label}: found another grid, expected MEGDR topography at 4 pixels per degree")
    mars = whole("MOLA 4 px/degree", "mola", grid)
    # 280 to 308 E, 5 to 15 S.
    canyon = Field(west=1120.0, east=1232.0, north=380.0, south=420.0)
    return [mars, Ground("Valles Marineris", "valles", grid, mars.heights, canyon, (20,))]


def whole(title: str, key: str, grid: Grid) -> Ground:
    """All of a grid but its rims."""
    layout = grid.layout
    heights = list(grid.elevations(range(layout.columns), range(layout.rows)))
    rim = layout.rows / 12
    if layout.wraps:
        west, east = -math.inf, math.inf
    else:
        west, east = layout.columns / 12, layout.columns * 11 / 12
    return Ground(title, key, grid, heights, Field(west, east, rim, layout.rows - rim), (1, 20))


def white_noise() -> Ground:
    """Heights that know nothing of each other: the roughest ground there is."""
    chance = random.Random(20)
    samples = [chance.randrange(int(NOISE_CELL) + 1) for _ in range(NOISE_SIDE * NOISE_SIDE)]
    layout = GridLayout(NOISE_SIDE, NOISE_SIDE, cell_width=NOISE_CELL, cell_height=NOISE_CELL, wraps=True)
    grid = Grid.from_buffer(struct.pack(f">{len(samples)}h", *samples), layout)
    return whole("white noise", "noise", grid)
