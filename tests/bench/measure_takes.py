"""Measure what a take costs when it stops, on the demo's path; prints the figures as JSON.

The path is stepped, so the figures but for seconds are the same on every machine.
"""

from __future__ import annotations

import argparse
import importlib
import json
import statistics
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

ROUNDS = 5

BOUND_MM = 1.0

MINUTE = 60_000
"""Ticks."""


def main() -> None:
    """Measure, and print the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grid", type=Path, default=ROOT / "build" / "sample" / "sample.lbl")
    options = parser.parse_args()
    from enable_addon import use_resources

    use_resources(ROOT / "build" / "blender-user")
    from touch_demo.extension import enabled_extension
    from touch_demo.run import stage

    staged = stage(enabled_extension(), options.grid, 250_000, lambda _text: None)
    touch, data = felt(staged)
    print(json.dumps({**curve_seconds(touch, data, staged.terrain), **reduced(touch, data, staged.terrain)}))


def part(name: str) -> Any:
    """Import a part of the enabled extension."""
    from enable_addon import MODULE

    return importlib.import_module(f"{MODULE}.{name}")


def felt(staged: Any) -> tuple[Any, Any]:
    """Touch along the demo's path, stepped; gives the touch and its take."""
    import bpy
    from proxygraph import ScriptedDevice
    from touch_demo.hand_path import hand_path, windows
    from touch_demo.run import WORKSPACE

    chosen = windows(staged.ground, staged.tour, staged.kept.frame.exaggeration, WORKSPACE)
    path = hand_path(staged.ground, staged.tour, chosen, WORKSPACE[0])
    touch = part("touch.start").start_touch(
        bpy.context,
        terrain=staged.terrain,
        device=ScriptedDevice(path.points, workspace=WORKSPACE),
        window=chosen[0],
        on_the_clock=False,
    )
    recording = part("record.recording")
    recording.start_recording(bpy.context)
    touch.session.step(round(path.explore_at * 1000.0))
    touch.session.set_window(chosen[1])
    touch.session.step(round((path.seconds - path.explore_at) * 1000.0))
    part("touch.stop").note_model(touch)
    data = recording.take_data(part("touch.live").live.recording)
    recording.discard_recording(bpy.context)
    return touch, data


def curve_seconds(touch: Any, data: Any, terrain: Any) -> dict[str, float]:
    """Time the curves of a minute at the scene's rate: the demo's way again and again."""
    import bpy

    scene: Any = bpy.context.scene
    again = np.arange(MINUTE) % len(data)
    columns = {name: values[again] for name, values in data.columns.items()}
    columns["time"] = np.arange(MINUTE) / data.about.rate
    minute = part("record.take_data").TakeData(columns, data.about)
    options = part("record.take_options").TakeOptions(start_frame=1, trails=frozenset(), keep_ticks=False)
    seconds = [written(scene, minute, terrain, touch, options)[1] for _ in range(ROUNDS)]
    return {
        "fcurves_seconds_per_recorded_minute": round(
            statistics.median(seconds) * MINUTE / data.about.rate / minute.seconds, 4
        )
    }


def reduced(touch: Any, data: Any, terrain: Any) -> dict[str, float]:
    """Count the keys that a bound leaves of one for each tick, and of one for each frame."""
    import bpy

    scene: Any = bpy.context.scene
    render = scene.render
    at_scene_rate = counted(touch, data, terrain)
    render.fps, render.fps_base = round(data.about.rate), 1.0
    at_full_rate = counted(touch, data, terrain)
    return {
        "reduced_keys_share": round(at_full_rate["keys"] / at_full_rate["frames"], 4),
        "reduced_error_over_bound_max": max(at_full_rate["error"], at_scene_rate["error"]),
        "reduced_frames_under_ground": at_full_rate["under"] + at_scene_rate["under"],
        "reduced_keys": at_full_rate["keys"],
        "ticks": at_full_rate["frames"],
        "reduced_keys_at_scene_rate": at_scene_rate["keys"],
        "frames_at_scene_rate": at_scene_rate["frames"],
        "reducing_seconds_at_scene_rate_per_recorded_minute": round(
            at_scene_rate["seconds"] * 60.0 / data.seconds, 3
        ),
    }


def counted(touch: Any, data: Any, terrain: Any) -> dict[str, Any]:
    """Write the take with all keys and with few, and look at every frame where Blender has both."""
    import bpy

    scene: Any = bpy.context.scene
    options = part("record.take_options").TakeOptions
    every = options(start_frame=1, trails=frozenset())
    fewest = options(start_frame=1, trails=frozenset(), reduced=True, bound_mm=BOUND_MM)
    whole, _seconds = written(scene, data, terrain, touch, every)
    few, seconds = written(scene, data, terrain, touch, fewest)
    frames = np.arange(1, whole.keyframes + 1)
    apart = np.linalg.norm(shown(few.take, frames) - shown(whole.take, frames), axis=1)
    rate = scene.render.fps / scene.render.fps_base
    ticks = part("record.resample").ticks_at_frames(data.columns["time"], rate)
    placement = part("touch.placement").Placement.of(terrain, touch.frame)
    view = part("record.scene_view").SceneView(placement.frame, np.array(placement.matrix))
    bound = BOUND_MM / 1000.0 * data.terrain_per_hand[ticks] * view.units_per_metre
    places = view.to_terrain(shown(few.take, frames))
    ground = part("record.ground").Ground(touch.grid, touch.surface)
    under = ground.highest(view.frame.on_map(places[:, 0]), places[:, 1]) - places[:, 2]
    return {
        "keys": few.keyframes,
        "frames": whole.keyframes,
        "error": round(float((apart / bound).max()), 4),
        "under": int(np.count_nonzero(under > 0.0)),
        "seconds": seconds,
    }


def written(scene: Any, data: Any, terrain: Any, touch: Any, options: Any) -> tuple[Any, float]:
    """Write a take; gives it and the seconds that took."""
    placement = part("touch.placement").Placement.of(terrain, touch.frame)
    ground = part("record.ground").Ground(touch.grid, touch.surface)
    write = part("record.write_take").write_take
    began = time.perf_counter()
    take = write(scene, data, placement, ground, options)
    return take, time.perf_counter() - began


def shown(take: Any, frames: Any) -> Any:
    """Where Blender's curves have a take at whole frames, n x 3."""
    from tests.addon.scene import curves_of

    location = [curve for curve in curves_of(take) if curve.data_path == "location"]
    location.sort(key=lambda curve: curve.array_index)
    return np.array([[curve.evaluate(frame) for curve in location] for frame in frames.tolist()])


if __name__ == "__main__":
    main()
