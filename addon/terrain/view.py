"""Showing a new terrain in the 3D views."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
from mathutils import Vector


def views(context: bpy.types.Context) -> Iterator[tuple[bpy.types.Window, bpy.types.Area]]:
    """Every 3D view that is open."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                yield window, area


def redraw(context: bpy.types.Context) -> None:
    """Ask the 3D views, and nothing else, to draw themselves again."""
    for _window, area in views(context):
        area.tag_redraw()


def look_at(context: bpy.types.Context, place: Vector) -> None:
    """Move the 3D views so that they turn around a place (scene coordinates)."""
    for _window, area in views(context):
        view = area.spaces.active.region_3d
        if view is not None:
            view.view_location = place
        area.tag_redraw()


def show_materials(context: bpy.types.Context) -> None:
    """Let 3D views in plain grey shading show what materials make of heights; other shadings stay."""
    for _window, area in views(context):
        shading = area.spaces.active.shading
        if shading.type == "SOLID":
            shading.type = "MATERIAL"


def frame_selected(context: bpy.types.Context, size: float) -> None:
    """Make the selected object fill the 3D views, with clip distances that show all of it.

    Args:
        size: the object's longest side, Blender units.
    """
    for window, area in views(context):
        space = area.spaces.active
        space.clip_end = max(space.clip_end, 10.0 * size)
        # The depth buffer cannot resolve more than about six decades.
        space.clip_start = max(space.clip_start, space.clip_end * 1e-6)
        region = next((region for region in area.regions if region.type == "WINDOW"), None)
        if region is not None:
            with context.temp_override(window=window, area=area, region=region):
                bpy.ops.view3d.view_selected()
