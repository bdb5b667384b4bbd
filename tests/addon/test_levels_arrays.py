"""What a mesh of nested levels is made of."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from proxygraph import Grid

from addon.terrain.bend import Bend
from addon.terrain.frame import TerrainFrame, terrain_frame
from addon.terrain.levels.level import Extent
from addon.terrain.levels.mesh_arrays import MeshArrays, mesh_arrays
from addon.terrain.levels.plan import Focus, Plan, plan_levels
from addon.terrain.levels.samples import SampleReader
from addon.terrain.levels.standing import FOLDED, Room, filling
from addon.terrain.levels.topology import topology
from tests.addon.level_grids import cells_of, grid, hills, layout


def frame(shape: tuple[int, int], *, wraps: bool = False) -> TerrainFrame:
    return terrain_frame(
        layout(*shape, wraps=wraps), -3000.0, 3000.0, units_per_metre=0.001, exaggeration=2.0
    )


def made(
    heights: npt.NDArray[np.int16], focus: Focus, budget: int, *, wraps: bool = False, raw: Grid | None = None
) -> tuple[Plan, MeshArrays]:
    shape: Any = heights.shape
    extent = Extent.of(layout(*shape, wraps=wraps))
    plan = plan_levels(extent, focus, budget)
    reader = SampleReader(grid(heights, wraps=wraps), raw)
    return plan, mesh_arrays(plan.levels, reader, frame(shape, wraps=wraps), layout(*shape, wraps=wraps))


def cells(arrays: MeshArrays, shape: tuple[int, int], *, wraps: bool = False) -> npt.NDArray[np.int64]:
    """Column and row of each vertex."""
    origin = frame(shape, wraps=wraps)
    columns = (arrays.positions[:, 0] / 0.001 + origin.east) / 1000.0
    rows = -(arrays.positions[:, 1] / 0.001 + origin.north) / 1000.0
    return np.asarray(np.round(np.stack((columns, rows), axis=-1)), dtype=np.int64)


@pytest.mark.parametrize("wraps", [False, True])
@pytest.mark.parametrize("voids", [0.0, 0.02])
def test_each_vertex_has_the_height_of_its_sample(wraps: bool, voids: float) -> None:
    heights = hills(300, 480, voids)
    _plan, arrays = made(heights, Focus(470.0, 40.0, 1.0), 9000, wraps=wraps)
    columns, rows = cells(arrays, (300, 480), wraps=wraps).T
    expected = heights[rows, columns % 480]
    assert (expected != -32768).all()
    assert (arrays.elevations == expected).all()
    assert arrays.positions[:, 2] == pytest.approx(expected * 0.002, abs=1e-5)


def test_slopes_are_those_of_the_true_ground() -> None:
    heights = np.tile(np.arange(200, dtype=np.int16) * 100, (200, 1))
    _plan, arrays = made(heights, Focus(50.0, 50.0, 1.0), 4000)
    assert arrays.slopes == pytest.approx(math.degrees(math.atan(0.1)))


def test_only_voids_open_the_surface() -> None:
    heights = hills(300, 480, 0.01)
    plan, arrays = made(heights, Focus(200.0, 100.0, 1.0), 9000)
    connected = topology(plan.levels)
    assert 0 < len(arrays.triangles) < len(connected.triangles)
    uses = np.bincount(arrays.triangle_edges.ravel(), minlength=len(arrays.edges))
    assert uses.min() >= 1
    assert set(arrays.triangles.ravel()) == set(range(len(arrays.positions)))
    # An edge is open at the map's edge, or where the third corner of the missing triangle is void.
    whole = {tuple(cell) for cell in cells(arrays, (300, 480)).tolist()}
    missing = {tuple(cell) for cell in np.argwhere(heights.T == -32768).tolist()}
    _without, complete = made(hills(300, 480), Focus(200.0, 100.0, 1.0), 9000)
    every = cells(complete, (300, 480))
    assert {tuple(cell) for cell in every.tolist()} - missing >= whole
    spoiled = np.array([tuple(cell) in missing for cell in every.tolist()])
    assert len(arrays.triangles) == np.count_nonzero(~spoiled[complete.triangles].any(axis=1))


def test_heights_are_told_as_they_are_shown() -> None:
    heights = hills(300, 480, 0.01)
    _plan, arrays = made(heights, Focus(200.0, 100.0, 1.0), 5000)
    at = cells(arrays, (300, 480)).astype(float)
    chance = np.random.default_rng(1)
    for triangle in arrays.triangles[chance.choice(len(arrays.triangles), 1500, replace=False)]:
        shares = chance.dirichlet((1.0, 1.0, 1.0))
        column, row = shares @ at[triangle]
        told = arrays.surface.height_at(column * 1000.0, row * -1000.0)
        assert told == pytest.approx(float(shares @ arrays.elevations[triangle]), abs=1e-6)


def test_there_is_no_height_in_holes_and_beside_the_map() -> None:
    heights = hills(100, 100)
    heights[40:60, 40:60] = -32768
    _plan, arrays = made(heights, Focus(50.0, 50.0, 1.0), 20_000)
    assert arrays.surface.height_at(50_500.0, -50_500.0) is None
    assert arrays.surface.height_at(-1.0, -50_500.0) is None
    assert arrays.surface.height_at(30_500.0, -99_001.0) is None
    assert arrays.surface.height_at(99_000.0, -99_000.0) == pytest.approx(float(heights[99, 99]))


def test_a_grid_of_voids_shows_nothing() -> None:
    heights = np.full((100, 100), -32768, dtype=np.int16)
    _plan, arrays = made(heights, Focus(50.0, 50.0, 1.0), 2000)
    assert len(arrays.triangles) == len(arrays.positions) == len(arrays.edges) == 0
    assert np.isfinite(filling(arrays, {}, Room(2500)).positions).all()


def test_what_was_filled_is_told() -> None:
    holes = hills(120, 120, 0.05)
    filled = np.where(holes == -32768, np.int16(7), holes)
    _plan, arrays = made(filled, Focus(50.0, 50.0, 1.0), 20_000, raw=grid(holes))
    columns, rows = cells(arrays, (120, 120)).T
    assert arrays.filled is not None
    assert (arrays.filled == (holes[rows, columns] == -32768)).all()


def a_little_further() -> tuple[Plan, Plan]:
    """Two plans of a grid of 700 x 1400 of which only the finest level differs."""
    extent = Extent.of(layout(700, 1400))
    plan = plan_levels(extent, Focus(600.0, 300.0, 1.0), 12_000)
    (west, east), *_others = plan.levels[0].columns
    moved = plan_levels(extent, Focus(600.0 + (east - west) / 6.0, 300.0, 1.0), 12_000, plan)
    assert moved.levels[0] != plan.levels[0]
    return plan, moved


def test_far_vertices_stay_where_they_are() -> None:
    reader = SampleReader(grid(hills(700, 1400)))

    def far(plan: Plan) -> set[tuple[float, ...]]:
        arrays = mesh_arrays(plan.levels, reader, frame((700, 1400)), layout(700, 1400))
        columns, rows = cells(arrays, (700, 1400)).T
        is_far = (abs(columns - 600) > 60) | (abs(rows - 300) > 60)
        return {tuple(place) for place in arrays.positions[is_far].tolist()}

    plan, moved = a_little_further()
    assert len(far(plan)) > 3000
    assert far(plan) == far(moved)


def test_levels_that_stay_are_not_read_again() -> None:
    reader = SampleReader(grid(hills(700, 1400)))
    plan, moved = a_little_further()
    before, after = reader.read(plan.levels), reader.read(moved.levels)
    assert before[0] is not after[0]
    assert all(one is other for one, other in zip(before[1:], after[1:], strict=True))


def test_a_filled_mesh_has_one_size_and_folds_what_is_left() -> None:
    room = Room(20_000)
    _plan, arrays = made(hills(700, 1400), Focus(600.0, 300.0, 1.0), room.budget)
    filled = filling(arrays, {"elevation": arrays.elevations}, room)
    assert len(filled.positions) == len(filled.numbers["elevation"]) == room.most_vertices
    assert (len(filled.edges), len(filled.triangles)) == (room.edges, room.triangles)
    assert (filled.triangles[: filled.used] == arrays.triangles).all()
    folded = filled.triangles[filled.used :]
    assert folded.min() >= room.vertices - FOLDED > len(arrays.positions) - 1
    assert (filled.positions[folded] == filled.positions[0]).all()
    corners = np.stack((filled.triangles, np.roll(filled.triangles, -1, axis=1)), axis=-1)
    assert (np.sort(corners, axis=-1) == np.sort(filled.edges[filled.triangle_edges], axis=-1)).all()


def test_a_globe_is_closed_at_its_seam() -> None:
    shape = layout(180, 360, wraps=True)
    radius = 360.0 * 1000.0 / (2.0 * math.pi)
    globe = replace(frame((180, 360), wraps=True), bend=Bend(radius, 0.0, radius))
    plan = plan_levels(Extent.of(shape), Focus(3.0, 80.0, 1.0), 3000)
    reader = SampleReader(grid(hills(180, 360), wraps=True))
    arrays = mesh_arrays(plan.levels, reader, globe, shape)
    columns, rows = cells_of(plan.levels, topology(plan.levels))
    west, east = np.flatnonzero(columns == 0), np.flatnonzero(columns == 360)
    west, east = west[np.argsort(rows[west])], east[np.argsort(rows[east])]
    assert len(west) > 30
    assert (rows[west] == rows[east]).all()
    assert arrays.positions[west] == pytest.approx(arrays.positions[east], abs=1e-4)
