"""Going to a longitude and latitude."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import pytest
from proxygraph import Window

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60), west=200.0, north=20.0).write(tmp_path))


def go(longitude: float, latitude: float) -> None:
    assert bpy.ops.haptic_terrain.go_to(longitude=longitude, latitude=latitude) == {"FINISHED"}


def sample_of(terrain: bpy.types.Object, place: Any) -> tuple[float, float, float]:
    """Fractional column and row, and metres, of a place in the scene."""
    kept = module("terrain.kept").recall(terrain)
    placement = module("touch.placement").Placement.of(terrain, kept.frame)
    east, north, up = placement.to_terrain(place)
    return east / kept.grid.layout.cell_width, -north / kept.grid.layout.cell_height, up


@pytest.mark.parametrize("longitude", [210.5, -149.5])
def test_the_cursor_goes_to_the_ground_there(terrain: bpy.types.Object, longitude: float) -> None:
    go(longitude, 12.5)
    column, row, up = sample_of(terrain, bpy.context.scene.cursor.location)
    assert (column, row) == pytest.approx((10.0, 7.0), abs=1e-3)
    assert up == pytest.approx(rough(40, 60)[7][10], abs=3.0)


def test_a_moved_and_turned_terrain_is_where_it_is(terrain: bpy.types.Object) -> None:
    terrain.location, terrain.rotation_euler = (5.0, -3.0, 2.0), (0.1, 0.2, 1.0)
    bpy.context.view_layer.update()
    go(210.5, 12.5)
    assert sample_of(terrain, bpy.context.scene.cursor.location)[:2] == pytest.approx((10.0, 7.0), abs=1e-3)


def test_the_target_goes_above_the_ground_and_takes_the_hand_along(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    go(210.5, 12.5)
    bpy.context.view_layer.update()
    column, row, up = sample_of(terrain, bpy.data.objects["Touch Target"].matrix_world.translation)
    assert (column, row) == pytest.approx((10.0, 7.0), abs=1e-3)
    assert up > rough(40, 60)[7][10]


def test_a_narrow_window_goes_there_and_a_wide_one_stays(terrain: bpy.types.Object) -> None:
    start = module("touch.start").start_touch
    layout = module("terrain.kept").recall(terrain).grid.layout
    for width, moves in ((100_000.0, True), (1e7, False)):
        window = Window(1000.0, -1000.0, 0.0, width=width, exaggeration=50.0)
        touch = start(bpy.context, device=sweep(), window=window, on_the_clock=False)
        go(210.5, 12.5)
        east = touch.session.window.east
        assert east == pytest.approx(10.0 * layout.cell_width if moves else 1000.0, rel=1e-6)
        assert touch.session.window.width == width
        module("touch.stop").stop_touch()


@pytest.mark.parametrize(("longitude", "latitude"), [(10.0, 0.0), (210.0, 80.0), (199.4, 0.0), (260.6, 0.0)])
def test_a_place_off_the_map_is_told(terrain: bpy.types.Object, longitude: float, latitude: float) -> None:
    before = bpy.context.scene.cursor.location[:]
    with pytest.raises(RuntimeError, match=r"not on this map, which shows 200\.5 to 259\.5"):
        go(longitude, latitude)
    assert bpy.context.scene.cursor.location[:] == before


def test_half_a_cell_beyond_the_outer_samples_is_on_the_map(terrain: bpy.types.Object) -> None:
    go(200.0, 20.0)
    assert sample_of(terrain, bpy.context.scene.cursor.location)[:2] == pytest.approx((0.0, 0.0), abs=1e-3)


@pytest.mark.parametrize("longitude", [0.2, 359.9, -0.1, 360.0])
def test_the_seam_of_a_planet_is_on_the_map(tmp_path: Path, longitude: float) -> None:
    terrain = import_grid(planet().write(tmp_path))
    go(longitude, -45.5)
    column, row, _up = sample_of(terrain, bpy.context.scene.cursor.location)
    assert column == pytest.approx((longitude - 0.5) % 360.0, abs=0.01)
    assert row == pytest.approx(135.0, abs=0.01)


def test_a_hole_has_a_place_too(tmp_path: Path) -> None:
    heights = rough(9, 13)
    heights[4][5] = -32768
    terrain = import_grid(MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path))
    go(25.5, 5.5)
    assert sample_of(terrain, bpy.context.scene.cursor.location)[:2] == pytest.approx((5.0, 4.0), abs=1e-3)


def test_a_grid_that_is_gone_is_told(terrain: bpy.types.Object) -> None:
    module("terrain.kept").recall(terrain).grid.data_path.unlink()
    with pytest.raises(RuntimeError, match=r"grid\.img: samples"):
        go(210.5, 12.5)
