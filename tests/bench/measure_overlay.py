"""Measure what the overlay costs a redraw of a 3D view of 1280 x 800 pixels; prints JSON.

    BLENDER_USER_RESOURCES=FOLDER python tests/bench/measure_overlay.py [--grid LABEL] [--picture PNG]

It needs Blender 5.2, which can draw in the background. The hand touches the ground and moves, and between two
frames the servo runs for as long as between two of a screen: words, arrow, ghost and window are new in each.
What is timed is our thread until all is handed to the driver, which finishes before the next frame begins.
What this does not show: the time of a graphics card (here a processor may draw), Blender's own redraw, and a
window's waiting for the screen.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

SAMPLE = ROOT / "build" / "sample" / "sample.lbl"

TICKS = 16
"""Milliseconds between two pictures of a screen."""


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--grid", type=Path, default=SAMPLE, help="what is touched; the synthetic sample")
    parser.add_argument("--frames", type=int, default=2000)
    parser.add_argument("--picture", type=Path, help="where to write the last frame, over the terrain")
    options = parser.parse_args()
    # They bring Blender, which reads its folders when it is imported.
    from tests.bench.touched_stage import touched_stage

    scene = touched_stage(options.grid)
    wall, processor = np.array([timed(scene) for _ in range(options.frames)]).T * 1000.0
    print(json.dumps(figures(wall, processor), indent=2))
    if options.picture is not None:
        scene.picture(options.picture)


def timed(scene: Any) -> tuple[float, float]:
    """Seconds of one frame: on the clock, and of them on the processor."""
    scene.advance(TICKS)
    wall, processor = time.perf_counter(), time.thread_time()
    scene.draw()
    seconds = time.perf_counter() - wall, time.thread_time() - processor
    scene.finish()
    return seconds


def figures(wall: Any, processor: Any) -> dict[str, float]:
    """Milliseconds a frame; the first, which makes letters, batches and textures, counts too.

    On a machine that is busy elsewhere only the time on the processor means something.
    """
    return {
        "overlay_draw_ms_p99": round(float(np.percentile(wall, 99.0)), 3),
        "overlay_draw_ms_median": round(float(np.median(wall)), 3),
        "overlay_draw_ms_first": round(float(wall[0]), 3),
        "overlay_draw_processor_ms_p99": round(float(np.percentile(processor, 99.0)), 3),
        "overlay_draw_processor_ms_median": round(float(np.median(processor)), 3),
        "overlay_draw_frames": len(wall),
    }


if __name__ == "__main__":
    main()
