"""Where a take begins on the timeline, with what was kept from before it was asked for."""

from __future__ import annotations

import bpy
from proxygraph import Take

from .take_data import RATE


def first_frame(felt: Take, asked_at: int, scene: bpy.types.Scene, *, played: bool) -> int:
    """Frame of the first tick.

    Where the timeline played along, the frame at which recording was asked for stays where it was. Otherwise
    the take does not begin before the scene does: it would not be seen.

    Args:
        asked_at: the scene's frame when recording was asked for.
        played: whether the timeline played along.
    """
    seconds = felt.pre_roll / RATE
    first = asked_at - round(seconds * scene.render.fps / scene.render.fps_base)
    return first if played else max(first, min(asked_at, scene.frame_start))
