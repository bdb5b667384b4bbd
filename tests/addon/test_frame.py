"""Between metres and Blender units, and what lies under the preview."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from proxygraph import GridLayout

from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough


@pytest.mark.parametrize("pair", [MegdrPair(rough(9, 13)), planet()])
def test_the_scene_leads_back_to_the_terrain(pair: MegdrPair, tmp_path: Path) -> None:
    terrain = import_grid(pair.write(tmp_path))
    terrain.location = (3.0, -2.0, 1.0)
    terrain.rotation_euler.z = 0.7
    terrain.scale = (2.0, 2.0, 5.0)
    _update()
    kept = module("terrain.kept").recall(terrain)
    placement = module("touch.placement").Placement.of(terrain, kept.frame)
    place = (31_000.0, -47_000.0, 1234.0)
    assert placement.to_terrain(placement.to_scene(*place)) == pytest.approx(place, rel=1e-4, abs=20.0)
    assert placement.exaggeration == pytest.approx(kept.frame.exaggeration * 2.5)


def _update() -> None:
    import bpy

    bpy.context.view_layer.update()


@pytest.mark.parametrize(
    ("lowest", "highest", "up"), [(-8068.0, 21134.0, 0.0), (120.0, 900.0, 120.0), (-900.0, -5.0, -900.0)]
)
def test_elevation_0_is_the_scene_s_floor_where_the_map_has_it(
    lowest: float, highest: float, up: float
) -> None:
    frame = module("terrain.frame").terrain_frame(
        GridLayout(3, 3, cell_width=1.0, cell_height=1.0),
        lowest,
        highest,
        units_per_metre=1.0,
        exaggeration=2.0,
    )
    assert frame.to_object(0.0, 0.0, up)[2] == 0.0


def test_an_undecimated_preview_lies_where_the_real_surface_lies(tmp_path: Path) -> None:
    terrain = import_grid(MegdrPair(rough(9, 13)).write(tmp_path))
    grid = module("terrain.kept").recall(terrain).grid.open()
    surface = _surface(grid, 1000)
    layout = grid.layout
    for number in range(400):
        east = (number * 0.61803 % 1.0) * 12.0 * layout.cell_width
        north = -(number * 0.41421 % 1.0) * 8.0 * layout.cell_height
        assert surface.height_at(east, north) == pytest.approx(grid.elevation_at(east, north), abs=1e-6)


def test_the_preview_has_no_height_off_the_map_or_in_a_hole(tmp_path: Path) -> None:
    heights = rough(5, 5)
    heights[2][2] = -32768
    terrain = import_grid(MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path))
    grid = module("terrain.kept").recall(terrain).grid.open()
    surface = _surface(grid, 1000)
    width, height = grid.layout.cell_width, grid.layout.cell_height
    assert surface.height_at(-1.0, -1.0) is None
    assert surface.height_at(4.01 * width, -height) is None
    assert surface.height_at(1.9 * width, -1.9 * height) is None
    assert surface.height_at(4.0 * width, -4.0 * height) == pytest.approx(heights[4][4])


def test_many_places_of_the_preview_have_the_heights_that_each_has(tmp_path: Path) -> None:
    heights = rough(9, 13)
    heights[4][6] = -32768
    terrain = import_grid(MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path))
    grid = module("terrain.kept").recall(terrain).grid.open()
    surface = _surface(grid, 50)
    random = np.random.default_rng(1)
    # A little beyond the map on every side, and on its samples.
    east = np.append(random.uniform(-1.0, 13.0, 500), np.arange(13.0)) * grid.layout.cell_width
    north = -np.append(random.uniform(-1.0, 9.0, 500), np.arange(13.0) % 9.0) * grid.layout.cell_height
    each = [surface.height_at(*place) for place in zip(east.tolist(), north.tolist(), strict=True)]
    assert None in each
    alone = np.array([np.nan if height is None else height for height in each])
    np.testing.assert_allclose(surface.heights_at(east, north), alone, rtol=1e-12)


def test_the_preview_of_a_planet_goes_on_to_its_seam(tmp_path: Path) -> None:
    pair = planet()
    terrain = import_grid(pair.write(tmp_path))
    grid = module("terrain.kept").recall(terrain).grid.open()
    surface = _surface(grid, 100_000)
    east = 359.5 * grid.layout.cell_width
    assert surface.height_at(east, 0.0) == pytest.approx((pair.heights[0][359] + pair.heights[0][0]) / 2.0)


def _surface(grid: Any, budget: int) -> Any:
    preview = module("terrain.preview")
    return preview.preview_surface(grid, preview.preview_cells(grid.layout, budget))
