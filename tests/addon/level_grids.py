"""Grids and levels for tests."""

from __future__ import annotations

import random
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
from proxygraph import Grid, GridLayout

from addon.terrain.levels.level import Extent, Level
from addon.terrain.levels.plan import Focus, Plan, plan_levels
from addon.terrain.levels.topology import Topology

SIZES = ((5760, 11_520), (720, 1440), (101, 97), (3601, 1801), (500, 7), (90, 361), (2, 2))
"""Rows and columns: powers of two times something, primes, tall and narrow, the smallest."""

Integers = npt.NDArray[np.int64]


def layout(rows: int, columns: int, *, wraps: bool = False, cell_width: float = 1000.0) -> GridLayout:
    """A layout of 16-bit samples."""
    return GridLayout(
        rows,
        columns,
        cell_width=cell_width,
        cell_height=1000.0,
        byte_order="little",
        void=-32768.0,
        wraps=wraps,
    )


def grid(heights: npt.NDArray[np.int16], *, wraps: bool = False) -> Grid:
    """A grid in memory; -32768 is void."""
    return Grid.from_buffer(heights.astype("<i2").tobytes(), layout(*heights.shape, wraps=wraps))


def hills(rows: int, columns: int, voids: float = 0.0) -> npt.NDArray[np.int16]:
    """Heights that differ everywhere; a share of them is void."""
    chance = np.random.default_rng(rows * columns)
    heights = chance.integers(-3000, 3000, (rows, columns)).astype(np.int16)
    heights[chance.random((rows, columns)) < voids] = -32768
    return heights


def walks(seed: int, walks: int, steps: int = 4) -> Iterator[tuple[Extent, int, list[tuple[Focus, Plan]]]]:
    """Random grids, budgets, and places that wander over them, with the plans along the way."""
    chance = random.Random(seed)
    for _ in range(walks):
        rows, columns = chance.choice(SIZES)
        shape = layout(
            rows, columns, wraps=chance.random() < 0.5, cell_width=chance.choice((500.0, 1000.0, 2000.0))
        )
        extent, budget = Extent.of(shape), chance.choice((3, 20, 3000, 10_000, 60_000))
        column, row = chance.uniform(-columns, 2 * columns), chance.uniform(-10, rows + 10)
        cells = 2.0 ** chance.uniform(-1, 7)
        plans: list[tuple[Focus, Plan]] = []
        for _ in range(steps):
            focus = Focus(column, row, cells)
            plans.append((focus, plan_levels(extent, focus, budget, plans[-1][1] if plans else None)))
            column, row = column + chance.gauss(0, 20 * cells), row + chance.gauss(0, 20 * cells)
            cells *= 2.0 ** chance.gauss(0, 0.3)
        yield extent, budget, plans


def cells_of(levels: tuple[Level, ...], connected: Topology) -> tuple[Integers, Integers]:
    """Column and row of each vertex."""
    owned = list(zip(levels, connected.own, strict=True))
    columns = [np.broadcast_to(level.column_lines, own.shape)[own] for level, own in owned]
    rows = [np.broadcast_to(level.row_lines[:, None], own.shape)[own] for level, own in owned]
    return np.concatenate(columns), np.concatenate(rows)


def open_edges(connected: Topology) -> Integers:
    """Vertices of the edges that have one triangle, edges x 2."""
    uses = np.bincount(connected.triangle_edges.ravel(), minlength=len(connected.edges))
    return np.asarray(connected.edges[uses == 1], dtype=np.int64)
