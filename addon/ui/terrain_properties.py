"""What can be changed of a terrain object at once, as ``object.haptic_terrain``."""

from __future__ import annotations

from typing import cast

import bpy

from ..terrain.kept import KeptError, is_terrain, recall_frame
from ..terrain.rebuild import exaggerate


def _exaggeration(terrain: HapticTerrainObject) -> float:
    thing = cast("bpy.types.Object", terrain.id_data)
    try:
        return recall_frame(thing).exaggeration if is_terrain(thing) else 1.0
    except KeptError:
        return 1.0


def _set_exaggeration(terrain: HapticTerrainObject, value: float) -> None:
    """Show it at once; a hand that is on the terrain feels it at once."""
    thing = cast("bpy.types.Object", terrain.id_data)
    if not is_terrain(thing) or thing.library is not None:
        return
    try:
        exaggerate(thing, value)
    except KeptError as error:
        print(error)  # a property has nowhere else to say it; the panel says it too


class HapticTerrainObject(bpy.types.PropertyGroup):
    """Of one terrain object; harmless on any other."""

    exaggeration: bpy.props.FloatProperty(
        name="Heights x",
        description="How many times higher than in nature the terrain is shown and felt",
        min=0.001,
        max=10_000.0,
        soft_min=0.1,
        soft_max=200.0,
        step=100,
        get=_exaggeration,
        set=_set_exaggeration,
    )
