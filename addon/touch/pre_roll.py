"""What is kept of touch before a recording starts, as a person chose it in a scene."""

from __future__ import annotations

from contextlib import suppress

import bpy
from proxygraph import SessionError

from .live import Touch


def keep_pre_roll(touch: Touch, scene: bpy.types.Scene) -> None:
    """Keep as many seconds as are chosen now; where that is refused, the next tick tries again."""
    wanted = scene.haptic_terrain.pre_roll
    if wanted == touch.pre_roll:
        return
    with suppress(SessionError):
        touch.session.set_pre_roll(wanted)
        touch.pre_roll = wanted
