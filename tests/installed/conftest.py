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
import addon_utils, bpy
MODULE = "bl_ext.user_default.haptic_terrain"
EXTENSIONS = Path(bpy.utils.user_resource("EXTENSIONS"))

def install(packed):
    done = bpy.ops.extensions.package_install_files(
        filepath=str(packed), repo="user_default", enable_on_install=True, overwrite=True)
    assert done == {"FINISHED"}, done

def snapshot():
    '''Everything of Blender's that an extension may add to.'''
    handlers = {name: [str(one) for one in getattr(bpy.app.handlers, name)]
                for name in dir(bpy.app.handlers) if isinstance(getattr(bpy.app.handlers, name), list)}
    menus = {name: [str(one) for one in getattr(getattr(bpy.types, name), "draw", None)._draw_funcs]
             for name in dir(bpy.types) if hasattr(getattr(getattr(bpy.types, name), "draw", None), "_draw_funcs")}
    # A menu that was added to once keeps its list, with Blender's own draw in it.
    menus = {name: drawn for name, drawn in menus.items() if len(drawn) > 1}
    keys = bpy.context.window_manager.keyconfigs.addon
    return {
        "classes": sorted(dir(bpy.types)),
        "subclasses": sorted({str(one) for base in (bpy.types.Operator, bpy.types.Panel, bpy.types.PropertyGroup,
            bpy.types.Menu, bpy.types.AddonPreferences, bpy.types.FileHandler) for one in base.__subclasses__()
            if getattr(one, "is_registered", False)}),
        "operators": sorted(f"{group}.{name}" for group in dir(bpy.ops) for name in dir(getattr(bpy.ops, group))),
        "handlers": handlers,
        "menus": menus,
        "properties": {kind: sorted(getattr(bpy.types, kind).bl_rna.properties.keys())
                       for kind in ("Scene", "Object", "Mesh", "WindowManager", "Material", "Collection")},
        "keys": [] if keys is None else sorted((keymap.name, item.idname) for keymap in keys.keymaps
                                               for item in keymap.keymap_items),
        "presets": list(bpy.utils.preset_paths("haptic_terrain")),
        "addons": sorted(bpy.context.preferences.addons.keys()),
        "path": sorted(sys.path),
    }

def differences(before, after):
    return {name: (before[name], after[name]) for name in before if before[name] != after[name]}
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
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("BLENDER_", "PYTHON"))}
        folders = {"BLENDER_USER_RESOURCES": str(tmp_path / "user"), "XDG_CACHE_HOME": str(tmp_path / "cache")}
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
