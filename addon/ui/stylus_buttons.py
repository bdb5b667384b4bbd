"""The stylus in the panel *Touch*: a button for its button, and two to turn it."""

from __future__ import annotations

from typing import Any

from ..touch.live import Touch
from .stylus_operators import (
    HAPTIC_TERRAIN_OT_press,
    HAPTIC_TERRAIN_OT_release,
    HAPTIC_TERRAIN_OT_twist,
)

STEP = 15.0
"""Degrees that a button turns the handle."""


def draw_stylus(layout: Any, touch: Touch) -> None:
    """Offer what can be done with the stylus now; nothing where a script moves the hand."""
    if not touch.has_modes:
        return
    scene = touch.scene.find()
    if scene is not None:
        layout.prop(scene.haptic_terrain, "follow_view")
        layout.prop(scene.haptic_terrain, "detail")
    if not touch.is_pressed:
        layout.operator(HAPTIC_TERRAIN_OT_press.bl_idname, icon="VIEW_PAN")
        return
    layout.operator(HAPTIC_TERRAIN_OT_release.bl_idname, icon="LOOP_BACK")
    if touch.is_simulated and touch.readout is not None and touch.readout.mode == "zoom":
        row = layout.row(align=True)
        for degrees in (STEP, -STEP):
            button = row.operator(
                HAPTIC_TERRAIN_OT_twist.bl_idname, text=f"Twist {degrees:+.0f}\N{DEGREE SIGN}"
            )
            button.degrees = degrees
