"""An update over an older version: its native code stays loaded until Blender is started again.

Python drops the add-on's own modules when it is updated, but no process lets go of a native module. New code
on top of old native code would fail in odd ways, so nothing but a message is registered then.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import bpy
import proxygraph

MANIFEST = Path(__file__).with_name("blender_manifest.toml")

TAB = "Haptic Terrain"
"""As in ``ui.sidebar``, which must not be imported here: what is below it needs the right native code."""


def own_version() -> str:
    """The version that the manifest states."""
    version = tomllib.loads(MANIFEST.read_text(encoding="utf-8"))["version"]
    return str(version)


def is_needed() -> bool:
    """Whether the loaded native code is of another version."""
    return proxygraph.__version__ != own_version()


def message() -> str:
    """What the person is told."""
    return (
        f"Haptic Terrain {own_version()} is installed, but version {proxygraph.__version__} is still loaded: "
        "restart Blender"
    )


class HAPTIC_TERRAIN_PT_restart(bpy.types.Panel):
    """Stands in the sidebar for all other panels"""

    bl_label = "Restart Blender"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB

    def draw(self, context: bpy.types.Context) -> None:
        """Say why."""
        draw(self.layout)


class HapticTerrainRestart(bpy.types.AddonPreferences):
    """Stands in the preferences, where the person is when they update"""

    bl_idname = str(__package__)

    def draw(self, context: bpy.types.Context) -> None:
        """Say why."""
        draw(self.layout)


def draw(layout: bpy.types.UILayout | None) -> None:
    """The message, and the way out: what is not saved is asked about."""
    if layout is None:
        return
    for line in message().split(", "):
        layout.label(text=line)
    layout.operator("wm.quit_blender", text="Quit Blender", icon="QUIT")


CLASSES = (HAPTIC_TERRAIN_PT_restart, HapticTerrainRestart)


def register() -> None:
    """Show the message, and nothing else."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    print(message())


def unregister() -> None:
    """Take it back."""
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
