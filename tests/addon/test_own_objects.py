"""The cursor and the Touch Target: one for each scene, whatever they are called; and the terrain's handle."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import pytest
from mathutils import Matrix, Vector

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(**options: Any) -> Any:
    """Start touch, stepped."""
    return module("touch.start").start_touch(bpy.context, on_the_clock=False, **options)


def targets() -> list[bpy.types.Object]:
    return [thing for thing in bpy.data.objects if thing.type == "EMPTY"]


def test_a_renamed_target_is_found_again(terrain: bpy.types.Object) -> None:
    start()
    bpy.ops.haptic_terrain.touch_stop()
    targets()[0].name = "My hand"
    touch = start(terrain=terrain)
    assert [empty.name for empty in targets()] == ["My hand"]
    assert touch.target.find() == targets()[0]


def test_each_scene_has_one_target_of_its_own(terrain: bpy.types.Object) -> None:
    start()
    bpy.ops.haptic_terrain.touch_stop()
    first = bpy.context.scene
    second = bpy.data.scenes.new("Second")
    second.collection.objects.link(terrain)
    bpy.context.window.scene = second
    for _ in range(3):
        touch = start(terrain=terrain)
        assert touch.target.find().name in second.objects
        bpy.ops.haptic_terrain.touch_stop()
    assert len(targets()) == 2
    assert len([empty for empty in targets() if empty.name in first.objects]) == 1


def test_the_cursor_stays_in_the_scene_where_touch_was_started(terrain: bpy.types.Object) -> None:
    first = bpy.context.scene
    touch = start(device=sweep())
    bpy.ops.haptic_terrain.record_start()
    second = bpy.data.scenes.new("Second")
    second.render.fps = 1
    bpy.context.window.scene = second
    touch.session.step(1000)
    module("touch.tick").tick()
    take = module("record.recording").stop_recording(bpy.context)
    assert len(second.objects) == 0
    assert {"Haptic Cursor", take.take.name, take.trail.name} <= set(first.objects.keys())
    assert take.keyframes == 24


def test_deleting_the_scene_of_touch_stops_it(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    first = bpy.data.scenes[0]
    bpy.context.window.scene = bpy.data.scenes.new("Second")
    bpy.data.scenes.remove(first)
    module("touch.tick").tick()
    assert module("touch.live").live.touch is None
    assert not touch.session.running


@pytest.mark.parametrize("kept_by_a_fake_user", [False, True])
def test_a_terrain_in_no_scene_is_gone(terrain: bpy.types.Object, kept_by_a_fake_user: bool) -> None:
    start(device=sweep())
    terrain.use_fake_user = kept_by_a_fake_user
    for collection in terrain.users_collection:
        collection.objects.unlink(terrain)
    assert terrain.name in bpy.data.objects
    module("touch.tick").tick()
    assert "terrain is gone" in module("touch.live").live.message


@pytest.mark.parametrize("scale", [(-1.0, 1.0, 1.0), (1.0, -2.0, 1.0), (1.0, 1.0, 1.0), (-1.0, -1.0, 1.0)])
def test_cursor_and_take_stand_upright_on_the_terrain(
    terrain: bpy.types.Object, scale: tuple[float, float, float]
) -> None:
    terrain.scale = scale
    terrain.rotation_euler = (0.3, 0.2, 0.5)
    bpy.context.view_layer.update()
    touch = start(device=sweep())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(1000)
    module("touch.tick").tick()
    take = module("record.recording").stop_recording(bpy.context).take
    upward = terrain.matrix_world.to_3x3() @ Vector((0.0, 0.0, 1.0))
    for turn in (bpy.data.objects["Haptic Cursor"].matrix_world.to_3x3(), take.rotation_euler.to_matrix()):
        assert (turn @ Vector((0.0, 0.0, 1.0))).angle(upward) < 1e-3
        assert turn.determinant() > 0.0
    assert _same_turn(
        take.rotation_euler.to_matrix(), bpy.data.objects["Haptic Cursor"].matrix_world.to_3x3()
    )


def _same_turn(first: Matrix, second: Matrix) -> bool:
    return bool(first.to_quaternion().rotation_difference(second.to_quaternion()).angle < 1e-3)


def test_a_new_target_is_above_the_ground_by_a_share_of_the_window_as_it_is_seen(
    terrain: bpy.types.Object,
) -> None:
    touch = start()
    window = touch.session.window
    above = targets()[0].location.z - touch.frame.to_object(window.east, window.north, window.up)[2]
    across = window.width * touch.frame.units_per_metre
    assert above / across == pytest.approx(module("touch.target").CLEARANCE, rel=1e-3)


def test_the_window_of_a_tall_map_holds_all_of_it(tmp_path: Path) -> None:
    terrain = import_grid(MegdrPair(rough(60, 40)).write(tmp_path))
    window = start(terrain=terrain).session.window
    layout = module("terrain.kept").recall(terrain).grid.layout
    between_walls = 0.9
    assert window.width * 0.12 / 0.16 * between_walls == pytest.approx(59 * layout.cell_height)


def test_ticks_between_the_last_look_and_the_stop_belong_to_the_take(terrain: bpy.types.Object) -> None:
    from tests.addon.stand_in import StandIn

    touch = start(device=sweep())
    session = touch.session

    def stop() -> None:
        session.step(100)  # done by the servo before it heard of the end
        session.stop()

    touch.session = StandIn(session, stop=stop)
    bpy.ops.haptic_terrain.record_start()
    session.step(50)
    bpy.ops.haptic_terrain.touch_stop()
    assert len(module("touch.live").live.recording.recorder) == 150
