"""Grab, Release and Twist: the stylus, for whoever holds none."""

from __future__ import annotations

from collections.abc import Callable

import bpy
from proxygraph import SessionError

from ..touch.live import Touch, live
from ..touch.stylus import press, release, twist
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_press(bpy.types.Operator):
    """Press the stylus button: on the ground the hand then pans, in the air it zooms"""

    bl_idname = "haptic_terrain.press"
    bl_label = "Grab"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while touch has modes, and the button is up."""
        if not _has_modes(cls):
            return False
        if live.touch is not None and live.touch.is_pressed:
            cls.poll_message_set("The stylus button is down already: release it first")
            return False
        return True

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Press."""
        return _told(self, press)


class HAPTIC_TERRAIN_OT_release(bpy.types.Operator):
    """Release the stylus button: back to touching the ground, which drifts on where it was pushed"""

    bl_idname = "haptic_terrain.release"
    bl_label = "Release"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while the button is down."""
        if not _has_modes(cls):
            return False
        if live.touch is not None and not live.touch.is_pressed:
            cls.poll_message_set("The stylus button is up: grab something first")
            return False
        return True

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Release."""
        return _told(self, release)


class HAPTIC_TERRAIN_OT_twist(bpy.types.Operator):
    """Turn the handle: while the air is held, the terrain turns with it, about the cursor"""

    bl_idname = "haptic_terrain.twist"
    bl_label = "Twist"

    degrees: bpy.props.FloatProperty(
        name="Degrees",
        description="Counter-clockwise, seen from above",
        default=15.0,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a handle that is simulated: a person turns a real one."""
        if not _has_modes(cls):
            return False
        if live.touch is not None and not live.touch.is_simulated:
            cls.poll_message_set("This device has a handle of its own: turn that")
            return False
        return True

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Twist."""
        return _told(self, lambda touch: twist(touch, self.degrees))


def _told(operator: bpy.types.Operator, act: Callable[[Touch], None]) -> OperatorStatus:
    """Act on the touch that runs, and report what refuses it."""
    if live.touch is None:
        return {"CANCELLED"}
    try:
        act(live.touch)
    except (ValueError, SessionError) as error:
        operator.report({"ERROR"}, str(error))
        return {"CANCELLED"}
    return {"FINISHED"}


def _has_modes(cls: type[bpy.types.Operator]) -> bool:
    if live.touch is None:
        cls.poll_message_set("Touch is not running: start it first")
        return False
    if not live.touch.has_modes:
        cls.poll_message_set("A script moves this hand, without a stylus button")
        return False
    return True
