"""The 3D views follow the window that pan and zoom move, so that it looks as if the terrain moved.

Every view of the scene follows: perspective, orthographic, each of a quad view's. A view through a camera
stays, for the camera is the scene's; where a person has locked it to the view (*Lock Camera to View*), it is
what they move with the view, and it goes along.
"""

from __future__ import annotations

from typing import cast

import bpy
from mathutils import Matrix, Quaternion
from proxygraph import Window

from ..terrain.view import views
from .live import Clip, Touch
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
    cameras = set()
    for shown, area in views(bpy.context):
        if shown.scene != scene:
            continue
        space = area.spaces.active
        distances = []
        for view in {view for view in (space.region_3d, *space.region_quadviews) if view is not None}:
            if view.view_perspective != "CAMERA":
                move_view(view, old, new)
                distances.append(view.view_distance)
            elif space.lock_camera:
                cameras.add(space.camera if space.use_local_camera else scene.camera)
        if distances:
            _show_near(touch, cast("bpy.types.SpaceView3D", space), NEAREST * min(distances))
    for camera in cameras:
        if camera is not None:
            move_camera(camera, old, new)


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


def move_camera(camera: bpy.types.Object, old: Matrix, new: Matrix) -> None:
    """Let a camera show in the new window what it showed in the old one; its own scale stays.

    Args:
        old, new: ``in_scene``.
    """
    kept = camera.matrix_world.to_scale()
    location, rotation, scale = (new @ old.inverted() @ camera.matrix_world).decompose()
    camera.matrix_world = Matrix.LocRotScale(location[:], rotation, kept[:])
    if camera.type == "CAMERA" and camera.data.type == "ORTHO":
        camera.data.ortho_scale *= scale.x / kept.x


def in_scene(window: Window, placement: Placement) -> Matrix:
    """Where a window lies in the scene: its middle, how it is turned, its width as the scale."""
    place = placement.to_scene(window.east, window.north, window.up)
    upright = placement.upright(window.east, window.north)
    turn = -window.turn if placement.is_mirrored else window.turn  # a mirror turns the other way
    turned = upright @ Quaternion((0.0, 0.0, 1.0), turn)
    width = window.width * placement.units_per_metre
    return Matrix.LocRotScale(place[:], turned, (width, width, width))


def give_back_views(touch: Touch) -> None:
    """Let the views cut off again what is as near as a person chose, unless they chose anew since."""
    for _shown, area in views(bpy.context):
        space = area.spaces.active
        clip = touch.clips.pop(space.as_pointer(), None)
        if clip is not None and space.clip_start == clip.ours:
            space.clip_start = clip.own


def someone_looks() -> bool:
    """Whether Blender draws at all: in the background views stay as a script left them."""
    return not bpy.app.background


def _show_near(touch: Touch, space: bpy.types.SpaceView3D, nearest: float) -> None:
    """Let a view that came near show what is near; as it goes away, what a person chose holds again."""
    clip = touch.clips.get(space.as_pointer())
    own = clip.own if clip is not None and clip.ours == space.clip_start else space.clip_start
    space.clip_start = min(own, nearest)
    touch.clips[space.as_pointer()] = Clip(own=own, ours=space.clip_start)
