#!/usr/bin/env python3
"""Bake touch: let an animated object, or the end of a bone, feel a terrain at 1 kHz, and make a take of it.

Runs with the bpy module (python bake_touch_path.py ...) and in Blender (blender -b scene.blend -P
bake_touch_path.py -- ...). The same scene gives the same bits: the summary has their digest.
"""

from __future__ import annotations

import argparse
import hashlib
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

# Blender does not look for modules beside the script that it runs.
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pipeline.command import RefusedError, Say, own_arguments, parser_of, run

TAKE_FILES = (".csv", ".npz", ".geojson")


def main(arguments: list[str]) -> int:
    """Exit codes: see ``--help``."""
    return run(_parser(), arguments, _bake)


def _parser() -> argparse.ArgumentParser:
    parser = parser_of("bake_touch_path.py", __doc__)
    parser.add_argument("--blend", type=Path, metavar="FILE", help="scene; else the one that is open")
    parser.add_argument("--grid", type=Path, metavar="FILE", help="elevation grid to import first")
    parser.add_argument("--goal", required=True, metavar="NAME", help="object that moves")
    parser.add_argument("--bone", default="", metavar="NAME", help="of the goal, whose end is followed")
    parser.add_argument("--tip", choices=("head", "tail"), default="tail", help="of the bone (%(default)s)")
    parser.add_argument("--terrain", default="", metavar="NAME", help="else the only one")
    parser.add_argument(
        "--frames", type=int, nargs=2, default=(0, 0), metavar=("FIRST", "LAST"), help="else the scene's"
    )
    parser.add_argument("--samples", type=int, metavar="N", help="of the scene for each frame (4)")
    parser.add_argument("--model", help="contact model; else the scene's")
    parser.add_argument("--reduced", action="store_true", help="fewest keys within 1 mm of the hand's motion")
    parser.add_argument("--output", type=Path, metavar="FILE", help="of the scene with the take (.blend)")
    parser.add_argument(
        "--take",
        type=Path,
        action="append",
        default=[],
        metavar="FILE",
        help=f"the take: {', '.join(TAKE_FILES)}",
    )
    return parser


def _bake(chosen: argparse.Namespace, say: Say) -> Mapping[str, Any]:
    for file in chosen.take:
        if file.suffix.lower() not in TAKE_FILES:
            raise RefusedError(f"{file}: expected a name that ends in {', '.join(TAKE_FILES)}.")
    from pipeline.models import known_model

    model = None if chosen.model is None else known_model(chosen.model)
    from pipeline.scene import enabled_parts, import_grid, open_blend, refused, save_blend

    parts = enabled_parts()
    scene = open_blend(chosen.blend)
    import bpy

    if chosen.grid is not None:
        import_grid(chosen.grid)
    bake_part = parts("record.bake")
    choices, kept = parts("ui.goal_choices"), parts("terrain.kept")
    settings = scene.haptic_terrain
    if model is not None:
        settings.contact_model = model
    with refused():
        settings.take_keys = "REDUCED" if chosen.reduced else settings.take_keys
        goal = choices.chosen_goal(bpy.context, chosen.goal, chosen.bone, chosen.tip.upper())
        terrain = choices.terrain_under(bpy.context, chosen.terrain)
        frames = choices.chosen_frames(bpy.context, *chosen.frames, _samples(chosen, bake_part))
        bake = bake_part.bake_of(bpy.context, goal, terrain, frames)
        say(f"Baking {goal.name} over {terrain.name}, frames {frames.first} to {frames.last}")
        began = time.perf_counter()
        result = parts("terrain.progress").finished(bake_part.baked(bake))
        seconds = time.perf_counter() - began
        say(f"{result.data.seconds:.1f} s of touch in {seconds:.2f} s")
        take = bake_part.write_baked(bake, result)
    for note in result.notes:
        say(note)
    for file in chosen.take:
        with refused():
            _data, missing = parts("record.take_files").export_take(take.take, file, lambda _share: None)
        if missing:
            say(missing)
    if chosen.output is not None:
        save_blend(chosen.output)
    data = result.data
    return {
        "blender": bpy.app.version_string,
        "goal": goal.name,
        "terrain": terrain.name,
        "source": data.about.source,
        "synthetic": kept.recall(terrain).grid.synthetic,
        "model": data.about.models[0],
        "frames": [frames.first, frames.last],
        "samples_per_frame": frames.per_frame,
        "seconds": data.seconds,
        "ticks": len(data),
        "in_contact_share": float(data.in_contact.mean()),
        "force_max_newtons": float(data.force.max()),
        "take": take.take.name,
        "keys": take.keyframes,
        "digest": digest(data.columns),
        "bake_seconds": seconds,
        "notes": list(result.notes),
        "written": [str(file) for file in (*chosen.take, *filter(None, [chosen.output]))],
    }


def _samples(chosen: argparse.Namespace, bake_part: Any) -> int:
    samples = bake_part.SAMPLES_PER_FRAME if chosen.samples is None else chosen.samples
    if not 1 <= samples <= 100:
        raise RefusedError(f"--samples is {samples}; expected 1 to 100.")
    return int(samples)


def digest(columns: Mapping[str, Any]) -> str:
    """Of every bit of a take's columns: the same for the same bake, in every Blender."""
    whole = hashlib.sha256()
    for name in sorted(columns):
        whole.update(name.encode() + columns[name].tobytes())
    return whole.hexdigest()


if __name__ == "__main__":
    sys.exit(main(own_arguments()))
