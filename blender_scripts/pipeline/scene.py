"""The scene that a script works in, and the extension's parts that it calls."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from enable_addon import MODULE, enable

from pipeline.command import RefusedError

if TYPE_CHECKING:
    import bpy

RESOURCES = Path(__file__).resolve().parents[2] / "build" / "blender-user"
"""Blender's own files while scripts run, where nothing else is said: never the person's."""


class Parts:
    """Modules of the enabled extension, by name: scripts reach them under its installed name."""

    def __init__(self, package: str) -> None:
        self._package = package

    def __call__(self, name: str) -> ModuleType:
        """Import a part, such as ``record.bake``."""
        return import_module(f"{self._package}.{name}")


def enabled_parts() -> Parts:
    """Use the extension that is enabled in the person's Blender, else enable that of this checkout.

    Raises:
        RefusedError: it cannot be enabled.
    """
    if "bpy" in sys.modules:
        import addon_utils

        if MODULE in sys.modules and addon_utils.check(MODULE)[1]:
            return Parts(MODULE)
    elif "BLENDER_USER_RESOURCES" not in os.environ:
        RESOURCES.mkdir(parents=True, exist_ok=True)
        os.environ["BLENDER_USER_RESOURCES"] = str(RESOURCES)
    try:
        return Parts(enable().__name__)
    except RuntimeError as error:
        raise RefusedError(str(error)) from error


def open_blend(blend: Path | None) -> bpy.types.Scene:
    """Open a scene, or stay in the one that is open.

    Raises:
        RefusedError: it cannot be opened.
    """
    import bpy

    if blend is not None:
        if not blend.is_file():
            raise RefusedError(f"{blend}: there is no such file.")
        try:
            bpy.ops.wm.open_mainfile(filepath=str(blend.resolve()), load_ui=False)
        except RuntimeError as error:
            raise RefusedError(f"{blend}: {str(error).removeprefix('Error: ').strip()}") from error
    scene = bpy.context.scene
    if scene is None:
        raise RefusedError("No scene is open.")
    return scene


def import_grid(grid: Path) -> None:
    """Import a grid as a terrain.

    Raises:
        RefusedError: it cannot be used.
    """
    import bpy

    with refused():
        bpy.ops.haptic_terrain.import_grid(filepath=str(grid.resolve()))


@contextmanager
def refused() -> Iterator[None]:
    """Tell what the extension refuses as what a person can mend."""
    try:
        yield
    except (RuntimeError, ValueError) as error:
        raise RefusedError(str(error).removeprefix("Error: ").strip()) from error


def save_blend(file: Path) -> None:
    """Save the scene; an older file is replaced only by a whole one.

    Raises:
        OSError: it cannot be written.
    """
    import bpy

    beginning = file.with_name(f".{file.stem}.part.blend")
    try:
        try:
            bpy.ops.wm.save_as_mainfile(filepath=str(beginning.resolve()), compress=True, copy=True)
        except RuntimeError as error:
            raise OSError(f"{file}: {str(error).removeprefix('Error: ').strip()}") from error
        beginning.replace(file)
    finally:
        beginning.unlink(missing_ok=True)
