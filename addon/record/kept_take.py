"""What a take's action remembers in the .blend file: every tick in doubles, and what they were felt on.

Scripts find the ticks there too: ``action["haptic_terrain_take"]["columns"]["proxy_east"]``.
"""

from __future__ import annotations

import json
from typing import Any

import bpy
import numpy as np

from .about_properties import about_properties, read_about
from .take_data import TakeData

KEY = "haptic_terrain_take"
"""Of the ID property group on the action."""

START, COLUMNS, ABOUT = "start_frame", "columns", "about"


class KeptTakeError(ValueError):
    """A take does not have its ticks; the text says what to do."""


def keep_take(action: bpy.types.Action, data: TakeData, start_frame: int, *, ticks: bool) -> None:
    """Write what the action has to remember.

    Args:
        ticks: whether it keeps them too, and not only what they were felt on.
    """
    action[KEY] = {
        START: start_frame,
        ABOUT: json.dumps(about_properties(data.about)),
        COLUMNS: {name: np.ascontiguousarray(values) for name, values in data.columns.items()}
        if ticks
        else {},
    }


def take_action(thing: bpy.types.Object | None) -> bpy.types.Action | None:
    """Find the action that makes an object a take, in use or pushed down onto an NLA track."""
    if thing is None or thing.animation_data is None:
        return None
    strips = (strip for track in thing.animation_data.nla_tracks for strip in track.strips)
    actions = [thing.animation_data.action, *(strip.action for strip in strips)]
    return next((action for action in actions if action is not None and action.get(KEY) is not None), None)


def is_take(thing: bpy.types.Object | None) -> bool:
    """Whether an object is a take."""
    return take_action(thing) is not None


def recall_start_frame(action: bpy.types.Action) -> int:
    """Read the frame of the first tick."""
    return int(action[KEY][START])


def recall_take(action: bpy.types.Action) -> TakeData:
    """Read the ticks.

    Raises:
        KeptTakeError: they were not kept, or were changed.
    """
    kept: Any = action[KEY]
    try:
        columns = {str(name): np.array(values, dtype=np.float64) for name, values in kept[COLUMNS].items()}
        about, _told = read_about(kept[ABOUT])
        if columns:
            return TakeData.of(columns, about)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise KeptTakeError(
            f"{action.name} does not remember its ticks any more: its custom property {KEY} was changed "
            f"({type(error).__name__}: {error}). Record the take again."
        ) from error
    raise KeptTakeError(
        f"{action.name} has no ticks: Keep Ticks was off when it was written. Record it again with that on."
    )
