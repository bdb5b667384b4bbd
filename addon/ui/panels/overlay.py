"""What is drawn over the 3D view while a terrain is touched."""

from __future__ import annotations

import bpy

from ..sidebar import TAB

SHOWN = ("show_overview", "show_readout", "show_legend", "show_force", "show_ghost")


class HAPTIC_TERRAIN_PT_overlay(bpy.types.Panel):
    """Each part on or off."""

    bl_label = "Overlay"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_parent_id = "HAPTIC_TERRAIN_PT_touch"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    def draw(self, context: bpy.types.Context) -> None:
        """Choose."""
        if self.layout is None or context.scene is None:
            return
        column = self.layout.column(align=True)
        for name in SHOWN:
            column.prop(context.scene.haptic_terrain, name)
