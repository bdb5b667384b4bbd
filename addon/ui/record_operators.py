"""Start Recording and Stop Recording."""

from __future__ import annotations

import bpy

from ..record.about_properties import OtherTerrainError
from ..record.kept_take import KeptTakeError
from ..record.recording import RecordingError, discard_recording, start_recording, stop_recording
from ..record.recover import recover_take
from ..touch.live import RENDERING, live
from .operator_status import OperatorStatus
from .take_report import report_take


class HAPTIC_TERRAIN_OT_record_start(bpy.types.Operator):
    """Record the touch as animation, from the current frame on"""

    bl_idname = "haptic_terrain.record_start"
    bl_label = "Start Recording"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while touch runs, and one take at a time."""
        if live.recording is not None:
            cls.poll_message_set("A take is being recorded already: stop it first")
        elif live.touch is None:
            cls.poll_message_set("Start touch before recording")
        return live.recording is None and live.touch is not None

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Start a take."""
        try:
            start_recording(context)
        except RecordingError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if live.recording is not None and live.recording.not_spooled:
            self.report({"WARNING"}, f"The take is in memory only: {live.recording.not_spooled}")
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_record_stop(bpy.types.Operator):
    """Write the recorded touch to an object of its own"""

    bl_idname = "haptic_terrain.record_stop"
    bl_label = "Stop Recording"
    bl_options = {"UNDO"}  # noqa: RUF012

    trail: bpy.props.BoolProperty(
        name="Trail",
        description="Also draw trails over the terrain",
        default=True,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while a take is being recorded, also when touch has ended by itself."""
        if live.recording is None:
            cls.poll_message_set("No take is being recorded")
        elif live.rendering:
            cls.poll_message_set(RENDERING)
        return live.recording is not None and not live.rendering

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Write the take."""
        try:
            take = stop_recording(context, trail=self.trail)
        except RecordingError as error:
            self.report({"WARNING"}, str(error))
            return {"CANCELLED"}
        except (KeptTakeError, OtherTerrainError) as error:
            self.report({"ERROR"}, f"{error} The take waits: choose New Take in Write To, and stop again.")
            return {"CANCELLED"}
        report_take(self, take)
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_record_discard(bpy.types.Operator):
    """Let go of the take that is being recorded"""

    bl_idname = "haptic_terrain.record_discard"
    bl_label = "Discard Recording"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while a take is being recorded."""
        if live.recording is None:
            cls.poll_message_set("No take is being recorded")
        return live.recording is not None

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Ask first: it cannot be had back."""
        return context.window_manager.invoke_confirm(self, event)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Forget it."""
        discard_recording(context)
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_recover_take(bpy.types.Operator):
    """Write the newest take that was left when Blender ended in mid-recording, or could not be written"""

    bl_idname = "haptic_terrain.recover_take"
    bl_label = "Recover Last Take"
    bl_options = {"UNDO"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Not while a take is being recorded, or a picture rendered."""
        if live.recording is not None:
            cls.poll_message_set("A take is being recorded: stop it first")
        elif live.rendering:
            cls.poll_message_set(RENDERING)
        return live.recording is None and not live.rendering

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Write it to its terrain."""
        try:
            recovered = recover_take(context)
        except RecordingError as error:
            self.report({"WARNING"}, str(error))
            return {"CANCELLED"}
        report_take(self, recovered.written)
        if recovered.lost is not None:
            self.report({"WARNING"}, f"Not all of the take was left: {recovered.lost}")
        return {"FINISHED"}
