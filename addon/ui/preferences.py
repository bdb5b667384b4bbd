"""The add-on's own preferences: the keys of Touch with Mouse."""

from __future__ import annotations

import bpy
import rna_keymap_ui

from .mouse_keys import ACTIONS, KEYMAP, keymap_items

LABELS = {name: label for name, label, _description in ACTIONS}


class HapticTerrainPreferences(bpy.types.AddonPreferences):
    """Shown in *Preferences > Add-ons > Haptic Terrain*."""

    bl_idname = __package__.rpartition(".")[0]

    def draw(self, context: bpy.types.Context) -> None:
        """Let a person change the keys."""
        box = self.layout.box()
        box.label(text="Keys of Touch with Mouse", icon="MOUSE_MOVE")
        configuration = context.window_manager.keyconfigs.user
        items = keymap_items(context)
        if not items:
            box.label(text="The keymap has none: restore it in Preferences > Keymap > 3D View.")
            return
        keymap = configuration.keymaps[KEYMAP]
        for item in items:
            column = box.column()
            column.label(text=LABELS[item.properties.action])
            column.context_pointer_set("keymap", keymap)  # what the buttons of an item work on
            rna_keymap_ui.draw_kmi([], configuration, keymap, item, column, 0)
