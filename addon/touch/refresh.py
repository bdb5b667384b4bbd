"""Drawing again what shows a touch, where it shows and when it looks different."""

from __future__ import annotations

import time

import bpy

from ..terrain.view import views
from .live import Touch
from .shown import Look
from .windows import lies

REST = 0.25
"""Seconds after which counts, loads and lateness are drawn again although nothing moves."""


def refresh(touch: Touch, scene: bpy.types.Scene) -> None:
    """Draw the 3D views and sidebars of the touched scene again, where they would look different."""
    look, now = _look(touch), time.monotonic()
    if look == touch.look and now - touch.looked < REST:
        return
    touch.look, touch.looked = look, now
    for window, area in views(bpy.context):
        if window.scene != scene:
            continue
        for region in area.regions:
            if region.type in {"WINDOW", "UI"} and region.width > 1:
                region.tag_redraw()


def _look(touch: Touch) -> Look | None:
    readout = touch.readout
    if readout is None:
        return None
    return Look(touch.shown, lies(readout.window), readout.mode, readout.held)
