"""The extension's zip, in a Blender whose configuration is a folder of the test's own."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

BEGIN = """
import sys
from pathlib import Path
import bpy
import addon_utils
MODULE = "bl_ext.user_default.haptic_terrain"
EXTENSIONS = Path(bpy.utils.user_resource("EXTENSIONS"))

def install(packed):
    done = bpy.ops.extensions.package_install_files(
        filepath=str(packed), repo="user_default", enable_on_install=True, overwrite=True)
    assert done == {"FINISHED"}, done

def is_list(handlers):
    return isinstance(getattr(bpy.app.handlers, handlers), list)

def named(thing):
    return f"{thing.__module__}.{getattr(thing, '__qualname__', thing)}"

def appended(name):
    drawn = getattr(getattr(getattr(bpy.types, name), "draw", None), "_draw_funcs", [])
    return [named(one) for one in drawn[1:]]  # the first is Blender's own

def registered():
    types = bpy.types
    bases = (types.Operator, types.Panel, types.PropertyGroup, types.Menu, types.AddonPreferences)
    found = [one for base in bases for one in base.__subclasses__() if one.is_registered]
    return sorted(named(one) for one in found if one.__module__.startswith(MODULE))

def snapshot():
    '''Everything of Blender's that an extension may add to.'''
    kinds = ("Scene", "Object", "Mesh", "WindowManager", "Material", "Collection")
    keys = bpy.context.window_manager.keyconfigs.addon
    keymaps = [] if keys is None else keys.keymaps
    return {
        "classes": sorted(dir(bpy.types)),
        "registered": registered(),
        "operators": sorted(f"{group}.{name}" for group in dir(bpy.ops)
                            for name in dir(getattr(bpy.ops, group))),
        "handlers": {name: [named(one) for one in getattr(bpy.app.handlers, name)]
                     for name in dir(bpy.app.handlers) if is_list(name)},
        "menus": {name: appended(name) for name in dir(bpy.types) if appended(name)},
        "properties": {kind: sorted(getattr(bpy.types, kind).bl_rna.properties.keys()) for kind in kinds},
        "keys": sorted((keymap.name, item.idname) for keymap in keymaps for item in keymap.keymap_items),
        "presets": list(bpy.utils.preset_paths("haptic_terrain_touch")),
        "addons": sorted(bpy.context.preferences.addons.keys()),
        "path": sorted(sys.path),
    }

def differences(before, after):
    told = {name: set(map(str, flat(before[name]))) ^ set(map(str, flat(after[name]))) for name in before}
    return {name: sorted(changed) for name, changed in told.items() if changed}

def flat(facts):
    '''Lists, also those of a dictionary, with the key before each entry.'''
    if isinstance(facts, dict):
        return [(key, value) for key, values in facts.items() for value in values]
    return facts
"""

Run = Callable[..., str]


@pytest.fixture(scope="session")
def packed() -> Path:
    """Give the zip."""
    named = os.environ.get("HAPTIC_TERRAIN_ZIP")
    if not named:
        pytest.skip("HAPTIC_TERRAIN_ZIP does not name the extension's zip; see make test-matrix")
    return Path(named).resolve()


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """Run a script in a Blender of its own, after ``BEGIN``; gives what it prints."""

    def run_script(script: str, *arguments: Path) -> str:
        kept = {
            name: value for name, value in os.environ.items() if not name.startswith(("BLENDER_", "PYTHON"))
        }
        folders = {
            "BLENDER_USER_RESOURCES": str(tmp_path / "user"),
            "XDG_CACHE_HOME": str(tmp_path / "cache"),
        }
        done = subprocess.run(
            [sys.executable, "-B", "-c", BEGIN + script, *map(str, arguments)],
            env=kept | folders,
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        assert "Traceback" not in done.stderr, done.stderr
        return done.stdout

    return run_script
