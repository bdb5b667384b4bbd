"""The 3D views follow the window that pan and zoom move, so that it looks as if the terrain moved."""

from __future__ import annotations

import bpy
from mathutils import Matrix, Quaternion
from proxygraph import Window

from ..terrain.view import views
from .live import Touch
from .placement import Placement
from .windows import is_same

NEAREST = 0.01
"""Share of a view's distance beyond which things are drawn at least: the cursor must not be cut off."""


def follow_view(touch: Touch, scene: bpy.types.Scene, placement: Placement) -> None:
    """Move every view of the scene as the window moved since the last call; on choice they stay."""
    before, window = touch.view_window, touch.session.window
    if is_same(before, window):
        return
    touch.view_window = window
    if not (scene.haptic_terrain.follow_view and someone_looks()):
        return
    touch.view_scale *= window.width / before.width
    old, new = in_scene(before, placement), in_scene(window, placement)
    for shown, area in views(bpy.context):
        if shown.scene != scene:
            continue
        space = area.spaces.active
        for view in {view for view in (space.region_3d, *space.region_quadviews) if view is not None}:
            if view.view_perspective != "CAMERA":
                move_view(view, old, new)
                space.clip_start = min(space.clip_start, NEAREST * view.view_distance)


def move_view(view: bpy.types.RegionView3D, old: Matrix, new: Matrix) -> None:
    """Let a view show in the new window what it showed in the old one.

    Args:
        old, new: ``in_scene``.
    """
    shown = Matrix.LocRotScale(view.view_location[:], view.view_rotation, (view.view_distance,) * 3)
    location, rotation, scale = (new @ old.inverted() @ shown).decompose()
    view.view_location = location
    if old.to_quaternion() != new.to_quaternion() and not view.lock_rotation:
        view.view_rotation = rotation
    view.view_distance = scale.x


def in_scene(window: Window, placement: Placement) -> Matrix:
    """Where a window lies in the scene: its middle, how it is turned, its width as the scale."""
    place = placement.to_scene(window.east, window.north, window.up)
    upright = placement.upright(window.east, window.north)
    turned = upright @ Quaternion((0.0, 0.0, 1.0), window.turn)
    width = window.width * placement.units_per_metre
    return Matrix.LocRotScale(place[:], turned, (width, width, width))


def someone_looks() -> bool:
    """Whether Blender draws at all: in the background views stay as a script left them."""
    return not bpy.app.background
