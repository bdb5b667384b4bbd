"""A take written by one version of Blender and opened by another.

    PYTHON_OF_ONE tests/addon/take_across_versions.py write FOLDER
    PYTHON_OF_ANOTHER tests/addon/take_across_versions.py check FOLDER

``write`` leaves take.blend and what is in it; ``check`` says what it found, and fails where that differs.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

from enable_addon import enable, use_resources  # noqa: E402

RESOURCES = ROOT / "build" / "test-resources" / f"{sys.version_info.major}.{sys.version_info.minor}"
RESOURCES.mkdir(parents=True, exist_ok=True)
use_resources(RESOURCES)

import bpy  # noqa: E402

from tests.addon.hands import sweep  # noqa: E402
from tests.addon.scene import curves_of, import_grid, module  # noqa: E402
from tests.addon.takes import same  # noqa: E402
from tests.formats.megdr_pair import MegdrPair, rough  # noqa: E402

TAKES = ("Touch Take", "Touch Take.001")
"""The first with its action in use, the second with it on an NLA track."""


def main() -> None:
    """Write, or check."""
    what, folder = sys.argv[1], Path(sys.argv[2])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    enable()
    (write if what == "write" else check)(folder)


def write(folder: Path) -> None:
    """Record two takes, and keep the .blend, the ticks and every key."""
    folder.mkdir(parents=True, exist_ok=True)
    terrain = import_grid(MegdrPair(rough(40, 60)).write(folder))
    settings = bpy.context.scene.haptic_terrain
    settings.trail_kinds = {"TUBE", "CURVE", "POINTS"}
    for name, nla in zip(TAKES, (False, True), strict=True):
        settings.take_nla = nla
        start = module("touch.start").start_touch
        touch = start(bpy.context, terrain=terrain, device=sweep(), modes=True, on_the_clock=False)
        module("record.recording").start_recording(bpy.context)
        touch.session.step(1000)
        touch.session.set_mode("pan")
        touch.session.step(1000)
        take = module("record.recording").stop_recording(bpy.context).take
        module("touch.stop").stop_touch()
        bpy.context.view_layer.objects.active = take
        bpy.ops.haptic_terrain.export_take(filepath=str(folder / f"{name}.npz"))
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "take.blend"))
    np.save(folder / "seen.npy", np.stack([seen(name) for name in TAKES]))
    print(f"{bpy.app.version_string}: wrote {folder / 'take.blend'}")


def check(folder: Path) -> None:
    """Open the .blend: the same curves at every frame, the same ticks, the trails and the markers."""
    bpy.ops.wm.open_mainfile(filepath=str(folder / "take.blend"))
    enable()
    read, recall = module("record.files.npz_file").read_npz, module("record.kept_take")
    for name, before in zip(TAKES, np.load(folder / "seen.npy"), strict=True):
        take = bpy.data.objects[name]
        assert recall.is_take(take), f"{name} is no take any more"
        assert np.abs(seen(name) - before).max() <= 1e-6, f"{name} moves otherwise"
        ticks = recall.recall_take(recall.take_action(take))
        assert same(ticks, read(folder / f"{name}.npz").data), f"{name} has other ticks"
        (home,) = take.users_collection
        assert len(home.objects) == 4, f"{name} has lost a trail"
    assert len(curves_of(bpy.data.objects[TAKES[0]])) == 6
    assert len(bpy.context.scene.timeline_markers) == 2
    print(f"{bpy.app.version_string}: the same takes as when they were written")


def seen(name: str) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Place, force, depth and mode of a take at every frame."""
    scene, take = bpy.context.scene, bpy.data.objects[name]
    rows = []
    for frame in range(1, 60):
        scene.frame_set(frame)
        numbers = [take[f"haptic_terrain_{of_it}"] for of_it in ("force", "depth", "mode")]
        rows.append([*take.location[:], *numbers])
    return np.array(rows)


if __name__ == "__main__":
    main()
