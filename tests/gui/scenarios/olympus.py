"""Olympus Mons on the real Mars, as in figure 12 of the paper: cone, trail coloured by force, overview map.

For the README. Nothing is asserted but that it can be done.
"""

from __future__ import annotations

import math

import bpy
from mathutils import Euler, Vector

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script, Until

GRID = "megt90n000cb.lbl"

MOUNTAIN = (226.2, 18.65)
"""Degrees east and north."""

ACROSS_KM = 1600.0
"""Terrain under the hand's whole reach."""

EXAGGERATION = 12.0

CURSOR = 0.3
"""Of its usual size: the view is as near as if the hand had zoomed."""

SECONDS = 24.0
"""Of touch."""

STEP = 0.1
"""Seconds between two places of the hand."""

PRESSED = 0.03
"""Blender units under the ground where the hand is led."""


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    bpy.data.batch_remove(list(bpy.data.objects))
    yield from steps.drop(blender, GRID)
    yield from steps.confirm(blender)
    terrain = yield from steps.imported(blender)
    yield from steps.shade_plainly(blender)
    # Without a graphics card Blender draws too seldom for the servo to trust what is seen.
    blender.part("touch.start").stale_after = lambda: None
    scene = bpy.context.scene
    terrain.haptic_terrain.exaggeration = EXAGGERATION
    scene.haptic_terrain.window_width = ACROSS_KM
    yield from steps.start_touch(blender)
    scene.haptic_terrain.follow_view = False
    with blender.in_view():
        bpy.ops.haptic_terrain.go_to(longitude=MOUNTAIN[0], latitude=MOUNTAIN[1])
    yield 0.5
    target = blender.touch.target.find()
    target.hide_set(True)
    middle = Vector(target.location)
    blender.touch.view_scale = CURSOR
    _look(blender, middle)
    with blender.in_view():
        bpy.ops.haptic_terrain.record_start()
    yield from _touch(blender, terrain, target, middle)
    with blender.in_view():
        bpy.ops.haptic_terrain.record_stop()
    for take in [thing for thing in bpy.data.objects if thing.name.startswith("Touch Take")]:
        take.hide_set(True)
    blender.space.overlay.show_extras = blender.space.overlay.show_floor = False
    blender.space.overlay.show_axis_x = blender.space.overlay.show_axis_y = False
    blender.space.overlay.show_cursor = blender.space.overlay.show_outline_selected = False
    blender.space.show_gizmo_navigate = blender.space.show_region_toolbar = False
    blender.space.shading.type = "MATERIAL"
    yield 60.0
    yield from blender.picture("olympus", wait=20.0)
    yield from steps.stop_touch(blender)


def _look(blender: Blender, middle: Vector) -> None:
    view = blender.space.region_3d
    view.view_perspective = "PERSP"
    view.view_location = middle - Vector((0.0, 0.0, 0.03))
    view.view_rotation = Euler((math.radians(62.0), 0.0, math.radians(-15.0))).to_quaternion()
    view.view_distance = 0.95
    blender.space.clip_start = 0.01


def _touch(
    blender: Blender, terrain: bpy.types.Object, target: bpy.types.Object, middle: Vector
) -> Script[None]:
    """Lead the hand around the mountain and up to its top, a little under the ground all the while."""
    placement = blender.part("touch.placement").Placement.of(terrain, blender.touch.frame)
    grid, size = blender.touch.grid, 0.28
    count = round(SECONDS / STEP)
    for number in range(count):
        share = number / count
        angle = 5.6 * math.pi * share
        radius = size * (1.0 - 0.75 * share)
        east, north, _up = placement.to_terrain(
            middle + Vector((radius * math.cos(angle), radius * math.sin(angle), 0.0))
        )
        ground = grid.elevation_at(blender.touch.frame.on_map(east), north) or 0.0
        place = placement.to_scene(east, north, ground)
        place.z -= PRESSED * (0.35 + 0.65 * math.sin(7.0 * math.pi * share) ** 2)
        target.location = place
        yield STEP
    yield Until("the hand touches the ground", lambda: blender.touch.readout.in_contact, seconds=30.0)
