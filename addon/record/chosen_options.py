"""What the scene's settings say of the next take."""

from __future__ import annotations

import bpy

from .kept_take import is_take
from .take_options import TakeOptions


def chosen_options(scene: bpy.types.Scene, start_frame: int) -> TakeOptions:
    """Read the settings. Where the take to write to is gone, a new one is made: nothing is lost."""
    settings = scene.haptic_terrain
    chosen = settings.take if settings.take_onto != "NEW" and is_take(settings.take) else None
    return TakeOptions(
        start_frame=start_frame,
        reduced=settings.take_keys == "REDUCED",
        bound_mm=settings.take_bound,
        trails=frozenset(settings.trail_kinds) if settings.trail else frozenset(),
        markers=settings.take_markers,
        nla=settings.take_nla,
        keep_ticks=settings.keep_ticks,
        onto=chosen,
        append=settings.take_onto == "APPEND",
    )
