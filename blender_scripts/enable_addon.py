"""Make this checkout's add-on, or a zip that was built of it, an installed extension, for whoever runs it."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from types import ModuleType

MODULE = "bl_ext.user_default.haptic_terrain"

ADDON = Path(__file__).resolve().parents[1] / "addon"

ZIP = "HAPTIC_TERRAIN_ZIP"
"""The environment variable that names an extension's zip to be installed instead of this checkout."""


def use_resources(folder: Path) -> None:
    """Keep Blender away from the person's own files; call it before bpy is imported first.

    Args:
        folder: for configuration, extensions and thumbnails.
    """
    os.environ["BLENDER_USER_RESOURCES"] = str(folder.resolve())
    # Blender makes its folders for thumbnails here, or in the home folder.
    os.environ["XDG_CACHE_HOME"] = str(folder.resolve() / "cache")


def enable(resources: Path | None = None) -> ModuleType:
    """Enable the checkout's ``addon/``, or what ``ZIP`` names, as the extension ``MODULE``; give its package.

    Args:
        resources: see ``use_resources``; where it is left out, ``BLENDER_USER_RESOURCES`` must say.

    Raises:
        RuntimeError: no folder is set, or the extension cannot be enabled.
    """
    folder = resources or os.environ.get("BLENDER_USER_RESOURCES")
    if not folder:
        raise RuntimeError("Set BLENDER_USER_RESOURCES: a person's own configuration is not for scripts.")
    use_resources(Path(folder))
    import bpy

    extensions = Path(bpy.utils.user_resource("EXTENSIONS", path="user_default", create=True))
    if not extensions.is_relative_to(Path(folder).resolve()):
        raise RuntimeError("bpy was imported before BLENDER_USER_RESOURCES was set.")
    place, packed = extensions / MODULE.rpartition(".")[2], os.environ.get(ZIP)
    if packed:
        _install(Path(packed), place)
    else:
        _offer(place)

    import addon_utils  # bpy brings it

    failures: list[Exception] = []
    module = addon_utils.enable(MODULE, default_set=True, handle_error=failures.append)
    if module is None:
        raise RuntimeError(f"The extension cannot be enabled: {failures}")
    return module


def _offer(place: Path) -> None:
    """Link the checkout there, or copy it where links are not allowed."""
    if place.is_symlink():
        place.unlink()
    elif place.is_dir():
        shutil.rmtree(place)
    try:
        place.symlink_to(ADDON, target_is_directory=True)
    except OSError:
        shutil.copytree(ADDON, place, ignore=shutil.ignore_patterns("__pycache__"))


def _install(packed: Path, place: Path) -> None:
    """Install a zip as a person does who drops it on Blender; once, as long as it does not change."""
    import bpy

    stamp = place.with_name(f".{place.name}.installed")
    told = f"{packed.resolve()} {packed.stat().st_mtime_ns}"
    if place.is_dir() and stamp.is_file() and stamp.read_text(encoding="utf-8") == told:
        return
    if place.is_symlink():
        place.unlink()
    bpy.ops.extensions.package_install_files(
        filepath=str(packed.resolve()), repo="user_default", enable_on_install=False, overwrite=True
    )
    stamp.write_text(told, encoding="utf-8")
