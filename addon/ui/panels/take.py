"""The panel Take: what a recording becomes, and takes as files."""

from __future__ import annotations

import bpy

from ...touch.live import live
from ..record_operators import HAPTIC_TERRAIN_OT_record_discard
from ..sidebar import TAB
from ..take_operators import HAPTIC_TERRAIN_OT_export_take, HAPTIC_TERRAIN_OT_import_take


class HAPTIC_TERRAIN_PT_take(bpy.types.Panel):
    """What a take becomes."""

    bl_label = "Take"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_parent_id = "HAPTIC_TERRAIN_PT_record"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    def draw(self, context: bpy.types.Context) -> None:
        """Choose before the recording stops."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.haptic_terrain
        if live.recording is None:
            layout.prop(settings, "play_timeline")
        else:
            layout.operator(HAPTIC_TERRAIN_OT_record_discard.bl_idname, icon="TRASH")
        layout.prop(settings, "take_keys")
        if settings.take_keys == "REDUCED":
            layout.prop(settings, "take_bound", text="Bound in mm")
        layout.prop(settings, "take_onto")
        if settings.take_onto != "NEW":
            layout.prop(settings, "take")
        if settings.trail:
            layout.row(align=True).prop(settings, "trail_kinds")
        layout.prop(settings, "take_markers")
        layout.prop(settings, "take_nla")
        layout.prop(settings, "keep_ticks")
        row = layout.row(align=True)
        row.operator(HAPTIC_TERRAIN_OT_export_take.bl_idname, icon="EXPORT")
        row.operator(HAPTIC_TERRAIN_OT_import_take.bl_idname, icon="IMPORT")
