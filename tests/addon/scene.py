"""What tests of the add-on do over and over."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType
from typing import Any

import bpy
import numpy as np
import numpy.typing as npt
from enable_addon import MODULE


def module(name: str) -> ModuleType:
    """Import a part of the installed extension."""
    return importlib.import_module(f"{MODULE}.{name}")


def import_grid(path: Path, **options: Any) -> bpy.types.Object:
    """Import as a script would; gives the terrain."""
    assert bpy.ops.haptic_terrain.import_grid(filepath=str(path), **options) == {"FINISHED"}
    terrain = bpy.context.view_layer.objects.active
    assert terrain is not None
    return terrain


def positions(mesh: Any) -> npt.NDArray[np.float32]:
    """Vertices, n x 3."""
    values = np.empty(len(mesh.vertices) * 3, dtype=np.float32)
    mesh.attributes["position"].data.foreach_get("vector", values)
    return values.reshape(-1, 3)


def triangles(mesh: Any) -> npt.NDArray[np.int32]:
    """Vertex numbers of each face, n x 3."""
    values = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.attributes[".corner_vert"].data.foreach_get("value", values)
    return values.reshape(-1, 3)


def contents() -> dict[str, int]:
    """Count what a failed import must not leave behind."""
    kinds = ("objects", "meshes", "materials", "actions", "curves", "collections")
    return {kind: len(getattr(bpy.data, kind)) for kind in kinds}


def curves_of(thing: bpy.types.Object) -> list[bpy.types.FCurve]:
    """Find an object's F-curves, slotted or not."""
    action = thing.animation_data.action
    if hasattr(action, "layers"):
        bags = [bag for layer in action.layers for strip in layer.strips for bag in strip.channelbags]
        return [curve for bag in bags for curve in bag.fcurves]
    return list(action.fcurves)


def keys_of(thing: bpy.types.Object) -> list[list[tuple[float, float, str]]]:
    """Read (frame, value, interpolation) of each key of an object's location, for x, y and z."""
    location = (curve for curve in curves_of(thing) if curve.data_path == "location")
    curves = sorted(location, key=lambda curve: curve.array_index)
    return [[(key.co.x, key.co.y, key.interpolation) for key in curve.keyframe_points] for curve in curves]
