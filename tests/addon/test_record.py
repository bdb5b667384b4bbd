"""Touch as animation."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from proxygraph import Window

from tests.addon.hands import circles, sweep
from tests.addon.scene import contents, curves_of, import_grid, keys_of, module, positions
from tests.formats.megdr_pair import MegdrPair, planet, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(**options: Any) -> Any:
    """Start touch, stepped."""
    return module("touch.start").start_touch(bpy.context, on_the_clock=False, **options)


def run(touch: Any, ticks: int, *, timer_calls: int) -> None:
    """Let the servo run for some ticks, and Blender's timer some times."""
    for number in range(timer_calls):
        touch.session.step(ticks * (number + 1) // timer_calls - ticks * number // timer_calls)
        module("touch.tick").tick()


def record(touch: Any, ticks: int, *, timer_calls: int = 50, trail: bool = True) -> bpy.types.Object:
    """Record a take with the operators; gives its object."""
    before = set(bpy.data.objects)
    assert bpy.ops.haptic_terrain.record_start() == {"FINISHED"}
    run(touch, ticks, timer_calls=timer_calls)
    assert bpy.ops.haptic_terrain.record_stop(trail=trail) == {"FINISHED"}
    return next(thing for thing in set(bpy.data.objects) - before if thing.name.startswith("Touch Take"))


def test_a_take_has_its_own_object_and_its_own_action(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    first, second = record(touch, 500), record(touch, 500)
    assert first is not second
    assert first.animation_data.action is not second.animation_data.action
    assert [(curve.data_path, curve.array_index) for curve in curves_of(first)] == [
        ("location", 0),
        ("location", 1),
        ("location", 2),
        ('["haptic_terrain_force"]', 0),
        ('["haptic_terrain_depth"]', 0),
    ]


def test_the_live_cursor_and_the_terrain_are_never_keyed(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    record(touch, 500)
    assert bpy.data.objects["Haptic Cursor"].animation_data is None
    assert terrain.animation_data is None


def test_keys_are_the_same_for_few_and_for_many_timer_calls(terrain: bpy.types.Object) -> None:
    keys = []
    for timer_calls in (2, 300, 1):
        touch = start(device=circles(), terrain=terrain)
        keys.append(keys_of(record(touch, 3000, timer_calls=timer_calls)))
        bpy.ops.haptic_terrain.touch_stop()
    assert keys[0] == keys[1] == keys[2]


def test_keys_begin_at_the_current_frame_at_the_scene_s_rate(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = 30, 1.001
    scene.frame_set(77)
    keys = keys_of(record(start(device=circles()), 2000))
    assert [frame for frame, _value, _kind in keys[0]] == [float(frame) for frame in range(77, 77 + 60)]


def test_the_rate_is_frames_by_their_base(terrain: bpy.types.Object) -> None:
    render = bpy.context.scene.render
    render.fps, render.fps_base = 30, 2.0
    assert len(keys_of(record(start(device=circles()), 1000))[0]) == 15


def test_a_rate_that_was_changed_in_mid_take_is_that_of_the_keys(terrain: bpy.types.Object) -> None:
    touch, render = start(device=circles()), bpy.context.scene.render
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=3)
    render.fps, render.fps_base = 60, 1.0
    assert module("record.recording").stop_recording(bpy.context).keyframes == 60


def test_a_take_lies_on_the_terrain_where_it_is_in_the_end(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=3)
    columns = module("touch.live").live.recording.recorder.columns
    felt = [columns[f"proxy_{axis}"][0] for axis in ("east", "north", "up")]
    terrain.location = (30.0, -20.0, 4.0)
    bpy.context.view_layer.update()
    take = module("record.recording").stop_recording(bpy.context)
    first = [axis[0][1] for axis in keys_of(take.take)]
    assert first == pytest.approx(np.add(touch.frame.to_object(*felt), (30.0, -20.0, 4.0)), abs=1e-4)
    assert take.trail.matrix_world.translation[:] == pytest.approx((30.0, -20.0, 4.0))


def test_a_take_of_a_terrain_that_is_gone_is_still_written(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=3)
    bpy.data.objects.remove(terrain)
    assert module("record.recording").stop_recording(bpy.context).keyframes == 24


def test_a_take_that_cannot_be_written_leaves_nothing_half_done(
    terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_arguments: object, **_named: object) -> None:
        raise MemoryError

    monkeypatch.setattr(module("record.trail_tube"), "tube", fail)
    touch = start(device=sweep())
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=3)
    before = contents()
    with pytest.raises(MemoryError):
        module("record.recording").stop_recording(bpy.context)
    assert contents() == before


def test_each_key_is_a_place_that_was_felt(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=7)
    columns = module("touch.live").live.recording.recorder.columns
    felt = [
        touch.frame.to_object(*place)
        for place in zip(columns["proxy_east"], columns["proxy_north"], columns["proxy_up"], strict=True)
    ]
    assert len(felt) == 1000
    assert columns["time"][0] == pytest.approx(0.001)
    take = module("record.recording").stop_recording(bpy.context).take
    keys = np.array([[value for _frame, value, _kind in axis] for axis in keys_of(take)]).T
    times = np.arange(len(keys)) / 24.0
    expected = np.array([felt[round(time * 1000.0)] for time in times])
    assert np.allclose(keys, expected, atol=1e-5)


def test_a_take_plays_back(terrain: bpy.types.Object) -> None:
    take = record(start(device=circles()), 1000)
    keys = keys_of(take)
    for frame, number in ((1, 0), (10, 9), (20, 19)):
        bpy.context.scene.frame_set(frame)
        assert take.location[:] == pytest.approx([axis[number][1] for axis in keys], abs=1e-5)


def test_the_scene_lasts_as_long_as_the_take_and_never_less(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    scene.frame_end = 10
    take = record(start(device=circles()), 1000)
    assert scene.frame_end == keys_of(take)[0][-1][0]
    module("touch.stop").stop_touch()
    scene.frame_end = 400
    record(start(terrain=terrain, device=circles()), 1000)
    assert scene.frame_end == 400


def test_a_take_does_not_look_like_the_cursor(terrain: bpy.types.Object) -> None:
    take = record(start(device=circles()), 1000)
    cursor = bpy.data.objects["Haptic Cursor"]
    assert take.data.materials[0] is not cursor.data.materials[0]


def test_nothing_sweeps_over_the_map_at_the_seam(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    grid = module("terrain.kept").recall(terrain).grid
    width, _height = module("terrain.frame").map_size(grid.layout)
    window = Window(width, -width / 4.0, 0.0, width=width / 4.0, exaggeration=10.0)
    take = record(start(device=sweep(), window=window), 2000)
    jumps = 0
    for axis in keys_of(take):
        for (_f, _v, kind), x, following in zip(axis, *_pairs(keys_of(take)[0]), strict=False):
            jumped = abs(following - x) > 5.0
            jumps += jumped
            assert kind == ("CONSTANT" if jumped else "LINEAR")
    assert jumps == 3


def _pairs(axis: list[tuple[float, float, str]]) -> tuple[list[float], list[float]]:
    """Values, and the values after them; the last one stands still."""
    values = [value for _frame, value, _kind in axis]
    return values, [*values[1:], values[-1]]


def test_recording_without_touch_says_what_to_do(terrain: bpy.types.Object) -> None:
    with pytest.raises(RuntimeError, match="Start touch"):
        bpy.ops.haptic_terrain.record_start()
    with pytest.raises(RuntimeError, match="No take"):
        bpy.ops.haptic_terrain.record_stop()


def test_recording_twice_says_so(terrain: bpy.types.Object) -> None:
    start(device=circles())
    bpy.ops.haptic_terrain.record_start()
    with pytest.raises(RuntimeError, match="already"):
        bpy.ops.haptic_terrain.record_start()


def test_an_empty_take_leaves_nothing(terrain: bpy.types.Object) -> None:
    start(device=circles())
    before = set(bpy.data.objects), set(bpy.data.actions)
    bpy.ops.haptic_terrain.record_start()
    assert bpy.ops.haptic_terrain.record_stop() == {"CANCELLED"}
    assert (set(bpy.data.objects), set(bpy.data.actions)) == before
    assert bpy.ops.haptic_terrain.record_start() == {"FINISHED"}


def test_a_take_outlives_touch(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    bpy.ops.haptic_terrain.record_start()
    run(touch, 500, timer_calls=3)
    touch.session.step(500)
    bpy.ops.haptic_terrain.touch_stop()
    take = module("record.recording").stop_recording(bpy.context)
    assert take.keyframes == 24
    assert take.seconds == pytest.approx(0.999)


def test_a_waiting_take_takes_nothing_from_the_next_touch(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=3)
    bpy.ops.haptic_terrain.touch_stop()
    run(start(device=circles(), terrain=terrain), 1000, timer_calls=3)
    assert module("record.recording").stop_recording(bpy.context).seconds == pytest.approx(0.999)


def test_what_was_felt_before_recording_is_left_out(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    run(touch, 500, timer_calls=2)
    touch.session.step(250)
    bpy.ops.haptic_terrain.record_start()
    run(touch, 1000, timer_calls=2)
    assert module("record.recording").stop_recording(bpy.context).keyframes == 24


def test_a_take_that_lost_nothing_says_so(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    touch.session.step(60_000 + 77)  # lost before the take, and none of its business
    bpy.ops.haptic_terrain.record_start()
    assert module("touch.live").live.recording.recorder.dropped == 0
    run(touch, 100, timer_calls=1)
    assert module("record.recording").stop_recording(bpy.context).dropped == 0


def test_nothing_is_lost_where_blender_looks_seldom(terrain: bpy.types.Object) -> None:
    touch = start(device=circles())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(60_000 + 1234)  # more than the session's ring takes
    written = module("record.recording").stop_recording(bpy.context)
    assert (written.dropped, written.seconds) == (0, pytest.approx(61.233))


def test_lost_ticks_are_reported(terrain: bpy.types.Object, capfd: pytest.CaptureFixture[str]) -> None:
    from tests.addon.stand_in import StandIn

    touch = start(device=circles())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(100)
    recorder = module("touch.live").live.recording.recorder
    take = StandIn(recorder.session.stop_recording(), dropped=1234)
    recorder.session = StandIn(recorder.session, stop_recording=lambda: take)
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    assert "1,234 ticks were lost" in capfd.readouterr().out


def test_the_trail_lies_on_the_preview_and_on_the_ground(tmp_path: Path) -> None:
    terrain = import_grid(MegdrPair(rough(40, 60)).write(tmp_path), vertex_budget=100)
    touch = start(device=sweep())
    record(touch, 2000)
    trail = bpy.data.objects["Touch Trail"]
    sides = module("record.tube").SIDES
    middles = positions(trail.data).reshape(-1, sides, 3).mean(axis=1)
    assert len(middles) > 100
    for x, y, z in middles.tolist():
        east, north, up = touch.frame.to_terrain(x, y, z)
        for height in (touch.surface.height_at(east, north), touch.grid.elevation_at(east, north)):
            assert height is None or up > height - 5.0
    gaps = [np.linalg.norm(after[:2] - now[:2]) for now, after in itertools.pairwise(middles)]
    assert max(gaps) < 0.05
    assert terrain.name in bpy.data.objects


def test_the_trail_has_the_force_on_its_points(terrain: bpy.types.Object) -> None:
    record(start(device=sweep()), 2000)
    mesh = bpy.data.objects["Touch Trail"].data
    force = [value.value for value in mesh.attributes["force"].data]
    assert len(force) == len(mesh.vertices)
    assert 0.0 <= min(force) < max(force) <= 8.0
    assert mesh.materials[0].name.startswith("Touch force")
    assert not mesh.validate()


def test_a_trail_is_left_out_where_it_is_not_wanted(terrain: bpy.types.Object) -> None:
    record(start(device=sweep()), 2000, trail=False)
    assert "Touch Trail" not in bpy.data.objects


def test_a_take_in_free_space_has_no_trail(terrain: bpy.types.Object) -> None:
    record(start(device=sweep()), 10)
    assert "Touch Trail" not in bpy.data.objects


def test_the_trail_does_not_join_both_sides_of_a_planet(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    grid = module("terrain.kept").recall(terrain).grid
    width, _height = module("terrain.frame").map_size(grid.layout)
    window = Window(width, -width / 4.0, 0.0, width=width / 4.0, exaggeration=10.0)
    record(start(device=sweep(), window=window), 2000)
    mesh = bpy.data.objects["Touch Trail"].data
    places = positions(mesh)
    assert {places[:, 0].min() < -4.0, places[:, 0].max() > 4.0} == {True}
    for face in mesh.polygons:
        xs = [places[number, 0] for number in face.vertices]
        assert max(xs) - min(xs) < 1.0


def test_a_take_tells_when_the_hand_panned_and_zoomed(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep(), modes=True)
    where = terrain.matrix_world.copy()
    bpy.ops.haptic_terrain.record_start()
    for mode in ("normal", "zoom", "normal", "pan"):
        touch.session.set_mode(mode)
        touch.session.step(500)
        module("touch.tick").tick()
    felt = touch.session.statistics().mode_changes
    take = module("record.recording").stop_recording(bpy.context).take
    assert felt == 3
    assert terrain.matrix_world == where
    curves = {(curve.data_path, curve.array_index): curve for curve in curves_of(take)}
    keys = curves['["haptic_terrain_mode"]', 0].keyframe_points
    assert len(keys) == len(curves["location", 0].keyframe_points)
    assert {key.interpolation for key in keys} == {"CONSTANT"}
    fps = bpy.context.scene.render.fps
    seen = [keys[round((0.25 + half / 2.0) * fps)].co.y for half in range(4)]
    assert seen == [0.0, 2.0, 0.0, 1.0]
    bpy.context.scene.frame_set(round(bpy.context.scene.frame_current + 0.75 * fps))
    assert take["haptic_terrain_mode"] == 2


def test_a_take_without_modes_has_no_curve_of_them(terrain: bpy.types.Object) -> None:
    take = record(start(device=sweep()), 500)
    assert take["haptic_terrain_mode"] == 0
    assert '["haptic_terrain_mode"]' not in {curve.data_path for curve in curves_of(take)}
