"""Presets of touch and of imports, by Blender's own means: menus, a person's own ones beside ours.

Ours lie in ``presets/`` in the extension, the person's where Blender keeps all of theirs.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
from bl_operators.presets import AddPresetBase

HOME = str(Path(__file__).parents[1])
"""Of the folder ``presets``."""

TOUCH = "haptic_terrain_touch"
"""Of the folder in it that has the presets of touch."""

TOUCH_SETTINGS = ("max_force", "passivity_control", "contact_model", "sub_step", "radius")
"""What is felt with; where the hand is and what it holds belong to no preset."""


class HAPTIC_TERRAIN_MT_touch_presets(bpy.types.Menu):
    """Choose how the ground feels"""

    bl_label = "Touch Presets"
    preset_subdir = TOUCH
    preset_operator = "script.execute_preset"
    draw = bpy.types.Menu.draw_preset  # type: ignore[assignment]  # the stubs of the two disagree


class HAPTIC_TERRAIN_OT_touch_preset_add(AddPresetBase, bpy.types.Operator):  # type: ignore[misc]
    """Keep the present settings of touch under a name, or remove the preset that is chosen"""

    bl_idname = "haptic_terrain.touch_preset_add"
    bl_label = "Add Touch Preset"
    preset_menu = HAPTIC_TERRAIN_MT_touch_presets.__name__
    preset_defines = ["settings = bpy.context.scene.haptic_terrain"]  # noqa: RUF012
    preset_values = [f"settings.{name}" for name in TOUCH_SETTINGS]  # noqa: RUF012
    preset_subdir = TOUCH


def draw_touch_presets(layout: Any) -> None:
    """The menu, with buttons to add and to remove."""
    row = layout.row(align=True)
    row.menu(HAPTIC_TERRAIN_MT_touch_presets.__name__, text=HAPTIC_TERRAIN_MT_touch_presets.bl_label)
    row.operator(HAPTIC_TERRAIN_OT_touch_preset_add.bl_idname, text="", icon="ADD")
    remove = row.operator(HAPTIC_TERRAIN_OT_touch_preset_add.bl_idname, text="", icon="REMOVE")
    remove.remove_active = True


def register() -> None:
    """Let Blender find ours."""
    bpy.utils.register_preset_path(HOME)


def unregister() -> None:
    """Let it forget them."""
    bpy.utils.unregister_preset_path(HOME)
