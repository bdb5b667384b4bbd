"""Baking, and following the ground."""

from __future__ import annotations

import bpy

from ...record.follow_ground import is_following
from ...terrain.kept import is_terrain
from ..bake_operators import (
    HAPTIC_TERRAIN_OT_bake,
    HAPTIC_TERRAIN_OT_follow_ground,
    HAPTIC_TERRAIN_OT_leave_ground,
)
from ..sidebar import TAB, draw_text


class HAPTIC_TERRAIN_PT_bake(bpy.types.Panel):
    """An animated object as the hand."""

    bl_label = "Bake"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    def draw(self, context: bpy.types.Context) -> None:
        """Name what would be baked."""
        layout = self.layout
        if layout is None:
            return
        goal = goal_name(context)
        if goal is None:
            draw_text(layout, "Make the object active that moves over the terrain.")
        else:
            layout.label(text=goal, icon="ANIM")
        row = layout.row()
        row.enabled = goal is not None
        row.operator(HAPTIC_TERRAIN_OT_bake.bl_idname, icon="REC")


class HAPTIC_TERRAIN_PT_follow_ground(bpy.types.Panel):
    """Objects on the ground."""

    bl_label = "Follow the Ground"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    def draw(self, context: bpy.types.Context) -> None:
        """Name the object, and whether it follows already."""
        layout = self.layout
        if layout is None:
            return
        goal = goal_name(context)
        if goal is None:
            draw_text(layout, "Make the object active that is to stay on the terrain.")
            return
        layout.label(text=goal, icon="OBJECT_DATA")
        active = context.view_layer.objects.active
        layout.operator(HAPTIC_TERRAIN_OT_follow_ground.bl_idname, icon="CON_FLOOR")
        if active is not None and is_following(active):
            layout.operator(HAPTIC_TERRAIN_OT_leave_ground.bl_idname, icon="X")


def goal_name(context: bpy.types.Context) -> str | None:
    """What would be baked: the active object, in pose mode its active bone; ``None`` for a terrain."""
    active = context.view_layer.objects.active
    if active is None or is_terrain(active):
        return None
    bone = context.active_pose_bone if context.mode == "POSE" else None
    return active.name if bone is None else f"{active.name}, {bone.name}"
