"""The add-on's own objects, told by a mark: a person may rename them, and another scene may have its own."""

from __future__ import annotations

import bpy


def mark_own(thing: bpy.types.Object, mark: str) -> None:
    """Put a mark on an object, as an ID property."""
    thing[mark] = True


def own_object(scene: bpy.types.Scene, mark: str) -> bpy.types.Object | None:
    """Find the object with a mark in a scene."""
    return next((thing for thing in scene.objects if thing.get(mark)), None)
