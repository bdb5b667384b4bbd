"""The terrain that panels and operators speak of."""

from __future__ import annotations

import bpy

from ..touch.error import TouchError
from ..touch.live import RENDERING, live
from ..touch.start import chosen_terrain


def shown_terrain(context: bpy.types.Context) -> bpy.types.Object | None:
    """Find the touched terrain, else the one that would be touched."""
    if live.touch is not None:
        return live.touch.terrain.find()
    try:
        return chosen_terrain(context)
    except TouchError:
        return None


def poll_terrain(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    """Whether an operator has a terrain to work on, and may change the scene."""
    if live.rendering:
        cls.poll_message_set(RENDERING)
        return False
    if shown_terrain(context) is None:
        cls.poll_message_set("Select the terrain that is meant, or import one")
        return False
    return True
