"""Which levels are shown."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest

from addon.terrain.levels.level import Extent
from addon.terrain.levels.plan import COMFORT, Focus, plan_levels
from addon.terrain.levels.topology import topology
from tests.addon.level_grids import layout, walks

PLANET = Extent.of(layout(5760, 11_520, wraps=True))


@pytest.mark.parametrize("seed", range(4))
def test_budget_is_never_exceeded(seed: int) -> None:
    for _extent, budget, plans in walks(seed, 25):
        for _focus, plan in plans:
            assert topology(plan.levels).vertices <= max(budget, 4)


def test_most_of_a_budget_is_used() -> None:
    for step in (1.0, 4.0, 16.0):
        plan = plan_levels(PLANET, Focus(5000.0, 3000.0, step), 250_000)
        assert plan.levels[0].step == step
        assert topology(plan.levels).vertices > 200_000


@pytest.mark.parametrize("seed", range(4))
def test_each_level_lies_inside_the_next_and_the_last_is_the_map(seed: int) -> None:
    for extent, _budget, plans in walks(seed, 25):
        for _focus, plan in plans:
            last = plan.levels[-1]
            assert last.columns == ((0, extent.last_column),)
            assert last.rows == (0, extent.last_row)
            for finer, coarser in pairwise(plan.levels):
                assert coarser.step == 2 * finer.step
                for column in (end for interval in finer.columns for end in interval):
                    for row in finer.rows:
                        assert coarser.covers(column, row)


@pytest.mark.parametrize("seed", range(4))
def test_the_place_is_in_the_finest_level(seed: int) -> None:
    for extent, _budget, plans in walks(seed, 25):
        for focus, plan in plans:
            column = focus.column % extent.last_column if extent.wraps else focus.column
            column = min(max(column, 0.0), float(extent.last_column))
            assert plan.levels[0].covers(column, min(max(focus.row, 0.0), float(extent.last_row)))


def test_finest_cells_are_as_fine_as_asked_or_the_grids_own() -> None:
    for cells, step in ((0.1, 1), (1.0, 1), (1.99, 1), (2.0, 2), (3.9, 2), (4.0, 4), (700.0, 512)):
        assert plan_levels(PLANET, Focus(100.0, 100.0, cells), 100_000).levels[0].step == step


def test_a_map_seen_from_very_far_is_its_corners() -> None:
    for cells in (1e6, 1e300, float("inf")):
        plan = plan_levels(PLANET, Focus(100.0, 100.0, cells), 100_000)
        assert topology(plan.levels).vertices <= 9


def test_small_budgets_make_the_finest_level_coarser() -> None:
    plan = plan_levels(PLANET, Focus(100.0, 100.0, 1.0), 2000)
    assert plan.levels[0].step > 1
    assert plan.levels[0].covers(100.0, 100.0)


def test_trembling_moves_nothing() -> None:
    focus = Focus(5000.3, 3000.8, 1.3)
    plan = plan_levels(PLANET, focus, 100_000)
    for column, row, cells in ((3.0, -2.0, 1.0), (-4.0, 5.0, 1.1), (0.4, 0.4, 0.95)):
        moved = Focus(focus.column + column, focus.row + row, focus.cells * cells)
        assert plan_levels(PLANET, moved, 100_000, plan).levels == plan.levels


def test_trembling_at_the_seam_moves_nothing() -> None:
    plan = plan_levels(PLANET, Focus(1.0, 3000.0, 1.0), 100_000)
    for column in (11_519.0, -1.0, 2.0, 11_521.0):
        assert plan_levels(PLANET, Focus(column, 3000.0, 1.0), 100_000, plan).levels == plan.levels


def test_far_levels_stay_when_the_hand_moves_a_little() -> None:
    plan = plan_levels(PLANET, Focus(5000.0, 3000.0, 1.0), 100_000)
    finest = plan.levels[0]
    across = finest.columns[0][1] - finest.columns[0][0]
    moved = plan_levels(PLANET, Focus(5000.0 + across / 6.0, 3000.0, 1.0), 100_000, plan)
    assert moved.levels[0] != plan.levels[0]
    assert moved.levels[1:] == plan.levels[1:]


def test_zooming_keeps_the_levels_that_stay() -> None:
    plan = plan_levels(PLANET, Focus(5000.0, 3000.0, 2.0), 100_000)
    nearer = plan_levels(PLANET, Focus(5000.0, 3000.0, 1.9), 100_000, plan)
    assert nearer.levels[0].step == 1
    assert {level.step: nearer.middles[level.step] for level in plan.levels} == plan.middles


def test_zooming_to_and_fro_is_quiet() -> None:
    plan = plan_levels(PLANET, Focus(5000.0, 3000.0, 3.9), 100_000)
    for cells in (4.1, 3.9, 4.3, 4.9):
        plan = plan_levels(PLANET, Focus(5000.0, 3000.0, cells), 100_000, plan)
        assert plan.levels[0].step == 2
    assert plan_levels(PLANET, Focus(5000.0, 3000.0, 4.1 / COMFORT), 100_000, plan).levels[0].step == 4


def test_levels_are_square_on_the_ground() -> None:
    narrow = replace(PLANET, tallness=2.0)  # cells half as wide as they are tall
    finest = plan_levels(narrow, Focus(5000.0, 3000.0, 1.0), 100_000).levels[0]
    (west, east), (north, south) = finest.columns[0], finest.rows
    assert (east - west) / (south - north) == pytest.approx(2.0, rel=0.1)
