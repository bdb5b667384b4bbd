"""Which levels are shown: fine around a place, each next one twice as coarse and twice as wide.

Levels lie on the grid's own columns and rows and move in steps of theirs, so that a sample that stays shown
stays where it is; and each waits until the place is well away from its middle, so that a trembling hand
moves nothing (F. Losasso and H. Hoppe, "Geometry clipmaps", SIGGRAPH 2004, has levels nested like that).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache

from .level import Extent, Interval, Level

LEAST_CELLS = 32
"""Across a level: with fewer, levels that wait for the hand would not lie inside each other any more."""

CELLS_STEP = 8
"""Cells across a level are a multiple of it: its edges are on the next level's lines on either side."""

STRAY = 8
"""A level moves when the place is a share of 1 / STRAY of its width away from its middle."""

SEAM_LINES = 4
"""More lines that a level may have where it goes across the seam: its ends are rounded outward there."""

LEAST_VERTICES = 4
"""The corners of the map."""

COMFORT = 0.8
"""A coarser finest level must be fine enough by so much before it is taken: zooming to and fro is quiet."""


@dataclass(frozen=True)
class Focus:
    """What the eye needs."""

    column: float
    row: float
    """Where, on the map."""
    cells: float
    """How many cells of the grid the finest level's may be wide."""


@dataclass(frozen=True)
class Plan:
    """Levels from the finest to the whole map."""

    levels: tuple[Level, ...]
    middles: dict[int, tuple[int, int]] = field(compare=False)
    """Column and row that each level is laid around, by its step; the last level is the whole map."""


def plan_levels(extent: Extent, focus: Focus, budget: int, previous: Plan | None = None) -> Plan:
    """Choose the levels.

    Args:
        budget: vertices that are never exceeded, unless there are fewer than the map has corners.
        previous: what is shown now, of which as much as can be stays.
    """
    last_column, last_row = extent.last_column, extent.last_row
    cells = min(focus.cells, float(max(last_column, last_row)))
    step = _finest_step(cells, None if previous is None else previous.levels[0].step)
    size = _size(extent, step, budget)
    column = focus.column % last_column if extent.wraps else min(max(focus.column, 0.0), last_column)
    row = min(max(focus.row, 0.0), last_row)
    levels: list[Level] = []
    middles: dict[int, tuple[int, int]] = {}
    for step, (across, along) in size.levels:
        before = None if previous is None else previous.middles.get(step)
        turn = last_column if extent.wraps else None
        middle = (
            _middle(column, step, across, None if before is None else before[0], turn),
            _middle(row, step, along, None if before is None else before[1], None),
        )
        middles[step] = middle
        columns = _across(middle[0], across, step, last_column, wraps=extent.wraps)
        levels.append(Level(step, columns, _within(middle[1], along, step, last_row)))
    return Plan(tuple(levels), middles)


@dataclass(frozen=True)
class _Size:
    """How many cells each level has across and along, by its step, from the finest to the whole map."""

    levels: tuple[tuple[int, tuple[int, int]], ...]
    vertices: int
    """At most, wherever the levels lie."""


def _finest_step(cells: float, before: int | None) -> int:
    """The largest power of two that is fine enough; a coarser one than before only where it is so by far."""
    step = 1
    while 2 * step <= cells * (COMFORT if before is not None and step >= before else 1.0):
        step *= 2
    return step


@lru_cache(maxsize=64)
def _size(extent: Extent, step: int, budget: int) -> _Size:
    """The widest levels that the budget allows, and a coarser finest one where it allows none."""
    while True:
        most = _cells_of_map(extent, step)
        cells = most
        while cells >= LEAST_CELLS:
            size = _sized(extent, step, cells)
            if size.vertices <= max(budget, LEAST_VERTICES):
                return size
            cells -= CELLS_STEP
        step *= 2


def _cells_of_map(extent: Extent, step: int) -> int:
    """Cells across a square level (on the ground) that covers the map."""
    last_column, last_row = extent.last_column, extent.last_row
    wanted = max(last_column, last_row * extent.tallness) / step
    return max(_rounded_up(int(wanted) + 1, CELLS_STEP), LEAST_CELLS)


def _sized(extent: Extent, step: int, across: int) -> _Size:
    """Levels of so many cells across, as many as it takes to the whole map."""
    along = max(_rounded_up(round(across / extent.tallness), CELLS_STEP), LEAST_CELLS)
    last_column, last_row = extent.last_column, extent.last_row
    levels = []
    vertices = 0
    holes = 0, 0
    while True:
        levels.append((step, (across, along)))
        wide, tall = across * step >= last_column, along * step >= last_row
        lines = (
            -(-last_column // step) + 1 if wide else across + 1 + (SEAM_LINES if extent.wraps else 0),
            -(-last_row // step) + 1 if tall else along + 1,
        )
        vertices += lines[0] * lines[1] - holes[0] * holes[1]
        if wide and tall:
            return _Size(tuple(levels), vertices)
        # What the next level leaves out: less where it stays while the map's edge cuts this one.
        next_wide, next_tall = 2 * across * step >= last_column, 2 * along * step >= last_row
        holes = (
            _hole(-(-last_column // (2 * step)) if wide else None, across, cut=next_wide),
            _hole(-(-last_row // (2 * step)) if tall else None, along, cut=next_tall),
        )
        step *= 2


def _hole(whole: int | None, cells: int, *, cut: bool) -> int:
    """Lines that the next level leaves out at least: those strictly inside this one, or up to the map's edge.

    Args:
        whole: cells of the next level from edge to edge of the map where this level covers that.
        cut: whether the next level covers the map, and this one may lie half beside it.
    """
    if whole is not None:
        return whole - 1
    return cells // 4 - 2 if cut else cells // 2 - 1


def _middle(place: float, step: int, cells: int, before: int | None, turn: int | None) -> int:
    """Where a level lies along one axis: as before, or on its lines around the place."""
    if before is not None:
        away = place - before
        if turn is not None:
            away = (away + turn / 2.0) % turn - turn / 2.0
        if abs(away) <= cells // STRAY * step:
            return before
    return round(place / (2 * step)) * 2 * step


def _within(middle: int, cells: int, step: int, last: int) -> Interval:
    """The level's extent along an axis with ends."""
    if cells * step >= last:
        return 0, last
    half = cells // 2 * step
    return max(middle - half, 0), min(middle + half, last)


def _across(middle: int, cells: int, step: int, last: int, *, wraps: bool) -> tuple[Interval, ...]:
    """The level's columns; ``last`` is column 0 again where the map wraps."""
    if not wraps or cells * step >= last:
        return (_within(middle, cells, step, last),)
    first, end = middle - cells // 2 * step, middle + cells // 2 * step
    coarser = 2 * step
    # One that ends at the seam goes a little beyond: on a globe both sides of it need the same rows.
    if first <= 0:
        west, east = end, (last + min(first, -1)) // coarser * coarser
    elif end >= last:
        west, east = _rounded_up(max(end - last, 1), coarser), first
    else:
        return ((first, end),)
    return ((0, west), (east, last)) if west < east else ((0, last),)


def _rounded_up(number: int, multiple: int) -> int:
    return -(-number // multiple) * multiple
