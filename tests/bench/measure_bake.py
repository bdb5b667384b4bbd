#!/usr/bin/env python3
"""How fast baking is, and the digest of what comes of it: the same in every Blender.

Prints one line of JSON. ``bake_realtime_factor`` is recorded seconds by seconds of baking, from the evaluated
scene to the take's columns: the median of some bakes in this process, after one that warms up.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import statistics
import sys
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blender_scripts"))

from bake_touch_path import digest
from pipeline.machine import processor
from pipeline.scene import Parts, enabled_parts, import_grid

SAMPLE = Path(__file__).resolve().parents[2] / "build" / "sample" / "sample.lbl"

SECONDS = 60
"""Of animation."""

RUNS = 5


def main() -> None:
    """Build the scene, bake, print."""
    parser = argparse.ArgumentParser(prog="measure_bake.py", description=__doc__)
    parser.add_argument("--grid", type=Path, default=SAMPLE)
    chosen = parser.parse_args()
    parts = enabled_parts()
    import bpy

    standard = os.dup(1)
    os.dup2(2, 1)  # the import reports there
    bpy.ops.wm.read_factory_settings(use_empty=True)
    parts = enabled_parts()
    import_grid(chosen.grid)
    terrain = bpy.context.view_layer.objects.active
    goals = {"empty": (_empty(), ""), "bone": (_rig(), "Arm")}
    found = {name: _measured(parts, terrain, *goal) for name, goal in goals.items()}
    os.dup2(standard, 1)
    figures = {
        "bake_realtime_factor": min(one["factor"] for one in found.values()),
        "digests": {name: one["digest"] for name, one in found.items()},
        "in_contact_share": {name: one["in_contact_share"] for name, one in found.items()},
        "factors": {name: one["factor"] for name, one in found.items()},
        "ticks": found["empty"]["ticks"],
        "grid": chosen.grid.name,
        "blender": bpy.app.version_string,
        "python": sys.version.split()[0],
        "machine": processor(),
        "cores": os.cpu_count(),
    }
    print(json.dumps(figures))


def _measured(parts: Parts, terrain: Any, goal: Any, bone: str) -> dict[str, Any]:
    import bpy

    bake, choices = parts("record.bake"), parts("ui.goal_choices")
    chosen = choices.chosen_goal(bpy.context, goal.name, bone, "TAIL")
    frames = choices.chosen_frames(bpy.context, 1, 1 + 24 * SECONDS, bake.SAMPLES_PER_FRAME)
    factors = []
    for _run in range(RUNS + 1):
        began = time.perf_counter()
        described = bake.bake_of(bpy.context, chosen, terrain, frames)
        data = parts("terrain.progress").finished(bake.baked(described)).data
        factors.append(data.seconds / (time.perf_counter() - began))
    return {
        "factor": round(statistics.median(factors[1:]), 1),
        "digest": digest(data.columns),
        "in_contact_share": round(float(data.in_contact.mean()), 4),
        "ticks": len(data),
    }


def _empty() -> Any:
    """An Empty on Bezier curves, led by a driver in height and by a constraint sideways."""
    import bpy

    scene = bpy.context.scene
    leader, goal = (bpy.data.objects.new(name, None) for name in ("Leader", "Goal"))
    for thing in (leader, goal):
        scene.collection.objects.link(thing)
    for number in range(13):
        leader.location = (4.0 * math.cos(2.0 * number), 2.0 * math.sin(3.0 * number), 0.0)
        leader.keyframe_insert("location", frame=1 + 120 * number)
    led = goal.constraints.new("COPY_LOCATION")
    led.target, led.use_z = leader, False
    goal.driver_add("location", 2).driver.expression = "-0.3 + 0.25 * sin(frame / 50)"
    return goal


def _rig() -> Any:
    """A bone that swings around, pressed into the ground."""
    import bpy

    armature = bpy.data.armatures.new("Rig")
    rig = bpy.data.objects.new("Rig", armature)
    bpy.context.scene.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    bone = armature.edit_bones.new("Arm")
    bone.head, bone.tail = (0.0, 0.0, 0.5), (0.0, 1.5, -0.2)
    bpy.ops.object.mode_set(mode="OBJECT")
    posed = rig.pose.bones["Arm"]
    posed.rotation_mode = "XYZ"
    for frame, angle in ((1, 0.0), (700, 5.0), (1441, -3.0)):
        posed.rotation_euler.y = angle
        posed.keyframe_insert("rotation_euler", frame=frame)
    return rig


if __name__ == "__main__":
    main()
