"""How nested levels are connected: one surface."""

from __future__ import annotations

import numpy as np
import pytest

from addon.terrain.levels.level import Extent
from addon.terrain.levels.plan import Focus, plan_levels
from addon.terrain.levels.topology import topology
from tests.addon.level_grids import cells_of, layout, open_edges, walks


@pytest.mark.parametrize("seed", range(4))
def test_no_edge_is_open_inside(seed: int) -> None:
    for extent, _budget, plans in walks(seed, 20):
        for _focus, plan in plans:
            connected = topology(plan.levels)
            uses = np.bincount(connected.triangle_edges.ravel(), minlength=len(connected.edges))
            assert uses.min() >= 1
            assert uses.max() <= 2
            columns, rows = cells_of(plan.levels, connected)
            ends = open_edges(connected)
            sides = (columns == 0, columns == extent.last_column, rows == 0, rows == extent.last_row)
            assert np.any([side[ends].all(axis=1) for side in sides], axis=0).all()


@pytest.mark.parametrize("seed", range(4))
def test_triangles_face_up_and_cover_the_map_once(seed: int) -> None:
    for extent, _budget, plans in walks(seed, 20):
        for _focus, plan in plans:
            connected = topology(plan.levels)
            columns, rows = cells_of(plan.levels, connected)
            x, y = columns[connected.triangles], -rows[connected.triangles]
            doubled = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
            assert doubled.min() > 0
            assert doubled.sum() == 2 * extent.last_column * extent.last_row


@pytest.mark.parametrize("seed", range(4))
def test_each_sample_is_one_vertex_and_each_edge_joins_its_triangles_corners(seed: int) -> None:
    for extent, _budget, plans in walks(seed, 20):
        for _focus, plan in plans:
            connected = topology(plan.levels)
            columns, rows = cells_of(plan.levels, connected)
            assert len(np.unique(rows * (extent.last_column + 1) + columns)) == connected.vertices
            corners = np.stack((connected.triangles, np.roll(connected.triangles, -1, axis=1)), axis=-1)
            ends = connected.edges[connected.triangle_edges]
            assert (np.sort(corners, axis=-1) == np.sort(ends, axis=-1)).all()


def test_both_sides_of_the_seam_have_the_same_rows() -> None:
    extent = Extent.of(layout(720, 1440, wraps=True))
    for column in (0.0, 3.0, 40.0, 1400.0, 1439.5, 16.0, 1424.0):
        levels = plan_levels(extent, Focus(column, 300.0, 1.0), 20_000).levels
        connected = topology(levels)
        columns, rows = cells_of(levels, connected)
        assert set(rows[columns == 0]) == set(rows[columns == 1440])


def test_cells_are_split_as_touch_splits_them() -> None:
    levels = plan_levels(Extent.of(layout(513, 513)), Focus(100.0, 100.0, 1.0), 20_000).levels
    connected = topology(levels)
    columns, rows = cells_of(levels, connected)
    first, second = connected.edges.T
    across, down = columns[second] - columns[first], rows[second] - rows[first]
    slanted = (across != 0) & (down != 0)
    assert (np.sign(across) == np.sign(down))[slanted & (abs(across) == abs(down))].all()
    # Apart from those, only triangles beside a finer level have a slanted edge, twice as long one way.
    assert set(abs(across[slanted]) / abs(down[slanted])) <= {0.5, 1.0, 2.0}
    assert np.count_nonzero(slanted & (abs(across) != abs(down))) < 0.05 * np.count_nonzero(slanted)
