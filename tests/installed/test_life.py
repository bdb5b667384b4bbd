"""The zip, installed, enabled and disabled over and over, updated, and taken away again."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

from tests.installed.conftest import Run


def test_it_installs_works_and_goes_without_a_trace(run: Run, packed: Path) -> None:
    told = run(
        """
before = snapshot()
install(Path(sys.argv[1]))
assert "HAPTIC_TERRAIN_OT_import_grid" in dir(bpy.types)
import proxygraph
assert Path(proxygraph.__file__).is_relative_to(EXTENSIONS), proxygraph.__file__
assert differences(before, snapshot()).keys() >= {"classes", "operators", "handlers", "menus", "properties"}
assert bpy.ops.extensions.package_uninstall(repo_index=[
    one.module for one in bpy.context.preferences.extensions.repos].index("user_default"),
    pkg_id="haptic_terrain") == {"FINISHED"}
left = differences(before, snapshot())
# Blender's own folder for the wheels of all extensions; it is empty then.
assert all(Path(path).is_relative_to(EXTENSIONS / ".local") for path in left.pop("path", []))
assert left == {}, left
assert not (EXTENSIONS / "user_default" / "haptic_terrain").exists()
names = [path.name for path in EXTENSIONS.rglob("*") if "proxygraph" in path.name or "hidapi" in path.name]
assert names == [], names
print("GONE")
""",
        packed,
    )
    assert "GONE" in told


def test_it_can_be_disabled_and_enabled_a_hundred_times(run: Run, packed: Path) -> None:
    told = run(
        """
install(Path(sys.argv[1]))
enabled = snapshot()
addon_utils.disable(MODULE, default_set=True)
disabled = snapshot()
assert disabled != enabled
for number in range(100):
    assert addon_utils.enable(MODULE, default_set=True) is not None
    if number % 20 == 0:
        assert differences(enabled, snapshot()) == {}, differences(enabled, snapshot())
    addon_utils.disable(MODULE, default_set=True)
assert differences(disabled, snapshot()) == {}, differences(disabled, snapshot())
print("STEADY")
""",
        packed,
    )
    assert "STEADY" in told


def of_version(packed: Path, place: Path, version: str) -> Path:
    """Make the zip of another version of the add-on, with the same native code."""
    with zipfile.ZipFile(packed) as old, zipfile.ZipFile(place, "w") as new:
        for entry in old.infolist():
            content = old.read(entry)
            if entry.filename.endswith("blender_manifest.toml"):
                lines = content.decode().splitlines()
                lines = [f'version = "{version}"' if line.startswith("version =") else line for line in lines]
                content = "\n".join(lines).encode()
            new.writestr(entry, content)
    return place


def test_an_update_over_loaded_native_code_asks_for_a_restart(run: Run, packed: Path, tmp_path: Path) -> None:
    newer = of_version(packed, tmp_path / "newer.zip", "9.9.9")
    told = run(
        """
install(Path(sys.argv[1]))
before = snapshot()
install(Path(sys.argv[2]))
assert MODULE in bpy.context.preferences.addons
types = [name for name in dir(bpy.types) if name.startswith("HAPTIC")]
assert types == ["HAPTIC_TERRAIN_PT_restart"], types
assert not hasattr(bpy.types.Scene, "haptic_terrain")
addon_utils.disable(MODULE, default_set=True)
assert [name for name in dir(bpy.types) if name.startswith("HAPTIC")] == []
install(Path(sys.argv[1]))
assert "HAPTIC_TERRAIN_OT_import_grid" in dir(bpy.types)
assert differences(before, snapshot()) == {}, differences(before, snapshot())
""",
        packed,
        newer,
    )
    assert "9.9.9 is installed, but version" in told
    assert "restart Blender" in told


def test_it_works_offline_and_without_the_network(run: Run, packed: Path, tmp_path: Path) -> None:
    copy = shutil.copy(packed, tmp_path / "dropped.zip")
    told = run(
        """
import socket
def refuse(*arguments, **named):
    raise AssertionError("the network was used")
socket.socket.connect = socket.create_connection = refuse
bpy.context.preferences.system.use_online_access = False
install(Path(sys.argv[1]))
assert "HAPTIC_TERRAIN_OT_import_grid" in dir(bpy.types)
print("WORKS")
""",
        Path(copy),
    )
    assert "WORKS" in told
