"""The scene of the rover's picture."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy
from mathutils import Vector
from pipeline.command import Say
from pipeline.growing_trail import GrowingTrail
from pipeline.scene import Parts, refused
from touch_demo.picture import Frame, open_scene, set_up_picture

from rover_demo.rover import add_rover
from rover_demo.way import draw_ahead, drive, feel, keep_on_the_ground, places

LENGTH = 0.13
"""Of the rover, Blender units: far too large for a planet, and large enough to be seen."""

SHOWN_FRAME = 120

FIRST_FRAME = 50
"""From which on the tracks are in the picture; the colours are for what was felt since."""

ACROSS = 0.82
"""Blender units, that the picture shows at the rover."""

PITCH, BEARING = math.radians(20.0), math.radians(-14.0)
"""Of the view: low, and north-westward to the volcanoes."""

SKY = (0.16, 0.135, 0.12, 1.0)
"""Also its light, which fills the shadows."""

THICKNESS = 0.35
"""Of the trails: as wide as the wheels, not as on the whole map."""


@dataclass(frozen=True)
class Staged:
    """What stands ready."""

    scene: bpy.types.Scene
    takes: list[Any]
    strongest: float
    """Newtons, of what is shown."""


def stage(parts: Parts, grid: Path, vertices: int, exaggeration: float, say: Say) -> Staged:
    """Import the planet, let the rover drive, and set the picture up."""
    scene = open_scene()
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    say(f"Importing {grid.name}")
    with refused():
        bpy.ops.haptic_terrain.import_grid(
            filepath=str(grid), vertex_budget=vertices, exaggeration=exaggeration
        )
    terrain = parts("ui.goal_choices").terrain_under(bpy.context, "")
    rover = add_rover(scene, LENGTH)
    drive(rover, scene)
    say("Following the ground")
    keep_on_the_ground(rover, LENGTH)
    say("Baking what the wheels feel")
    takes = feel(rover, LENGTH, parts)
    bake = parts("record.bake")

    way = places(rover, scene)
    scene.frame_set(SHOWN_FRAME)
    begin, end = ((frame - 1) / bake.frame_rate(scene) for frame in (FIRST_FRAME, SHOWN_FRAME))
    strongest = max(_strongest(result.data, begin, end) for result, _take in takes)
    tracks = _tracks(parts, takes, strongest, end)
    title = parts("terrain.kept").recall(terrain).grid.title
    frame = Frame(
        centre=way[SHOWN_FRAME - 1] + Vector((-0.13, 0.1, 0.04)),
        across=ACROSS,
        caption=f"{title}   heights \N{MULTIPLICATION SIGN}{exaggeration:g}   wheels baked at 1 kHz",
        strongest=strongest,
        pitch=PITCH,
        bearing=BEARING,
    )
    set_up_picture(terrain, tracks[0], frame)
    background = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = SKY
    draw_ahead(scene, way[SHOWN_FRAME + 8 :], bpy.data.materials["Caption"])
    return Staged(scene, [take for _result, take in takes], strongest)


def _strongest(data: Any, begin: float, end: float) -> float:
    """Newtons that were felt at most between two moments, seconds."""
    time = data.columns["time"]
    return float(data.force[(begin <= time) & (time <= end)].max())


def _tracks(parts: Parts, takes: list[tuple[Any, Any]], strongest: float, seconds: float) -> list[Any]:
    """Show what the wheels have felt up to a moment, in colours of one scale."""
    shown, material = parts("record.trail_tube"), parts("terrain.material")
    ramp = material.Ramp(shown.FORCE, 0.0, strongest, shown.COLOURS, glow=0.6)
    colours = material.ramp_material("Wheel force", ramp)
    tracks = []
    for result, take in takes:
        take.take.hide_render = True  # its cone stands where the wheel is
        track = GrowingTrail(parts, result.data, result.stand.placement, result.ground, thickness=THICKNESS)
        track.show(seconds)
        track.thing.data.materials[0] = colours
        tracks.append(track.thing)
    return tracks
