"""F-curves, in one way for every version of Blender."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np

CONSTANT, LINEAR = 0, 1
"""Values of a keyframe's ``interpolation``."""


def ensure_fcurve(
    action: bpy.types.Action, owner: bpy.types.Object, data_path: str, index: int
) -> bpy.types.FCurve:
    """Find or make a curve; the action must be assigned to its owner already."""
    if hasattr(action, "fcurve_ensure_for_datablock"):  # slotted actions, from 4.4
        curve: bpy.types.FCurve = action.fcurve_ensure_for_datablock(owner, data_path, index=index)
    else:
        curve = action.fcurves.find(data_path, index=index) or action.fcurves.new(data_path, index=index)
    return curve


def write_keys(
    curve: bpy.types.FCurve, frames: Sequence[float], values: Sequence[float], held: Sequence[bool]
) -> None:
    """Write all keys of an empty curve at once.

    Args:
        held: for each key, whether its value stays until the next one instead of moving toward it.
    """
    points = curve.keyframe_points
    points.add(len(frames))
    points.foreach_set("co", np.column_stack((frames, values)).astype(np.float32).ravel())
    points.foreach_set("interpolation", np.where(held, CONSTANT, LINEAR).astype(np.int32))
    curve.update()
