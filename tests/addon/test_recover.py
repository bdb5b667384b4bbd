"""Takes on the disk: while they are recorded, and after a crash."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import bpy
import pytest
from proxygraph import ScriptedDevice

from tests.addon.hands import circles, sweep
from tests.addon.scene import contents, import_grid, keys_of, module
from tests.addon.takes import about
from tests.formats.megdr_pair import MegdrPair, planet, rough

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def spools(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder for takes, empty and of the test's own."""
    folder = tmp_path / "takes"
    monkeypatch.setattr(module("touch.live").live, "spool_folder", folder)
    return folder


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(device: ScriptedDevice, **options: Any) -> Any:
    """Start touch, stepped."""
    return module("touch.start").start_touch(bpy.context, on_the_clock=False, device=device, **options)


def crash(touch: Any, ticks: int = 1000) -> None:
    """Record, and forget all about it as a process does that ends."""
    live = module("touch.live").live
    bpy.ops.haptic_terrain.record_start()
    for _second in range(0, ticks, 1000):
        touch.session.step(min(1000, ticks))
    live.recording = live.touch = None
    touch.session.stop()
    del touch.session


def recover() -> Any:
    return module("record.recover").recover_take(bpy.context)


def test_a_take_is_on_the_disk_until_it_is_in_the_scene(terrain: bpy.types.Object, spools: Path) -> None:
    touch = start(circles())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(2500)
    (spool,) = spools.iterdir()
    assert spool.name.endswith(".touch")
    with pytest.raises(RuntimeError, match="A take is being recorded"):
        bpy.ops.haptic_terrain.recover_take()
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    assert list(spools.iterdir()) == []


def test_a_take_that_was_left_is_written_as_if_nothing_had_happened(
    terrain: bpy.types.Object, spools: Path
) -> None:
    touch = start(sweep(0.9))
    bpy.context.scene.frame_set(20)
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(1000)
    keys = keys_of(module("record.recording").stop_recording(bpy.context).take)
    bpy.ops.haptic_terrain.touch_stop()
    crash(start(sweep(0.9), terrain=terrain))
    bpy.context.scene.frame_set(1)
    recovered = recover()
    assert keys_of(recovered.written.take) == keys
    assert recovered.written.take["haptic_terrain_models"] == "surface_walk"
    assert (recovered.written.dropped, recovered.lost) == (0, None)
    assert recovered.written.trail is not None
    assert list(spools.iterdir()) == []


def test_the_newest_take_is_recovered_first_and_then_the_others(
    terrain: bpy.types.Object, spools: Path
) -> None:
    for seconds, ticks in ((100, 1000), (200, 2000)):
        crash(start(circles(), terrain=terrain), ticks)
        newest = max(spools.iterdir(), key=lambda path: path.stat().st_mtime_ns)
        os.utime(newest, (seconds, seconds))
    assert [recover().written.seconds for _ in range(2)] == [pytest.approx(1.999), pytest.approx(0.999)]
    with pytest.raises(RuntimeError, match="no take to recover"):
        recover()


def test_where_no_take_was_left_that_is_said(
    terrain: bpy.types.Object, spools: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    assert bpy.ops.haptic_terrain.recover_take() == {"CANCELLED"}
    assert "There is no take to recover." in capfd.readouterr().out


def test_a_take_that_another_blender_records_is_left_alone(terrain: bpy.types.Object, spools: Path) -> None:
    touch = start(circles())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(2000)
    live = module("touch.live").live
    recording, live.recording = live.recording, None  # as if it were another's
    with pytest.raises(RuntimeError, match="no take to recover"):
        recover()
    assert len(list(spools.iterdir())) == 1
    live.recording = recording
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}


def test_a_take_of_another_terrain_is_refused_and_names_both(
    terrain: bpy.types.Object, spools: Path, tmp_path: Path
) -> None:
    crash(start(circles()))
    title = module("terrain.kept").recall(terrain).grid.title
    bpy.data.objects.remove(terrain)
    with pytest.raises(RuntimeError, match="no terrain"):
        recover()
    (tmp_path / "other").mkdir()
    other = import_grid(planet().write(tmp_path / "other"))
    before = contents()
    with pytest.raises(RuntimeError) as refused:
        recover()
    assert title in str(refused.value)
    assert module("terrain.kept").recall(other).grid.title in str(refused.value)
    assert contents() == before
    assert len(list(spools.iterdir())) == 1
    import_grid(next(tmp_path.glob("*.lbl")))
    assert recover().written.seconds == pytest.approx(0.999)


def test_a_file_cut_short_is_recovered_as_far_as_it_is_whole(
    terrain: bpy.types.Object, spools: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    crash(start(circles()), 3000)
    (spool,) = spools.iterdir()
    os.truncate(spool, spool.stat().st_size - 100)
    assert bpy.ops.haptic_terrain.recover_take() == {"FINISHED"}
    assert "Not all of the take was left: the file was cut short" in capfd.readouterr().out
    assert len(keys_of(bpy.data.objects["Touch Take"])[0]) > 20


def test_a_file_of_which_nothing_is_whole_stays_and_is_told(terrain: bpy.types.Object, spools: Path) -> None:
    crash(start(circles()))
    (spool,) = spools.iterdir()
    os.truncate(spool, spool.stat().st_size - 100)
    with pytest.raises(RuntimeError, match=r"\.touch: the file was cut short"):
        recover()
    assert list(spools.iterdir()) == [spool]


def test_what_is_no_take_stays_and_is_named(terrain: bpy.types.Object, spools: Path) -> None:
    spools.mkdir()
    (spools / "junk.touch").write_text("junk")
    with pytest.raises(RuntimeError, match=r"junk\.touch: this is no take"):
        recover()
    crash(start(circles()))
    assert recover().written.seconds == pytest.approx(0.999)
    assert [path.name for path in spools.iterdir()] == ["junk.touch"]


def test_a_take_that_cannot_be_written_to_the_scene_waits_and_stays_on_the_disk(
    terrain: bpy.types.Object, spools: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_arguments: object, **_named: object) -> None:
        raise MemoryError

    touch = start(sweep())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(1000)
    with monkeypatch.context() as broken:
        broken.setattr(module("record.recording"), "write_take", fail)
        with pytest.raises(MemoryError):
            module("record.recording").stop_recording(bpy.context)
    assert len(list(spools.iterdir())) == 1
    assert module("record.recording").stop_recording(bpy.context).seconds == pytest.approx(0.999)
    assert list(spools.iterdir()) == []


def test_an_empty_take_leaves_no_file(terrain: bpy.types.Object, spools: Path) -> None:
    start(circles())
    bpy.ops.haptic_terrain.record_start()
    assert bpy.ops.haptic_terrain.record_stop() == {"CANCELLED"}
    assert list(spools.iterdir()) == []


def test_where_the_disk_cannot_be_used_the_take_is_in_memory_and_that_is_said(
    terrain: bpy.types.Object, spools: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    spools.write_text("a file where the folder should be")
    touch = start(circles())
    assert bpy.ops.haptic_terrain.record_start() == {"FINISHED"}
    assert "The take is in memory only" in capfd.readouterr().out
    recording = module("touch.live").live.recording
    assert str(spools) in module("ui.panel").spool_trouble(recording)
    touch.session.step(1000)
    assert module("record.recording").stop_recording(bpy.context).seconds == pytest.approx(0.999)


@pytest.mark.parametrize("has_ended", [False, True])
def test_a_take_whose_file_was_loaded_away_is_recovered_in_its_file(
    terrain: bpy.types.Object, spools: Path, tmp_path: Path, has_ended: bool
) -> None:
    blend = str(tmp_path / "terrain.blend")
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    touch = start(circles())
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(1000)
    if has_ended:
        bpy.ops.haptic_terrain.touch_stop()
    bpy.ops.wm.open_mainfile(filepath=blend)
    assert "Recover Last Take" in module("touch.live").live.message
    assert recover().written.seconds == pytest.approx(0.999)


def test_a_pre_roll_begins_the_take(terrain: bpy.types.Object, spools: Path) -> None:
    scene = bpy.context.scene
    scene.haptic_terrain.pre_roll = 0.5
    touch = start(circles())
    touch.session.step(2000)
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(1000)
    assert module("record.recording").stop_recording(bpy.context).seconds == pytest.approx(1.499)
    scene.haptic_terrain.pre_roll = 0.0  # at once
    bpy.ops.haptic_terrain.record_start()
    touch.session.step(1000)
    assert module("record.recording").stop_recording(bpy.context).seconds == pytest.approx(0.999)


KILLED = """
import sys, time
from pathlib import Path
from enable_addon import MODULE, enable
enable()
import bpy, importlib
live = importlib.import_module(f"{MODULE}.touch.live").live
live.spool_folder = Path(sys.argv[2])
bpy.ops.haptic_terrain.import_grid(filepath=sys.argv[1])
bpy.ops.haptic_terrain.touch_start()
bpy.ops.haptic_terrain.record_start()
while True:
    print("spooled", live.touch.session.recording.spooled, flush=True)
    time.sleep(0.01)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_a_take_of_a_blender_that_was_killed_is_recovered(tmp_path: Path, spools: Path) -> None:
    label = MegdrPair(rough(40, 60)).write(tmp_path)
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT / "blender_scripts"),
        "BLENDER_USER_RESOURCES": str(tmp_path / "resources"),
    }
    command = [sys.executable, "-c", KILLED, str(label), str(spools)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        assert process.stdout is not None
        spooled = 0
        for line in process.stdout:
            if line.startswith("spooled"):
                spooled = int(line.split()[1])
            if spooled > 500:
                break
        os.kill(process.pid, signal.SIGKILL)
    assert spooled > 500
    import_grid(label)
    kept = module("record.kept_take")
    assert len(kept.recall_take(kept.take_action(recover().written.take))) >= spooled
    assert list(spools.iterdir()) == []


@pytest.mark.parametrize("damaged", ['{"georeference": 3}', "[" * 100_000, "3"])
def test_a_text_about_a_take_that_was_damaged_is_refused(damaged: str) -> None:
    with pytest.raises(ValueError, match=r"\w"):
        module("record.spool_text").from_spool_text(damaged)


@pytest.mark.parametrize("damaged", [3, [], "Mars", None, {}, {"ellipsoid": 3}])
def test_a_text_about_a_take_with_a_damaged_place_is_refused(damaged: Any) -> None:
    spool_text = module("record.spool_text")
    told = json.loads(spool_text.spool_text(about(), 1))
    with pytest.raises(ValueError, match=r"\w"):
        spool_text.from_spool_text(json.dumps({**told, "georeference": damaged}))
