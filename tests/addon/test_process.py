"""What a whole Blender process does: where it writes, how it ends, and that it lives."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.formats.megdr_pair import MegdrPair, rough

ROOT = Path(__file__).resolve().parents[2]

BEGIN = """
import os, sys, time
from pathlib import Path
from enable_addon import MODULE, enable
enable()
import bpy, importlib
part = lambda name: importlib.import_module(f"{MODULE}.{name}")
live = part("touch.live").live
tick = part("touch.tick").tick
label = Path(sys.argv[1])
bpy.ops.haptic_terrain.import_grid(filepath=str(label))
"""

TRUNCATE = """
from proxygraph import Window
bpy.ops.haptic_terrain.touch_start()
target = bpy.data.objects["Touch Target"]
target.location.z = -1.0
bpy.context.view_layer.update()
def wait_for(what):
    end = time.monotonic() + 60.0
    while not what():
        assert time.monotonic() < end, "waited in vain"
        tick()
        time.sleep(0.01)
wait_for(lambda: live.touch.readout.in_contact)
session = live.touch.session
os.truncate(label.with_suffix(".img"), 0)
# The hand moves on over samples that are gone.
target.location.x = 3.0
bpy.context.view_layer.update()
wait_for(lambda: live.touch is None)
assert not session.running
assert session.state().force == (0.0, 0.0, 0.0)
print("MESSAGE", live.message)
"""


def run(
    script: str, label: Path, home: Path, *options: str, resources: Path | None = None
) -> subprocess.CompletedProcess[str]:
    """Run a script in a Blender of its own whose home folder is watched."""
    environment = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("BLENDER_", "XDG_", "PYTHON"))
    }
    environment |= {
        "HOME": str(home),
        "USERPROFILE": str(home),
        "PYTHONPATH": os.pathsep.join([str(ROOT / "blender_scripts")]),
        "BLENDER_USER_RESOURCES": str(resources or home.parent / "resources"),
    }
    return subprocess.run(
        [sys.executable, "-B", *options, "-c", BEGIN + script, str(label)],
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


@pytest.fixture
def home(tmp_path: Path) -> Path:
    folder = tmp_path / "home"
    folder.mkdir()
    return folder


@pytest.fixture
def label(tmp_path: Path) -> Path:
    return MegdrPair(rough(400, 900), pixels_per_degree=10.0).write(tmp_path)


def test_nothing_is_written_into_the_home_folder(label: Path, home: Path, tmp_path: Path) -> None:
    script = """
bpy.ops.haptic_terrain.touch_start()
bpy.ops.haptic_terrain.record_start()
live.touch.session.stop(); live.touch.session.step(200)
bpy.ops.haptic_terrain.record_stop()
bpy.ops.wm.save_userpref()
"""
    before = {path.name for path in tmp_path.iterdir()}
    done = run(script, label, home)
    assert done.returncode == 0, done.stderr
    assert list(home.rglob("*")) == []
    assert {path.name for path in tmp_path.iterdir()} - before == {"resources"}
    assert any((tmp_path / "resources").rglob("userpref.blend"))


def test_enabling_refuses_to_use_a_person_s_own_configuration(home: Path) -> None:
    environment = {name: value for name, value in os.environ.items() if not name.startswith("BLENDER_")}
    environment |= {"HOME": str(home), "PYTHONPATH": str(ROOT / "blender_scripts")}
    done = subprocess.run(
        [sys.executable, "-c", "import enable_addon; enable_addon.enable()"],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode != 0
    assert "BLENDER_USER_RESOURCES" in done.stderr


@pytest.mark.parametrize("options", [(), ("-X", "faulthandler")])
def test_a_file_cut_in_mid_contact_stops_touch_and_blender_lives(
    label: Path, home: Path, options: tuple[str, ...]
) -> None:
    done = run(TRUNCATE, label, home, *options)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "MESSAGE Touch stopped: " in done.stdout


def test_blender_quits_while_touching(label: Path, home: Path) -> None:
    done = run(
        "bpy.ops.haptic_terrain.touch_start()\nprint('TOUCHING', live.touch.session.running)", label, home
    )
    assert done.returncode == 0, done.stderr
    assert "TOUCHING True" in done.stdout
