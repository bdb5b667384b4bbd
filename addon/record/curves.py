"""F-curves, in one way for every version of Blender."""

from __future__ import annotations

import bpy
import numpy as np

from .keys import Keys

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


def has_fcurve(action: bpy.types.Action, data_path: str) -> bool:
    """Whether an action moves a property."""
    if hasattr(action, "layers"):  # slotted actions
        strips = (strip for layer in action.layers for strip in layer.strips)
        curves = (curve for strip in strips for bag in strip.channelbags for curve in bag.fcurves)
    else:
        curves = iter(action.fcurves)
    return any(curve.data_path == data_path for curve in curves)


def write_keys(curve: bpy.types.FCurve, keys: Keys, axis: int = 0) -> None:
    """Write all keys of a curve at once; what it had is gone.

    Args:
        axis: of the keys' values.
    """
    points = curve.keyframe_points
    points.clear()
    points.add(len(keys))
    points.foreach_set("co", np.column_stack((keys.frames, keys.values[:, axis])).astype(np.float32).ravel())
    points.foreach_set("interpolation", np.where(keys.held, CONSTANT, LINEAR).astype(np.int32))
    curve.update()
