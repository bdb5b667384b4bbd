"""Passivity control, as a person chose it in a scene, brought to the hand."""

from __future__ import annotations

from contextlib import suppress

import bpy
from proxygraph import SessionError

from .live import Touch


def keep_control(touch: Touch, scene: bpy.types.Scene) -> None:
    """Switch it on or off as it is chosen now; where that is refused, the next tick tries again."""
    wanted = scene.haptic_terrain.passivity_control
    if wanted == touch.passivity_control:
        return
    with suppress(SessionError):
        touch.session.set_passivity_control(wanted)
        touch.passivity_control = wanted
