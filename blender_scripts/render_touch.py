#!/usr/bin/env python3
"""Render a take: stills or an animation of the touching point and its trail over the terrain, as PNG files.

Workbench by default, which takes about a second a frame and no GPU; with the scene's own camera, or one that
sees the whole take. The scene's file stays as it is.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

# Blender does not look for modules beside the script that it runs.
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pipeline.command import RefusedError, Say, own_arguments, parser_of, run

ENGINES = {
    "workbench": ("BLENDER_WORKBENCH",),
    "cycles": ("CYCLES",),
    "eevee": ("BLENDER_EEVEE_NEXT", "BLENDER_EEVEE"),
}
"""By what Blenders call them."""


def main(arguments: list[str]) -> int:
    """Exit codes: see ``--help``."""
    return run(_parser(), arguments, _render)


def _parser() -> argparse.ArgumentParser:
    parser = parser_of("render_touch.py", __doc__)
    parser.add_argument("--blend", type=Path, metavar="FILE", help="scene; else the one that is open")
    parser.add_argument("--take", default="", metavar="NAME", help="else the only one")
    parser.add_argument("--output", type=Path, required=True, metavar="FOLDER", help="of touch_0001.png ...")
    parser.add_argument("--frames", type=int, nargs=2, metavar=("FIRST", "LAST"), help="else the take's")
    parser.add_argument("--step", type=int, default=1, metavar="N", help="every Nth frame (%(default)s)")
    parser.add_argument("--still", type=int, metavar="FRAME", help="this frame alone")
    parser.add_argument("--growing", action="store_true", help="the trail is as long as was felt so far")
    parser.add_argument(
        "--resolution",
        type=int,
        nargs=2,
        default=(960, 540),
        metavar=("WIDTH", "HEIGHT"),
        help="pixels (960 540)",
    )
    parser.add_argument("--engine", choices=tuple(ENGINES), default="workbench", help="(%(default)s)")
    parser.add_argument("--samples", type=int, default=16, metavar="N", help="of Cycles (%(default)s)")
    parser.add_argument("--camera", metavar="NAME", help="else the scene's, or one that sees the take")
    return parser


def _render(chosen: argparse.Namespace, say: Say) -> Mapping[str, Any]:
    _check(chosen)
    from pipeline.scene import enabled_parts, open_blend

    parts = enabled_parts()
    scene = open_blend(chosen.blend)
    import bpy
    from pipeline.pictures import Pictures

    pictures = Pictures(parts, scene, chosen.take)
    frames = _frames(chosen, pictures)
    pictures.set_up(
        engines=ENGINES[chosen.engine],
        resolution=tuple(chosen.resolution),
        samples=chosen.samples,
        camera=chosen.camera,
        growing=chosen.growing,
    )
    chosen.output.mkdir(parents=True, exist_ok=True)
    files, began = [], time.perf_counter()
    for number, frame in enumerate(frames):
        file = chosen.output / f"touch_{frame:04d}.png"
        pictures.render(frame, file)
        files.append(str(file))
        say(f"Frame {frame}: {number + 1} of {len(frames)}")
    seconds = time.perf_counter() - began
    return {
        "blender": bpy.app.version_string,
        "take": pictures.take.name,
        "terrain": pictures.data.about.terrain,
        "source": pictures.data.about.source,
        "engine": scene.render.engine,
        "resolution": list(chosen.resolution),
        "frames": frames,
        "seconds_per_frame": round(seconds / len(frames), 3),
        "written": files,
    }


def _check(chosen: argparse.Namespace) -> None:
    if min(chosen.resolution) < 4 or max(chosen.resolution) > 65536:
        raise RefusedError(f"--resolution is {chosen.resolution}; expected 4 to 65536 pixels each way.")
    if chosen.step < 1 or chosen.samples < 1:
        raise RefusedError("--step and --samples are counts; expected at least 1.")
    if chosen.frames is not None and chosen.frames[1] < chosen.frames[0]:
        raise RefusedError("--frames run backwards, from {} to {}.".format(*chosen.frames))
    if chosen.output.exists() and not chosen.output.is_dir():
        raise RefusedError(f"{chosen.output} is a file; expected a folder.")


def _frames(chosen: argparse.Namespace, pictures: Any) -> list[int]:
    if chosen.still is not None:
        return [chosen.still]
    first, last = chosen.frames or pictures.frames
    return list(range(first, last + 1, chosen.step))


if __name__ == "__main__":
    sys.exit(main(own_arguments()))
