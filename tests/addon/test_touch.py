"""A hand on a terrain, ticked by the test: in the background Blender's timers never fire."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import pytest
from mathutils import Vector
from proxygraph import ScriptedDevice, Window

from tests.addon.hands import sweep
from tests.addon.scene import contents, import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough

Tick = Callable[[], None]


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(**options: Any) -> Any:
    """Start touch, stepped unless told."""
    return module("touch.start").start_touch(bpy.context, **{"on_the_clock": False, **options})


def tick() -> None:
    module("touch.tick").tick()


def live() -> Any:
    return module("touch.live").live


def step(touch: Any, ticks: int) -> None:
    """Let the servo run, then Blender's timer once."""
    touch.session.step(ticks)
    tick()


def cursor() -> bpy.types.Object:
    return bpy.data.objects["Haptic Cursor"]


def test_the_operators_start_and_stop_a_live_session(terrain: bpy.types.Object) -> None:
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}
    touch = live().touch
    assert touch.session.running
    assert "Touch Target" in bpy.data.objects
    tick()
    assert bpy.ops.haptic_terrain.touch_stop() == {"FINISHED"}
    assert not touch.session.running
    assert live().touch is None


def test_starting_without_terrain_says_what_to_do() -> None:
    before = contents()
    assert not bpy.ops.haptic_terrain.touch_start.poll()
    with pytest.raises(RuntimeError, match="import a grid"):
        bpy.ops.haptic_terrain.touch_start()
    with pytest.raises(RuntimeError, match="import a grid"):
        start()
    assert contents() == before


def test_starting_twice_says_so_and_changes_nothing(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    first, before = live().touch, contents()
    with pytest.raises(RuntimeError, match="already running"):
        bpy.ops.haptic_terrain.touch_start()
    with pytest.raises(RuntimeError, match="already running"):
        start()
    assert live().touch is first
    assert first.session.running
    assert contents() == before


def test_a_device_that_serves_another_session_is_refused(terrain: bpy.types.Object) -> None:
    device = sweep()
    start(device=device)
    bpy.ops.haptic_terrain.touch_stop()
    with pytest.raises(module("touch.error").TouchError, match="cannot start"):
        start(device=device)
    assert live().touch is None


def test_touch_can_start_again_after_it_was_stopped(terrain: bpy.types.Object) -> None:
    for _ in range(3):
        assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}
        assert bpy.ops.haptic_terrain.touch_stop() == {"FINISHED"}
    assert len([thing for thing in bpy.data.objects if thing.name.startswith("Touch Target")]) == 1


def test_several_terrains_ask_for_a_choice(terrain: bpy.types.Object, tmp_path: Path) -> None:
    other = import_grid(MegdrPair(rough(5, 5), name="other").write(tmp_path))
    assert start().terrain.name == other.name
    bpy.ops.haptic_terrain.touch_stop()
    bpy.context.view_layer.objects.active = None
    with pytest.raises(RuntimeError, match="there are 2"):
        start()


def test_a_lost_grid_file_is_explained(terrain: bpy.types.Object, tmp_path: Path) -> None:
    (tmp_path / "grid.img").unlink()
    before = contents()
    with pytest.raises(RuntimeError, match=r"grid\.img"):
        bpy.ops.haptic_terrain.touch_start()
    assert contents() == before


def test_a_free_cursor_is_a_sphere_and_a_touching_one_a_cone(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    step(touch, 10)
    assert not touch.session.state().in_contact
    assert cursor().data.name == "Haptic Cursor Free"
    step(touch, 990)
    assert touch.session.state().in_contact
    assert cursor().data.name == "Haptic Cursor Contact"
    assert cursor().data.materials[0] is not bpy.data.meshes["Haptic Cursor Free"].materials[0]


def test_the_tip_of_the_cone_is_at_the_proxy(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    for _ in range(20):
        step(touch, 50)
        state = touch.session.state()
        if state.in_contact:
            expected = Vector(touch.frame.to_object(*state.proxy))
            assert (cursor().matrix_world.translation - expected).length < 1e-4
    mesh = bpy.data.meshes["Haptic Cursor Contact"]
    lowest = min((vertex.co for vertex in mesh.vertices), key=lambda place: place.z)
    assert lowest.length < 1e-6


def test_the_cursor_follows_a_terrain_that_was_moved(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    step(touch, 1000)
    before = cursor().matrix_world.translation.copy()
    terrain.location.x += 25.0
    bpy.context.view_layer.update()
    tick()
    assert cursor().matrix_world.translation.x == pytest.approx(before.x + 25.0, abs=1e-3)


def test_a_coarse_preview_does_not_bury_the_cursor(tmp_path: Path) -> None:
    import_grid(MegdrPair(rough(40, 60)).write(tmp_path), vertex_budget=30)
    touch = start(device=sweep())
    lifted = 0
    for _ in range(40):
        step(touch, 40)
        east, north, up = touch.session.state().proxy
        preview = touch.surface.height_at(east, north)
        shown = touch.frame.to_terrain(*cursor().matrix_world.translation[:])[2]
        assert shown == pytest.approx(max(up, preview), abs=1.0)
        lifted += preview > up
    assert lifted


def test_stretching_the_terrain_changes_what_the_hand_feels(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    before = touch.session.window.exaggeration
    terrain.scale.z = 3.0
    bpy.context.view_layer.update()
    tick()
    assert touch.session.window.exaggeration == pytest.approx(3.0 * before)


def test_the_readout_tells_where_the_hand_is(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    step(touch, 1000)
    readout, state = touch.readout, touch.session.state()
    kept = module("terrain.kept").recall(terrain)
    layout = kept.grid.layout
    column, row = state.proxy[0] / layout.cell_width, -state.proxy[1] / layout.cell_height
    assert readout.coordinates == kept.grid.georeference.longitude_latitude(column, row)
    assert readout.elevation == pytest.approx(state.proxy[2], abs=1e-3)
    assert readout.in_contact
    assert readout.force > 0.0
    lines = dict(module("ui.panel").readout_lines(readout, 50.0, in_degrees=True))
    assert lines["Mode"] == "Normal"
    assert lines["Contact"] == "Touching"
    assert lines["Elevation"].endswith("m (x50)")
    assert lines["Longitude"].endswith("E")
    assert lines["Missed ticks"] == "0 of 1,000"


def test_a_hand_beside_the_map_has_no_longitude(terrain: bpy.types.Object) -> None:
    beside = ScriptedDevice([(0.0, 0.0, 0.5, 0.01)])
    touch = start(device=beside)
    step(touch, 10)
    assert not touch.readout.on_map
    lines = dict(module("ui.panel").readout_lines(touch.readout, 50.0, in_degrees=True))
    assert lines["Place"] == "Beside the map"
    assert not {"Longitude", "Latitude", "Elevation"} & set(lines)


@pytest.mark.parametrize(("x", "y"), [(0.0, 50.0), (0.0, -50.0), (50.0, 0.5), (-50.0, 0.5)])
def test_an_empty_beside_the_map_keeps_the_hand_at_its_edge(
    terrain: bpy.types.Object, x: float, y: float
) -> None:
    touch = start()
    bpy.data.objects["Touch Target"].location = (x, y, 0.8)
    bpy.context.view_layer.update()
    tick()
    step(touch, 5000)
    corners = [terrain.matrix_world @ Vector(corner) for corner in terrain.bound_box]
    east, north = max(corner.x for corner in corners), max(corner.y for corner in corners)
    place = cursor().matrix_world.translation
    assert place.x == pytest.approx(min(max(x, -east), east), abs=0.02)
    assert place.y == pytest.approx(min(max(y, -north), north), abs=0.02)


def test_a_script_in_the_background_is_told_how_to_move_the_hand(
    terrain: bpy.types.Object, capfd: pytest.CaptureFixture[str]
) -> None:
    assert not bpy.ops.haptic_terrain.touch_update.poll()
    bpy.ops.haptic_terrain.touch_start()
    assert "haptic_terrain.touch_update()" in capfd.readouterr().out
    session = live().touch.session
    session.stop()
    bpy.data.objects["Touch Target"].location = (1.0, 1.5, 1.0)
    bpy.ops.haptic_terrain.touch_update()
    session.step(3000)
    bpy.ops.haptic_terrain.touch_update()
    assert cursor().matrix_world.translation[:] == pytest.approx((1.0, 1.5, 1.0), abs=1e-2)


def test_the_simulated_hand_follows_the_empty(terrain: bpy.types.Object) -> None:
    touch = start()
    target = bpy.data.objects["Touch Target"]
    for place in ((1.0, 1.5, 1.0), (-2.0, -0.5, 0.8)):
        target.location = place
        bpy.context.view_layer.update()
        tick()
        step(touch, 3000)
        assert cursor().matrix_world.translation[:] == pytest.approx(place, abs=1e-2)


def test_an_empty_pushed_under_the_ground_is_felt(terrain: bpy.types.Object) -> None:
    touch = start()
    bpy.data.objects["Touch Target"].location.z = -0.3
    bpy.context.view_layer.update()
    tick()
    step(touch, 3000)
    assert touch.readout.in_contact
    assert touch.readout.force > 0.1


def test_an_empty_left_under_the_ground_is_felt_from_the_start(terrain: bpy.types.Object) -> None:
    start()
    bpy.ops.haptic_terrain.touch_stop()
    bpy.data.objects["Touch Target"].location.z = -0.3
    touch = start(terrain=terrain)
    assert touch.session.state().proxy[2] >= touch.grid.elevation_at(*touch.session.state().proxy[:2])
    step(touch, 3000)
    assert touch.readout.in_contact


def test_a_tick_that_fails_takes_the_hand_away(
    terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail() -> None:
        raise ZeroDivisionError

    touch = start()
    timer = module("touch.timer")
    monkeypatch.setattr(timer, "tick", fail)
    with pytest.raises(ZeroDivisionError):
        timer._run()
    assert live().touch is None
    assert not touch.session.running
    assert "failed" in live().message


def test_a_window_width_lies_around_the_empty(terrain: bpy.types.Object) -> None:
    start()
    bpy.ops.haptic_terrain.touch_stop()
    bpy.context.scene.haptic_terrain.window_width = 100.0
    bpy.data.objects["Touch Target"].location = (2.0, 1.0, 0.5)
    touch = start(terrain=terrain)
    expected = touch.frame.to_terrain(2.0, 1.0, 0.0)
    window = touch.session.window
    assert (window.width, window.east, window.north) == pytest.approx((100_000.0, *expected[:2]), rel=1e-5)


def test_the_whole_map_fits_into_the_workspace(terrain: bpy.types.Object) -> None:
    window = start().session.window
    layout = module("terrain.kept").recall(terrain).grid.layout
    assert window.width >= 59 * layout.cell_width
    assert window.width * 0.12 / 0.16 >= 39 * layout.cell_height * 0.999


def test_deleting_the_terrain_stops_touch_with_a_message(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    session = live().touch.session
    bpy.data.objects.remove(terrain)
    tick()
    assert live().touch is None
    assert not session.running
    assert "terrain is gone" in live().message


def test_deleting_the_terrain_by_its_operator_stops_touch(terrain: bpy.types.Object) -> None:
    start()
    bpy.ops.object.select_all(action="DESELECT")
    terrain.select_set(True)
    bpy.ops.object.delete()
    tick()
    assert live().touch is None


def test_renaming_the_terrain_does_not_stop_touch(terrain: bpy.types.Object) -> None:
    touch = start()
    terrain.name = "Something else"
    step(touch, 5)
    assert live().touch is touch


def test_a_deleted_cursor_stops_touch_and_comes_back_with_the_next(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    bpy.data.objects.remove(cursor())
    step(touch, 1000)
    assert live().touch is None
    assert "cursor was deleted" in live().message
    step(start(device=sweep()), 1000)
    assert cursor().name in bpy.context.scene.objects


def test_a_deleted_target_leaves_the_hand_where_it_is(terrain: bpy.types.Object) -> None:
    touch = start()
    bpy.data.objects.remove(bpy.data.objects["Touch Target"])
    step(touch, 100)
    assert live().touch is touch


def test_undo_is_survived(terrain: bpy.types.Object) -> None:
    bpy.context.preferences.edit.use_global_undo = True
    touch = start(device=sweep())
    bpy.ops.ed.undo_push(message="touching")
    step(touch, 500)
    bpy.ops.ed.undo_push(message="something else")
    bpy.ops.ed.undo()
    step(touch, 500)
    assert live().touch is touch
    assert cursor().data.name == "Haptic Cursor Contact"
    bpy.ops.ed.redo()
    step(touch, 100)
    assert live().touch is touch


def test_undoing_the_start_stops_touch_and_puts_nothing_into_the_scene(terrain: bpy.types.Object) -> None:
    bpy.context.preferences.edit.use_global_undo = True
    bpy.ops.ed.undo_push(message="imported")
    touch = start(device=sweep())
    bpy.ops.ed.undo_push(message="touching")
    step(touch, 500)
    bpy.ops.ed.undo()
    before = contents()
    tick()
    assert live().touch is None
    assert not touch.session.running
    assert "its start was undone" in live().message
    assert contents() == before


def test_every_look_of_the_cursor_is_there_from_the_start(terrain: bpy.types.Object) -> None:
    """What the timer made between two steps of undo would be a dead pointer after an undo."""
    touch = start(device=sweep(), modes=True)
    before, looks = contents(), {cursor().data.name}
    for mode in ("normal", "pan", "zoom"):
        touch.session.set_mode(mode)
        step(touch, 500)
        looks.add(cursor().data.name)
    assert len(looks) == 4
    assert contents() == before


def test_undoing_the_import_stops_touch(tmp_path: Path) -> None:
    label = MegdrPair(rough(9, 13)).write(tmp_path)
    bpy.context.preferences.edit.use_global_undo = True
    bpy.ops.ed.undo_push(message="empty")
    import_grid(label)
    bpy.ops.ed.undo_push(message="imported")
    touch = start()
    bpy.ops.ed.undo()
    tick()
    assert live().touch is None
    assert not touch.session.running


def test_loading_a_file_stops_touch(terrain: bpy.types.Object, tmp_path: Path) -> None:
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    bpy.ops.haptic_terrain.touch_start()
    session = live().touch.session
    bpy.ops.haptic_terrain.record_start()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "scene.blend"))
    assert not session.running
    assert live().touch is None
    assert live().recording is None
    assert "another file" in live().message
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}
    assert live().message == ""


def test_disabling_the_extension_stops_touch(terrain: bpy.types.Object) -> None:
    import addon_utils
    from enable_addon import MODULE, enable

    bpy.ops.haptic_terrain.touch_start()
    session = live().touch.session
    addon_utils.disable(MODULE)
    assert not session.running
    assert not hasattr(bpy.types.Scene, "haptic_terrain")
    enable()
    assert bpy.ops.haptic_terrain.touch_start.poll()


def test_nothing_is_written_to_the_scene_while_it_is_rendered(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    seen: list[bool] = []

    def during(*_arguments: object) -> None:
        before = cursor().matrix_world.copy()
        step(touch, 300)
        seen.append(cursor().matrix_world == before)

    bpy.app.handlers.render_pre.append(during)
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(scene.camera)
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.render.resolution_x = scene.render.resolution_y = 8
    bpy.ops.render.render()
    bpy.app.handlers.render_pre.remove(during)
    assert seen == [True]
    before = cursor().matrix_world.copy()
    step(touch, 700)
    assert cursor().matrix_world != before


def test_the_cursor_is_brought_back_at_the_seam_of_a_planet(tmp_path: Path) -> None:
    import_grid(planet().write(tmp_path))
    frame, layout = module("terrain.frame"), module("terrain.kept")
    grid = layout.recall(bpy.context.view_layer.objects.active).grid
    width, _height = frame.map_size(grid.layout)
    window = Window(width, -width / 4.0, 0.0, width=width / 4.0, exaggeration=10.0)
    touch = start(device=sweep(), window=window)
    sides = set()
    for _ in range(20):
        step(touch, 100)
        x = cursor().matrix_world.translation.x
        assert -5.0 <= x <= 5.0
        assert 0.0 <= touch.readout.coordinates[0] < 360.0
        sides.add(x > 0.0)
    assert sides == {True, False}


def test_hand_and_goal_agree_with_the_window(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    to_workspace = module("touch.workspace").to_workspace
    for _ in range(5):
        step(touch, 200)
        state = touch.session.state()
        assert to_workspace(state.goal, touch.session.window, 0.16) == pytest.approx(state.hand, abs=1e-9)


def test_hand_and_goal_agree_with_a_turned_window(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    to_workspace = module("touch.workspace").to_workspace
    straight = touch.session.window
    touch.session.set_window(
        Window(
            straight.east,
            straight.north,
            straight.up,
            width=straight.width,
            exaggeration=straight.exaggeration,
            turn=0.7,
        )
    )
    for _ in range(5):
        step(touch, 200)
        state = touch.session.state()
        assert touch.session.window.turn == 0.7
        assert to_workspace(state.goal, touch.session.window, 0.16) == pytest.approx(state.hand, abs=1e-9)
