"""Start Touch and Stop Touch."""

from __future__ import annotations

import bpy

from ..formats import FormatError
from ..terrain.select import select_only
from ..touch.error import TouchError
from ..touch.live import RENDERING, live
from ..touch.start import chosen_terrain, start_touch
from ..touch.stop import stop_touch
from ..touch.tick import tick
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_touch_start(bpy.types.Operator):
    """Put the hand on the terrain"""

    bl_idname = "haptic_terrain.touch_start"
    bl_label = "Start Touch"
    bl_options = {"UNDO"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain, and once."""
        if live.touch is not None:
            cls.poll_message_set("Touch is already running: stop it first")
            return False
        if live.rendering:
            cls.poll_message_set(RENDERING)
            return False
        try:
            chosen_terrain(context)
        except TouchError as error:
            cls.poll_message_set(str(error))
            return False
        return True

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Start."""
        try:
            touch = start_touch(context)
        except (TouchError, FormatError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        target = touch.target.find() if touch.target is not None else None
        if target is not None:
            select_only(context, target)  # so that it can be dragged at once
        self.report({"INFO"}, f"Touching {touch.terrain.name}: move the Touch Target to move the hand")
        if bpy.app.background:
            self.report(
                {"WARNING"},
                "Blender's timers never fire in the background: after moving the Touch Target, and to move "
                "the cursor, call bpy.ops.haptic_terrain.touch_update()",
            )
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_touch_update(bpy.types.Operator):
    """Bring hand, cursor and readout up to date: for scripts in the background, where no timer does it"""

    bl_idname = "haptic_terrain.touch_update"
    bl_label = "Update Touch"
    bl_options = {"INTERNAL"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while touch runs."""
        return _poll_running(cls)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Do what the timer does."""
        context.view_layer.update()
        tick()
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_touch_stop(bpy.types.Operator):
    """Take the hand off the terrain"""

    bl_idname = "haptic_terrain.touch_stop"
    bl_label = "Stop Touch"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while touch runs."""
        return _poll_running(cls)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Stop; a take in the making waits for Stop Recording."""
        stop_touch()
        if live.recording is not None:
            self.report({"INFO"}, "Touch stopped; Stop Recording writes the take")
        return {"FINISHED"}


def _poll_running(cls: type[bpy.types.Operator]) -> bool:
    if live.touch is None:
        cls.poll_message_set("Touch is not running")
    return live.touch is not None
