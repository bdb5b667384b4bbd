"""What a take becomes in the scene, and takes through files and .blend files."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import numpy.typing as npt
import pytest
from proxygraph import Window

from tests.addon.hands import circles, sweep
from tests.addon.scene import contents, curves_of, import_grid, keys_of, module, positions
from tests.addon.takes import same
from tests.formats.megdr_pair import MegdrPair, planet, rough

Numbers = npt.NDArray[np.float64]

MODE, FORCE, DEPTH = (f'["haptic_terrain_{name}"]' for name in ("mode", "force", "depth"))


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path), vertex_budget=300)


def settings() -> Any:
    return bpy.context.scene.haptic_terrain


def felt(ticks: int = 2000, *, modes: tuple[str, ...] = (), **options: Any) -> Any:
    """Begin a take of a hand, stepped; gives the recording."""
    touch = module("touch.start").start_touch(
        bpy.context, on_the_clock=False, **{"device": sweep(), "modes": bool(modes) or None, **options}
    )
    module("record.recording").start_recording(bpy.context)
    for mode in modes:
        touch.session.set_mode(mode)
        touch.session.step(ticks // len(modes))
    touch.session.step(0 if modes else ticks)
    module("touch.stop").note_model(touch)
    return module("touch.live").live.recording


def stop() -> Any:
    """Write what was felt, and take the hand away."""
    take = module("record.recording").stop_recording(bpy.context)
    module("touch.stop").stop_touch()
    return take


def curve(take: bpy.types.Object, path: str, index: int = 0) -> bpy.types.FCurve:
    return next(one for one in curves_of(take) if (one.data_path, one.array_index) == (path, index))


def at_frames(take: bpy.types.Object, frames: Any) -> Numbers:
    """Where Blender has a take at frames, n x 3."""
    axes = [curve(take, "location", axis) for axis in range(3)]
    return np.array([[axis.evaluate(float(frame)) for axis in axes] for frame in frames])


def view_of(recording: Any, terrain: bpy.types.Object) -> Any:
    placement = module("touch.placement").Placement.of(terrain, recording.touch.frame)
    return module("record.scene_view").SceneView(placement.frame, np.array(placement.matrix))


def ground_of(recording: Any) -> Any:
    return module("record.ground").Ground(recording.touch.grid, recording.touch.surface)


def test_force_and_depth_are_keyed_as_they_were_felt(terrain: bpy.types.Object) -> None:
    recording = felt()
    data = module("record.recording").take_data(recording)
    take = stop().take
    ticks = module("record.resample").ticks_at_frames(data.columns["time"], 24.0)
    columns = {name: values[ticks] for name, values in data.columns.items()}
    force = np.sqrt(sum(columns[f"force_{axis}"] ** 2 for axis in "xyz"))
    for path, values in ((FORCE, force), (DEPTH, data.depth[ticks])):
        keys = [key.co.y for key in curve(take, path).keyframe_points]
        assert keys == pytest.approx(values.tolist(), abs=1e-6)
    assert 0.0 == data.depth.min() < data.depth.max() < 0.03
    bpy.context.scene.frame_set(1 + int(np.argmax(force)))
    assert take["haptic_terrain_force"] == pytest.approx(force.max(), abs=1e-5)


def test_depth_is_how_far_the_spring_is_stretched(terrain: bpy.types.Object) -> None:
    recording = felt()
    data = module("record.recording").take_data(recording)
    full = data.in_contact & (data.force > 1.0) & (data.force < 7.5)  # not rising, and not at its limit
    stiffness = data.force[full] / data.depth[full]
    assert full.sum() > 100
    assert np.median(stiffness) == pytest.approx(recording.touch.session.stiffness, rel=0.02)
    assert (data.depth[~data.in_contact] == 0.0).all()


@pytest.mark.parametrize("bound", [0.3, 1.0, 5.0])
@pytest.mark.parametrize("hand", [sweep, circles])
def test_reduced_keys_keep_the_bound_and_stay_above_the_ground_at_every_frame(
    terrain: bpy.types.Object, bound: float, hand: Any
) -> None:
    scene = bpy.context.scene
    scene.render.fps = 60
    terrain.location, terrain.rotation_euler = (3.0, -20.0, 7.0), (0.3, -0.2, 1.0)
    bpy.context.view_layer.update()
    recording = felt(3000, device=hand(3.0))
    data = module("record.recording").take_data(recording)
    view, ground = view_of(recording, terrain), ground_of(recording)
    placement = module("touch.placement").Placement.of(terrain, recording.touch.frame)
    write = module("record.write_take").write_take
    options = module("record.take_options").TakeOptions(start_frame=10)
    every = write(scene, data, placement, ground, options)
    few = write(scene, data, placement, ground, replace(options, reduced=True, bound_mm=bound))
    frames = np.arange(10, 10 + every.keyframes)
    whole, reduced = at_frames(every.take, frames), at_frames(few.take, frames)
    ticks = module("record.resample").ticks_at_frames(data.columns["time"], 60.0)
    room = bound / 1000.0 * data.terrain_per_hand[ticks] * view.units_per_metre
    assert (np.linalg.norm(reduced - whole, axis=1) <= room).all()
    for points in (whole, reduced):
        east, north, up = view.to_terrain(points).T
        heights = ground.highest(view.frame.on_map(east), north)
        assert not (up < heights).any()
        assert np.isfinite(heights).all()
    assert keys_of(few.take)[0][-1][0] == frames[-1]
    if bound == 5.0:
        assert few.keyframes < 0.6 * every.keyframes


def test_reduced_force_is_within_a_share_of_the_largest(terrain: bpy.types.Object) -> None:
    recording = felt()
    data = module("record.recording").take_data(recording)
    settings().take_keys = "REDUCED"
    take = stop().take
    ticks = module("record.resample").ticks_at_frames(data.columns["time"], 24.0)
    keys = curve(take, FORCE)
    seen = np.array([keys.evaluate(1.0 + number) for number in range(len(ticks))])
    share = module("record.keys").SHARE
    assert np.abs(seen - data.force[ticks]).max() <= share * data.force[ticks].max() * 1.001
    assert len(keys.keyframe_points) < len(ticks)


def test_reduced_keys_stay_above_a_globe(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path), vertex_budget=2000)
    bpy.ops.haptic_terrain.show_curvature()
    recording = felt(2000)
    data = module("record.recording").take_data(recording)
    view, ground = view_of(recording, terrain), ground_of(recording)
    assert view.frame.bend is not None
    every = stop().take
    placement = module("touch.placement").Placement.of(terrain, recording.touch.frame)
    options = module("record.take_options").TakeOptions(start_frame=1, reduced=True, bound_mm=2.0)
    few = module("record.write_take").write_take(bpy.context.scene, data, placement, ground, options)
    frames = np.arange(1, 49)
    whole, reduced = at_frames(every, frames), at_frames(few.take, frames)
    ticks = module("record.resample").ticks_at_frames(data.columns["time"], 24.0)
    room = 0.002 * data.terrain_per_hand[ticks] * view.units_per_metre
    assert (np.linalg.norm(reduced - whole, axis=1) <= room).all()
    assert few.keyframes < 48
    for points in (whole, reduced):
        east, north, up = view.to_terrain(points).T
        assert not (up < ground.highest(view.frame.on_map(east), north)).any()


@pytest.mark.parametrize("kind", ["FRAMES", "REDUCED"])
def test_no_frame_lies_between_both_sides_of_the_seam(kind: str, tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    scene = bpy.context.scene
    scene.render.fps = 50
    grid = module("terrain.kept").recall(terrain).grid
    width, _height = module("terrain.frame").map_size(grid.layout)
    window = Window(width, -width / 4.0, 0.0, width=width / 4.0, exaggeration=10.0)
    settings().take_keys = kind
    settings().take_bound = 3.0
    felt(2000, window=window)
    take = stop()
    frames = np.arange(1.0, 100.0, 0.25)
    x = at_frames(take.take, frames)[:, 0]
    assert x.min() < -4.0
    assert x.max() > 4.0
    # A quarter of the map lies under the hand, so that nothing is ever seen in the middle half.
    assert (np.abs(x) > 2.5).all()
    jumps = np.flatnonzero(np.abs(np.diff(x)) > 5.0)
    assert len(jumps) == 1
    assert (frames[jumps + 1] == np.round(frames[jumps + 1])).all()
    if kind == "REDUCED":
        assert take.keyframes < 60


def test_a_scene_at_a_broken_rate_with_steps_and_subframes_has_whole_frames(
    terrain: bpy.types.Object,
) -> None:
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = 24, 1.001
    scene.frame_step = 2
    scene.frame_set(7, subframe=0.5)
    recording = felt(2000)
    data = module("record.recording").take_data(recording)
    take = stop()
    ticks = module("record.resample").ticks_at_frames(data.columns["time"], 24.0 / 1.001)
    keys = keys_of(take.take)[0]
    assert [frame for frame, _value, _kind in keys] == [float(frame) for frame in range(7, 7 + len(ticks))]
    assert len(ticks) == 48
    assert data.columns["time"][ticks[-1]] - data.columns["time"][0] == pytest.approx(
        47 * 1.001 / 24, abs=6e-4
    )


def test_a_take_ends_with_blender_s_last_frame_and_says_so(
    terrain: bpy.types.Object, capfd: pytest.CaptureFixture[str]
) -> None:
    scene = bpy.context.scene
    last = module("record.keys").LAST_FRAME
    scene.frame_end = 3_000_000
    assert scene.frame_end == last
    scene.frame_set(last - 9)
    felt(2000)
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    take = bpy.data.objects["Touch Take"]
    assert [frame for frame, _value, _kind in keys_of(take)[0]] == list(range(last - 9, last + 1))
    assert "lie beyond Blender's last frame" in capfd.readouterr().out


def test_the_mode_track_is_markers_named_by_take_and_mode(terrain: bpy.types.Object) -> None:
    felt(2000, modes=("normal", "pan", "normal", "zoom"))
    take = stop().take
    markers = sorted((marker.frame, marker.name) for marker in bpy.context.scene.timeline_markers)
    mode = curve(take, MODE)
    assert [name for _frame, name in markers] == [f"Touch Take: {name}" for name in ("pan", "normal", "zoom")]
    for frame, name in markers:
        number = module("record.take_data").MODES.index(name.rpartition(": ")[2])
        assert (mode.evaluate(frame), mode.evaluate(frame - 1) != number) == (number, True)
    felt(500, terrain=terrain, device=sweep())
    stop()
    assert len(bpy.context.scene.timeline_markers) == len(markers)


def test_markers_are_left_out_where_they_are_not_wanted(terrain: bpy.types.Object) -> None:
    settings().take_markers = False
    felt(2000, modes=("normal", "pan"))
    stop()
    assert not len(bpy.context.scene.timeline_markers)


def test_takes_stand_side_by_side_in_collections_and_colours_of_their_own(terrain: bpy.types.Object) -> None:
    takes = []
    for _ in range(3):
        felt(500, terrain=terrain, device=sweep())
        takes.append(stop())
    names = [take.take.name for take in takes]
    assert names == ["Touch Take", "Touch Take.001", "Touch Take.002"]
    assert len({tuple(take.take.data.materials[0].diffuse_color) for take in takes}) == 3
    for take in takes:
        (collection,) = take.take.users_collection
        assert collection.name == take.take.name
        assert set(collection.objects) == {take.take, *take.trails.values()}
        assert take.take.animation_data.action.name == take.take.name


def test_every_kind_of_trail_can_be_had_at_once(terrain: bpy.types.Object) -> None:
    settings().trail_kinds = {"TUBE", "CURVE", "POINTS"}
    recording = felt()
    data = module("record.recording").take_data(recording)
    take = stop()
    assert set(take.trails) == {"TUBE", "CURVE", "POINTS"}
    line = take.trails["CURVE"].data
    (spline,) = line.splines
    radii = [point.radius for point in spline.points]
    assert max(radii) == pytest.approx(1.0, abs=0.02)
    assert 0.1 <= min(radii) < 0.6
    assert line.bevel_depth > 0.0
    assert line.materials[0] == take.take.data.materials[0]
    mesh = take.trails["POINTS"].data
    assert (len(mesh.vertices), len(mesh.edges), len(mesh.polygons)) == (len(data), 0, 0)
    for name, values in {**data.columns, "force": data.force, "depth": data.depth}.items():
        kept = np.empty(len(data), dtype=np.float32)
        mesh.attributes[name].data.foreach_get("value", kept)
        wanted = values - values[0] if name == "time" else values
        assert kept == pytest.approx(wanted, rel=1e-6, abs=1e-6)
    for name, values in (
        module("record.files.derived").derived_columns(data, ground_of(recording).real).items()
    ):
        mesh.attributes[name].data.foreach_get("value", kept)
        assert kept == pytest.approx(values, rel=1e-6, nan_ok=True)
    frame = recording.touch.frame
    shown = np.stack(frame.to_object(*data.places.T), axis=1)
    assert positions(mesh)[:, :2] == pytest.approx(shown[:, :2], abs=1e-5)
    assert (positions(mesh)[:, 2] >= shown[:, 2] - 1e-5).all()
    assert take.trails["CURVE"].matrix_world == terrain.matrix_world


def test_a_take_can_be_replaced(terrain: bpy.types.Object) -> None:
    settings().trail_kinds = {"TUBE", "CURVE"}
    felt(2000, modes=("normal", "pan"))
    first = stop()
    settings().take_onto, settings().take = "REPLACE", first.take
    settings().trail_kinds = {"POINTS"}
    felt(1000, terrain=terrain, device=circles())
    data = module("record.recording").take_data(module("touch.live").live.recording)
    second = stop()
    assert second.take == first.take
    assert second.keyframes == 24
    assert [len(one.keyframe_points) for one in curves_of(second.take)] == [24] * 6
    assert not any(key.co.y for key in curve(second.take, MODE).keyframe_points)
    (collection,) = second.take.users_collection
    assert set(collection.objects) == {second.take, second.trails["POINTS"]}
    assert not len(bpy.context.scene.timeline_markers)
    recall = module("record.kept_take").recall_take
    assert same(recall(second.take.animation_data.action), data)
    assert len(bpy.data.actions) == 1


def test_a_take_can_be_appended_to_before_after_and_within(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    scene.frame_set(101)
    felt(2000)
    take = stop().take
    before = at_frames(take, range(101, 149))
    settings().take_onto, settings().take = "APPEND", take
    recall = module("record.kept_take").recall_take
    for start, ticks in ((201, 1000), (125, 500), (51, 1000)):
        scene.frame_set(start)
        felt(ticks, terrain=terrain, device=circles())
        assert stop().take == take
    frames = [frame for frame, _value, _kind in keys_of(take)[0]]
    assert frames == [float(frame) for frame in range(51, 225)]
    assert at_frames(take, range(101, 125)) == pytest.approx(before[:24], abs=1e-3)
    assert at_frames(take, range(138, 148)) == pytest.approx(before[37:47], abs=1e-3)
    data = recall(take.animation_data.action)
    assert len(data) == 1000 + 2000 + 1000
    assert (np.diff(data.columns["time"]) >= 0.0).all()
    # Nothing moves in a pause, also not between two frames; then it is at once where it was felt.
    for first, last in ((75, 100), (149, 200)):
        x = at_frames(take, np.arange(first, last + 0.9, 0.1))
        assert len(np.unique(np.round(x, 5), axis=0)) == 2


def test_a_take_that_is_appended_to_keeps_its_ticks_whatever_is_chosen(terrain: bpy.types.Object) -> None:
    felt(500)
    take = stop().take
    settings().take_onto, settings().take, settings().keep_ticks = "APPEND", take, False
    bpy.context.scene.frame_set(101)
    felt(500, terrain=terrain, device=circles())
    stop()
    assert len(module("record.kept_take").recall_take(take.animation_data.action)) == 1000


def test_what_only_one_of_two_takes_has_is_told_when_they_are_put_together(
    terrain: bpy.types.Object, capfd: pytest.CaptureFixture[str]
) -> None:
    kept_take = module("record.kept_take")
    felt(500)
    take = stop().take
    action = take.animation_data.action
    data = kept_take.recall_take(action)
    fewer = {name: values for name, values in data.columns.items() if name not in {"buttons", "twist"}}
    kept_take.keep_take(action, replace(data, columns=fewer), 1, ticks=True)
    settings().take_onto, settings().take = "APPEND", take
    bpy.context.scene.frame_set(101)
    felt(500, terrain=terrain, device=circles())
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    assert "Only one of the two takes has buttons, twist" in capfd.readouterr().out
    assert "buttons" not in kept_take.recall_take(action).columns


def test_a_take_of_which_nothing_was_kept_is_not_appended_to_and_nothing_is_lost(
    terrain: bpy.types.Object,
) -> None:
    settings().keep_ticks = False
    felt(500)
    take = stop().take
    settings().take_onto, settings().take = "APPEND", take
    felt(500, terrain=terrain, device=sweep())
    before = contents()
    with pytest.raises(RuntimeError, match="Keep Ticks was off"):
        bpy.ops.haptic_terrain.record_stop()
    assert contents() == before
    settings().take_onto = "NEW"
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    assert len(keys_of(bpy.data.objects["Touch Take.001"])[0]) == 12


def test_a_take_that_is_gone_is_not_missed(terrain: bpy.types.Object) -> None:
    felt(500)
    take = stop().take
    settings().take_onto, settings().take = "REPLACE", take
    bpy.data.objects.remove(take)
    felt(500, terrain=terrain, device=sweep())
    assert stop().take.name == "Touch Take"


def test_a_take_that_cannot_be_written_is_still_there_to_be_written(
    terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_arguments: object, **_named: object) -> None:
        raise MemoryError

    felt(1000)
    before = contents()
    with monkeypatch.context() as patched:
        patched.setattr(module("record.write_take"), "keep_take", fail)
        with pytest.raises(MemoryError):
            module("record.recording").stop_recording(bpy.context)
    assert contents() == before
    assert stop().keyframes == 24


def test_a_recording_can_be_let_go(terrain: bpy.types.Object) -> None:
    felt(500)
    before = contents()
    assert bpy.ops.haptic_terrain.record_discard() == {"FINISHED"}
    assert contents() == before
    with pytest.raises(RuntimeError, match="No take"):
        bpy.ops.haptic_terrain.record_discard()
    assert bpy.ops.haptic_terrain.record_start() == {"FINISHED"}


def test_an_action_has_its_range_and_can_lie_on_an_nla_track(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    scene.frame_set(31)
    felt(1000)
    used = stop().take
    action = used.animation_data.action
    assert action.use_frame_range
    assert (action.frame_start, action.frame_end) == (31.0, 54.0)
    settings().take_nla = True
    felt(1000, terrain=terrain, device=sweep())
    pushed = stop().take
    assert pushed.animation_data.action is None
    (track,) = pushed.animation_data.nla_tracks
    (strip,) = track.strips
    assert (strip.frame_start, strip.frame_end) == (31.0, 54.0)
    for frame in (31, 40, 54):
        scene.frame_set(frame)
        assert pushed.location[:] == pytest.approx(used.location[:], abs=1e-6)
        assert pushed["haptic_terrain_force"] == pytest.approx(used["haptic_terrain_force"], abs=1e-6)
    settings().take_onto, settings().take = "REPLACE", pushed
    for nla in (True, False):
        settings().take_nla = nla
        felt(500, terrain=terrain, device=sweep())
        assert stop().take == pushed
        assert len(pushed.animation_data.nla_tracks) == nla
        assert (pushed.animation_data.action is None) == nla
    assert len(curve(pushed, "location").keyframe_points) == 12


@pytest.mark.parametrize("kind", ["csv", "npz"])
def test_a_take_goes_through_a_file(kind: str, terrain: bpy.types.Object, tmp_path: Path) -> None:
    path = tmp_path / f"take.{kind}"
    recording = felt()
    data = module("record.recording").take_data(recording)
    first = stop().take
    bpy.context.view_layer.objects.active = first
    assert bpy.ops.haptic_terrain.export_take(filepath=str(path)) == {"FINISHED"}
    text = module("record.files.derived").derived_columns(data, ground_of(recording).real)
    assert text["ground_elevation"][data.in_contact] == pytest.approx(
        data.columns["proxy_up"][data.in_contact], abs=1e-3
    )
    bpy.context.view_layer.objects.active = terrain
    assert bpy.ops.haptic_terrain.import_take(filepath=str(path)) == {"FINISHED"}
    second = bpy.data.objects["Touch Take.001"]
    assert keys_of(second) == keys_of(first)
    recall = module("record.kept_take").recall_take
    assert same(recall(second.animation_data.action), data)


def test_a_take_is_exported_after_the_file_was_saved_and_opened(
    terrain: bpy.types.Object, tmp_path: Path
) -> None:
    felt()
    data = module("record.recording").take_data(module("touch.live").live.recording)
    stop()
    blend = tmp_path / "take.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    bpy.ops.wm.open_mainfile(filepath=str(blend))
    bpy.context.view_layer.objects.active = bpy.data.objects["Touch Take"]
    path = tmp_path / "take.csv"
    assert bpy.ops.haptic_terrain.export_take(filepath=str(path)) == {"FINISHED"}
    assert same(module("record.files.csv_file").read_csv(path).data, data)


def test_a_take_of_another_terrain_is_refused_naming_both(terrain: bpy.types.Object, tmp_path: Path) -> None:
    felt(500)
    take = stop().take
    path = tmp_path / "take.csv"
    bpy.context.view_layer.objects.active = take
    bpy.ops.haptic_terrain.export_take(filepath=str(path))
    (tmp_path / "other").mkdir()
    higher = [[height + 1 for height in row] for row in rough(40, 60)]
    for other in (higher, rough(20, 60)):
        label = MegdrPair(other).write(tmp_path / "other")
        bpy.context.view_layer.objects.active = import_grid(label)
        before = contents()
        with pytest.raises(RuntimeError, match=rf"on {terrain.name} .*, not on {terrain.name}\.\d+ "):
            bpy.ops.haptic_terrain.import_take(filepath=str(path))
        assert contents() == before


def test_a_take_of_a_terrain_that_is_gone_is_exported_without_the_ground(
    terrain: bpy.types.Object, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    felt(500)
    bpy.context.view_layer.objects.active = stop().take
    bpy.data.objects.remove(terrain)
    path = tmp_path / "take.csv"
    assert bpy.ops.haptic_terrain.export_take(filepath=str(path)) == {"FINISHED"}
    assert "Without ground elevations" in capfd.readouterr().out
    assert "ground_elevation" not in path.read_text()
    assert len(module("record.files.csv_file").read_csv(path).data) == 500


def test_a_cut_file_is_read_and_the_loss_is_told(
    terrain: bpy.types.Object, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    felt(1000)
    bpy.context.view_layer.objects.active = stop().take
    path = tmp_path / "take.csv"
    bpy.ops.haptic_terrain.export_take(filepath=str(path))
    lines = path.read_text().splitlines(keepends=True)
    path.write_text("".join(lines[:-300])[:-5])
    bpy.context.view_layer.objects.active = terrain
    assert bpy.ops.haptic_terrain.import_take(filepath=str(path)) == {"FINISHED"}
    assert "the last 301 of 1,000 ticks are lost" in capfd.readouterr().out


def test_without_a_take_nothing_is_exported(terrain: bpy.types.Object, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="Select a take"):
        bpy.ops.haptic_terrain.export_take(filepath=str(tmp_path / "take.csv"))
    felt(500)
    take = stop().take
    del take.animation_data.action["haptic_terrain_take"]["columns"]
    with pytest.raises(RuntimeError, match="was changed"):
        bpy.ops.haptic_terrain.export_take(filepath=str(tmp_path / "take.csv"))
    assert not (tmp_path / "take.csv").exists()


@pytest.mark.parametrize("kind", ["csv", "npz", "geojson"])
def test_a_folder_that_cannot_be_written_is_told(
    kind: str, terrain: bpy.types.Object, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    felt(500)
    bpy.context.view_layer.objects.active = stop().take
    with pytest.raises(RuntimeError, match=f"take.{kind} cannot be written: .*Choose another folder"):
        bpy.ops.haptic_terrain.export_take(filepath=str(tmp_path / "no such folder" / f"take.{kind}"))
    assert not (tmp_path / "no such folder").exists()
    if sys.platform == "linux":
        with pytest.raises(RuntimeError, match="cannot be written"):
            bpy.ops.haptic_terrain.export_take(filepath=f"/proc/take.{kind}")


def test_an_ending_that_is_no_format_is_refused(terrain: bpy.types.Object, tmp_path: Path) -> None:
    felt(500)
    bpy.context.view_layer.objects.active = stop().take
    with pytest.raises(RuntimeError, match=r"exported as \.csv, \.npz, \.geojson"):
        bpy.ops.haptic_terrain.export_take(filepath=str(tmp_path / "take.txt"))
    (tmp_path / "take.txt").write_text("nothing")
    with pytest.raises(RuntimeError, match=r"ending: found \.txt"):
        bpy.ops.haptic_terrain.import_take(filepath=str(tmp_path / "take.txt"))


def test_a_whole_take_is_one_step_of_undo(terrain: bpy.types.Object) -> None:
    settings().trail_kinds = {"TUBE", "CURVE", "POINTS"}
    bpy.context.preferences.edit.use_global_undo = True
    felt(1000, modes=("normal", "pan"))
    bpy.ops.ed.undo_push(message="before")
    before = contents()
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    module("touch.stop").stop_touch()
    bpy.ops.ed.undo_push(message="after")
    assert contents() != before
    bpy.ops.ed.undo()
    assert not [thing.name for thing in bpy.data.objects if thing.name.startswith("Touch T")]
    assert not len(bpy.data.actions)
    assert not len(bpy.context.scene.timeline_markers)


def test_in_the_background_nothing_plays_and_the_scene_stays_as_it_is(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    settings().play_timeline = True
    scene.frame_end = 77
    recording = felt(500)
    assert recording.played is None
    assert (scene.sync_mode, scene.frame_end) == ("NONE", 77)
    stop()


def test_how_a_scene_was_played_is_put_back(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    played = module("touch.live").Played("AUDIO_SYNC", 77, True)
    scene.sync_mode, scene.frame_end = "FRAME_DROP", 1_000_000
    recording = felt(500)
    recording.played = played
    stop()
    assert (scene.sync_mode, scene.frame_end, scene.use_preview_range) == ("AUDIO_SYNC", 77, True)


def test_a_file_gets_the_ending_of_the_chosen_format() -> None:
    operator = module("ui.take_operators").HAPTIC_TERRAIN_OT_export_take
    chosen = SimpleNamespace(filepath="/somewhere/take.csv", format="GEOJSON")
    assert operator.check(chosen, bpy.context)
    assert chosen.filepath == str(Path("/somewhere/take.geojson"))
    assert not operator.check(chosen, bpy.context)
    assert not operator.check(SimpleNamespace(filepath="", format="CSV"), bpy.context)
