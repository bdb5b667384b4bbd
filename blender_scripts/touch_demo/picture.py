"""A picture of the touched terrain, rendered on the processor alone: no GPU, no display."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import bpy
from mathutils import Vector

from touch_demo.overlay import add_caption, add_legend

WIDTH, HEIGHT = 1200, 675
SAMPLES = 24
LENS, SENSOR = 50.0, 36.0
"""Millimetres: a normal lens."""
PITCH = math.radians(50.0)
"""Of the view, below the horizon: as on a table."""


@dataclass(frozen=True)
class Frame:
    """What the picture shows."""

    centre: Vector
    """In the middle of the picture, scene coordinates."""
    across: float
    """Blender units from edge to edge, at the middle."""
    caption: str
    strongest: float
    """Newtons at the upper end of the trail's colours."""
    pitch: float = PITCH
    bearing: float = 0.0
    """Radians, clockwise from north: where the view looks."""


def set_up_picture(terrain: bpy.types.Object, trail: bpy.types.Object | None, frame: Frame) -> None:
    """Put light, camera and captions into the scene, and dress the terrain."""
    scene = open_scene()
    terrain.data.shade_smooth()
    camera = _camera(scene, frame)
    _sun(scene)
    _sky(scene)
    add_caption(scene, camera, frame.caption)
    if trail is not None:
        add_legend(scene, camera, trail, frame.strongest)
    _settings(scene)


def render_picture(path: Path) -> None:
    """Render the scene to a PNG file."""
    scene = open_scene()
    scene.render.filepath = str(path.resolve())
    bpy.ops.render.render(write_still=True)
    # Beside the .blend file, wherever that will be.
    scene.render.filepath = f"//{path.name}"


def open_scene() -> bpy.types.Scene:
    """The scene that scripts work in."""
    scene = bpy.context.scene
    if scene is None:
        raise RuntimeError("Blender has no scene open.")
    return scene


def _camera(scene: bpy.types.Scene, frame: Frame) -> bpy.types.Object:
    """Look from above."""
    distance = frame.across * LENS / SENSOR
    camera = bpy.data.cameras.new("Picture")
    camera.lens, camera.sensor_width = LENS, SENSOR
    camera.clip_start, camera.clip_end = 0.001 * distance, 100.0 * distance
    camera.dof.focus_distance = distance
    eye = bpy.data.objects.new("Picture", camera)
    level = math.cos(frame.pitch)
    away = Vector((-level * math.sin(frame.bearing), -level * math.cos(frame.bearing), math.sin(frame.pitch)))
    eye.location = frame.centre + distance * away
    eye.rotation_euler = away.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(eye)
    scene.camera = eye
    return eye


def _sun(scene: bpy.types.Scene) -> None:
    """From the north-west, as on maps, and low enough for shadows."""
    light = bpy.data.lights.new("Sun", "SUN")
    light.energy, light.angle = 4.6, math.radians(1.5)
    light.color = (1.0, 0.93, 0.84)
    sun = bpy.data.objects.new("Sun", light)
    height, bearing = math.radians(30.0), math.radians(295.0)
    toward = Vector(
        (math.cos(height) * math.sin(bearing), math.cos(height) * math.cos(bearing), math.sin(height))
    )
    sun.rotation_euler = toward.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)


def _sky(scene: bpy.types.Scene) -> None:
    """A dim dusty glow, so that shadows are not black."""
    world = bpy.data.worlds.new("Dust")
    if world.node_tree is None:  # older than 5.0
        world.use_nodes = True
    background = next(node for node in world.node_tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = (0.09, 0.075, 0.07, 1.0)
    scene.world = world


def _settings(scene: bpy.types.Scene) -> None:
    render = scene.render
    render.engine = "CYCLES"  # type: ignore[assignment]  # an add-on, which the stubs do not know
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.seed = 0
    scene.cycles.max_bounces = 2
    scene.cycles.use_denoising = _has_denoiser(scene)
    render.resolution_x, render.resolution_y, render.resolution_percentage = WIDTH, HEIGHT, 100
    # Dither is noise: it doubles the size of the file.
    render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGB"
    render.image_settings.compression = 100


def _has_denoiser(scene: bpy.types.Scene) -> bool:
    """Not every build of Blender has one that runs on the processor."""
    try:
        scene.cycles.denoiser = "OPENIMAGEDENOISE"
    except TypeError:
        return False
    return True
