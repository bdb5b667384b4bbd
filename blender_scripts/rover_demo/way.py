"""Where the rover goes, and what its wheels feel."""

from __future__ import annotations

from typing import Any

import bpy
from mathutils import Vector
from pipeline.scene import Parts

from rover_demo.rover import FOOTPRINT, WHEELS

LAST_FRAME = 240

STOPS = ((0.02, -0.78), (-0.32, -0.5), (-0.66, -0.52), (-0.95, -0.2), (-1.2, -0.13), (-1.3, 0.2))
"""Blender units east and north of the map's middle: from the plain up between the volcanoes."""

PRESS = 0.05
"""Of the rover's length: how far the wheels are under the ground that they feel."""

REACH = 1500.0
"""Kilometres under a hand's whole reach: on this scale the wheels press with about a newton."""

LINE = 0.0022
"""Radius of the line that is still to be driven, Blender units."""


def drive(rover: bpy.types.Object, scene: bpy.types.Scene) -> None:
    """Key the way, as a person would: a few places, and Blender's curves between them."""
    scene.frame_start, scene.frame_end = 1, LAST_FRAME
    for number, (x, y) in enumerate(STOPS):
        rover.location = (x, y, 0.0)
        rover.keyframe_insert("location", frame=1 + number * (LAST_FRAME - 1) / (len(STOPS) - 1))


def keep_on_the_ground(rover: bpy.types.Object, length: float) -> None:
    """Let the rover follow the ground with all its wheels, looking where it goes."""
    bpy.ops.haptic_terrain.follow_ground(
        goal=rover.name, heading="PATH", footprint=[share * length for share in FOOTPRINT]
    )


def feel(rover: bpy.types.Object, length: float, parts: Parts) -> list[tuple[Any, Any]]:
    """Bake what the two front wheels feel, without trails; gives what was baked, and the takes."""
    bake = parts("record.bake")
    settings = bpy.context.scene.haptic_terrain
    settings.window_width, settings.trail = REACH, False
    takes = []
    for side, ahead in WHEELS[-2:]:
        wheel = bpy.data.objects.new("Wheel left" if side < 0.0 else "Wheel right", None)
        wheel.empty_display_size = 0.1 * length
        wheel.parent = rover
        wheel.location = Vector((side, ahead, -PRESS)) * length
        bpy.context.scene.collection.objects.link(wheel)
        bpy.context.view_layer.update()
        goal = parts("ui.goal_choices").chosen_goal(bpy.context, wheel.name)
        terrain = parts("ui.goal_choices").terrain_under(bpy.context, "")
        frames = parts("ui.goal_choices").chosen_frames(bpy.context, 0, 0, bake.SAMPLES_PER_FRAME)
        described = bake.bake_of(bpy.context, goal, terrain, frames)
        result = parts("terrain.progress").finished(bake.baked(described))
        takes.append((result, bake.write_baked(described, result)))
    return takes


def places(rover: bpy.types.Object, scene: bpy.types.Scene) -> list[Vector]:
    """Where the rover is in each frame; the scene stands at the last one then."""
    found = []
    for frame in range(scene.frame_start, scene.frame_end + 1):
        scene.frame_set(frame)
        graph = bpy.context.evaluated_depsgraph_get()
        found.append(rover.evaluated_get(graph).matrix_world.translation.copy())
    return found


def draw_ahead(scene: bpy.types.Scene, ahead: list[Vector], material: bpy.types.Material) -> None:
    """Draw the way that is still to be driven as a dashed line over the ground."""
    curve = bpy.data.curves.new("Way ahead", "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = LINE
    for first in range(0, len(ahead) - 2, 4):
        dash = ahead[first : first + 3]
        spline = curve.splines.new("POLY")
        spline.points.add(len(dash) - 1)
        for point, place in zip(spline.points, dash, strict=True):
            point.co = (place.x, place.y, place.z + 2.0 * LINE, 1.0)
    curve.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new(curve.name, curve))
