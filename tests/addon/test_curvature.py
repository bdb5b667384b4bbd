"""A terrain shown on its sphere: for the eye only, and everything follows the same frame."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Vector

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module, positions
from tests.formats.megdr_pair import MegdrPair, planet, rough

MARS = 3_396_000.0


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60), north=60.0).write(tmp_path))


def curve(curved: bool = True) -> None:
    assert bpy.ops.haptic_terrain.show_curvature(curved=curved) == {"FINISHED"}


def kept_of(terrain: bpy.types.Object) -> Any:
    return module("terrain.kept").recall(terrain)


def test_a_planet_becomes_a_globe(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path), exaggeration=1.0)
    curve()
    frame = kept_of(terrain).frame
    centre = np.array([0.0, 0.0, -MARS * frame.units_per_metre])
    away = np.linalg.norm(positions(terrain.data) - centre, axis=1) / frame.units_per_metre
    assert away == pytest.approx(MARS, rel=1e-3)
    heights = [value.value for value in terrain.data.attributes["elevation"].data]
    assert away - MARS == pytest.approx(np.array(heights), abs=2.0)
    rows = positions(terrain.data).reshape(180, 361, 3)
    assert rows[:, 0] == pytest.approx(rows[:, -1], abs=1e-5)


def test_a_part_is_where_longitude_and_latitude_say(terrain: bpy.types.Object) -> None:
    curve()
    kept = kept_of(terrain)
    place, frame, layout = kept.grid.georeference, kept.frame, kept.grid.layout

    def direction(column: float, row: float) -> Any:
        longitude, latitude = math.radians(place.x(column)), math.radians(place.y(row))
        return np.array(
            [
                math.cos(latitude) * math.cos(longitude),
                math.cos(latitude) * math.sin(longitude),
                math.sin(latitude),
            ]
        )

    def shown(column: float, row: float) -> Any:
        x, y, z = frame.to_object(column * layout.cell_width, -row * layout.cell_height, frame.up)
        return np.array([x, y, z]) / frame.units_per_metre + np.array([0.0, 0.0, MARS])

    for first, second in (((0, 0), (59, 39)), ((3, 30), (41.5, 7.25)), ((0, 39), (59, 39))):
        expected = direction(*first) @ direction(*second)
        assert shown(*first) @ shown(*second) / MARS**2 == pytest.approx(expected, abs=1e-9)


def test_a_map_in_metres_keeps_distances_from_its_middle() -> None:
    bend = module("terrain.bend").Bend(radius=1000.0)
    for east, north in ((300.0, 0.0), (0.0, -500.0), (200.0, 700.0), (0.0, 0.0)):
        x, y, z = bend.bent(east, north, 0.0)
        assert math.hypot(x, y, z + 1000.0) == pytest.approx(1000.0)
        assert 1000.0 * math.atan2(math.hypot(x, y), z + 1000.0) == pytest.approx(math.hypot(east, north))
        assert bend.flat(x, y, z) == pytest.approx((east, north, 0.0), abs=1e-6)


@pytest.mark.parametrize(("column", "row"), [(0, 0), (59, 39), (12.5, 33.25), (29.5, 19.5)])
def test_places_come_back_from_the_sphere(terrain: bpy.types.Object, column: float, row: float) -> None:
    curve()
    kept = kept_of(terrain)
    place = column * kept.grid.layout.cell_width, -row * kept.grid.layout.cell_height, 1234.5
    assert kept.frame.to_terrain(*kept.frame.to_object(*place)) == pytest.approx(place, rel=1e-9, abs=1e-3)


def test_flat_again_is_bit_for_bit_what_it_was(terrain: bpy.types.Object) -> None:
    before, frame = positions(terrain.data), kept_of(terrain).frame
    curve()
    assert not np.array_equal(positions(terrain.data), before)
    curve(False)
    assert np.array_equal(positions(terrain.data), before)
    assert kept_of(terrain).frame == frame


def test_grid_and_elevations_stay_as_they_are(terrain: bpy.types.Object) -> None:
    before = kept_of(terrain)
    heights = [value.value for value in terrain.data.attributes["elevation"].data]
    curve()
    after = kept_of(terrain)
    assert after.grid == before.grid
    assert [value.value for value in terrain.data.attributes["elevation"].data] == heights


def test_a_hand_feels_the_same_and_its_cursor_lies_on_the_sphere(terrain: bpy.types.Object) -> None:
    touching, tick = module("touch.start"), module("touch.tick").tick
    touch = touching.start_touch(bpy.context, device=sweep(), on_the_clock=False)
    touch.session.step(700)
    tick()
    flat = touch.session.state()
    curve()
    tick()
    assert touch.session.state().proxy == flat.proxy
    cursor = bpy.data.objects["Haptic Cursor"]
    frame = kept_of(terrain).frame
    expected = frame.to_object(*flat.proxy)
    assert cursor.matrix_world.translation[:] == pytest.approx(expected, abs=0.02)
    assert frame.bend is not None
    # It stands upright on the sphere, which leans away from the middle.
    up = cursor.matrix_world.to_quaternion() @ Vector((0.0, 0.0, 1.0))
    away = np.add(expected, (0.0, 0.0, frame.bend.radius * frame.units_per_metre))
    assert up[:] == pytest.approx(away / np.linalg.norm(away), abs=1e-4)


def test_the_target_stays_over_its_place(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    touch = module("touch.live").live.touch
    empty = bpy.data.objects["Touch Target"]
    empty.location = (3.0, 2.0, 0.5)
    bpy.context.view_layer.update()
    before = touch.frame.to_terrain(*empty.matrix_world.translation[:])
    curve()
    module("touch.tick").tick()
    assert touch.frame.to_terrain(*empty.matrix_world.translation[:]) == pytest.approx(
        before, rel=1e-5, abs=20.0
    )


def test_undone_by_a_file_of_before_the_touch_follows(terrain: bpy.types.Object) -> None:
    """An undo changes the object's properties without telling anyone."""
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    flat = kept_of(terrain).frame
    curve()
    module("terrain.kept").keep_frame(terrain, flat)
    module("touch.tick").tick()
    assert touch.frame == flat


def test_a_bent_terrain_survives_a_file(terrain: bpy.types.Object, tmp_path: Path) -> None:
    curve()
    name, frame = terrain.name, kept_of(terrain).frame
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "kept.blend"))
    assert kept_of(bpy.data.objects[name]).frame == frame


def test_an_edited_mesh_is_not_overwritten(terrain: bpy.types.Object) -> None:
    terrain.data.vertices.add(1)
    frame = kept_of(terrain).frame
    with pytest.raises(RuntimeError, match="it was edited"):
        bpy.ops.haptic_terrain.show_curvature()
    assert kept_of(terrain).frame == frame


def test_a_take_in_the_making_keeps_the_map_as_it_is(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    bpy.ops.haptic_terrain.record_start()
    assert not bpy.ops.haptic_terrain.show_curvature.poll()
    bpy.ops.haptic_terrain.record_stop()
