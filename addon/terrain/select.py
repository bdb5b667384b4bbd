"""Choosing an object for the person."""

from __future__ import annotations

import bpy


def select_only(context: bpy.types.Context, thing: bpy.types.Object) -> None:
    """Select one object and make it active; what the view layer excludes cannot be selected."""
    others = [other for other in context.selected_objects if other != thing]
    try:
        thing.select_set(True)
    except RuntimeError:  # it is not in the view layer, of which a new object shows no other sign yet
        return
    for other in others:
        other.select_set(False)
    context.view_layer.objects.active = thing
