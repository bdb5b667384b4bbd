"""The mode track: timeline markers where the hand began to pan, to zoom, and to touch again."""

from __future__ import annotations

import bpy
import numpy as np

from .keys import Keys
from .take_data import MODES


def mark_modes(scene: bpy.types.Scene, take: bpy.types.Object, mode: Keys) -> None:
    """Set a take's markers, in place of those that it had; none where the mode never changed.

    A marker's name is the take's and the mode's: "Touch Take.001: pan".
    """
    markers = scene.timeline_markers
    for marker in [marker for marker in markers if marker.name.startswith(_prefix(take))]:
        markers.remove(marker)
    values = mode.values[:, 0]
    if not values.any():
        return
    changes = np.flatnonzero(np.diff(values, prepend=0.0))
    for number in changes.tolist():
        name = MODES[int(values[number])]
        markers.new(_prefix(take) + name, frame=int(mode.frames[number]))


def _prefix(take: bpy.types.Object) -> str:
    return f"{take.name}: "
