#!/usr/bin/env python3
"""A rover over the synthetic planet: it follows the ground along its keyed path, and its wheels feel it.

Writes rover.png and rover.blend. Heights, path and rover are made up; the planet is called synthetic wherever
it is named.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

# Blender does not look for modules beside the script that it runs.
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pipeline.command import Say, own_arguments, parser_of, run

SAMPLE = Path(__file__).resolve().parents[1] / "build" / "sample" / "sample.lbl"

VERTICES = 1_100_000
"""Every sample is shown."""

EXAGGERATION = 25.0


def main(arguments: list[str]) -> int:
    """Exit codes: see ``--help``."""
    return run(_parser(), arguments, _run)


def _parser() -> argparse.ArgumentParser:
    parser = parser_of("rover.py", __doc__)
    parser.add_argument(
        "--output", type=Path, default=Path("build/rover"), metavar="FOLDER", help="of results (%(default)s)"
    )
    parser.add_argument("--percent", type=int, default=100, metavar="N", help="of the picture's size")
    return parser


def _run(chosen: argparse.Namespace, say: Say) -> Mapping[str, Any]:
    if not SAMPLE.is_file():
        from make_sample_grid import make_sample

        say("Making the synthetic sample grid")
        make_sample(SAMPLE.parent)
    from pipeline.scene import enabled_parts, save_blend

    parts = enabled_parts()
    import bpy
    from rover_demo.staging import Staged, stage

    staged: Staged = stage(parts, SAMPLE, VERTICES, EXAGGERATION, say)
    chosen.output.mkdir(parents=True, exist_ok=True)
    picture, blend = chosen.output / "rover.png", chosen.output / "rover.blend"
    from touch_demo.picture import render_picture

    staged.scene.render.resolution_percentage = chosen.percent
    say("Rendering the picture")
    render_picture(picture)
    save_blend(blend)
    return {
        "blender": bpy.app.version_string,
        "source": SAMPLE.with_suffix(".img").name,
        "synthetic": True,
        "exaggeration": EXAGGERATION,
        "frames": [staged.scene.frame_start, staged.scene.frame_end],
        "takes": [take.take.name for take in staged.takes],
        "force_max_newtons": staged.strongest,
        "written": [str(picture), str(blend)],
    }


if __name__ == "__main__":
    sys.exit(main(own_arguments()))
