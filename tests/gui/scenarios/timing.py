"""How long the timer takes, and how many frames are drawn with touch and without: for a bench, not a test.

In both kinds of blocks the Empty and the cursor move sixty times a second, for a scene that changes is drawn
more slowly than one that stands still; what differs is all that touch adds, the sidebar's new text included.
"""

from __future__ import annotations

import math
import random
import time
from typing import Any

import bpy
import numpy as np

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script

FRAME = 1.0 / 60.0
"""Seconds between two moves of the hand."""

DEPTH = -0.3
"""Blender units under the ground's reference where the Empty pulls the hand."""


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    yield from steps.drop(blender, "planet.lbl")
    yield from steps.confirm(blender)
    yield from steps.imported(blender)
    yield from steps.shade_plainly(blender)
    drawn = _count_draws(blender)
    ticks = _time_ticks(blender)
    blocks = [True, False] * blender.options["rounds"]
    random.Random(1).shuffle(blocks)
    frames: dict[bool, list[float]] = {True: [], False: []}
    for with_touch in [True, *blocks]:  # the first one warms up
        if with_touch:
            yield from steps.start_touch(blender)
        before, began = drawn[0], time.monotonic()
        yield from _move(blender, blender.options["seconds"], with_touch=with_touch)
        frames[with_touch].append((drawn[0] - before) / (time.monotonic() - began))
        if with_touch:
            yield from steps.stop_touch(blender)
    yield from blender.picture("end")
    warm = len(ticks) // len(frames[True])
    blender.figures |= {
        "tick_ms": {str(share): float(np.quantile(ticks[warm:], share)) for share in (0.5, 0.9, 0.99, 1.0)},
        "ticks": len(ticks) - warm,
        "frames_per_s_with": frames[True][1:],
        "frames_per_s_without": frames[False],
    }


def _move(blender: Blender, seconds: float, *, with_touch: bool) -> Script[None]:
    """Lead the hand in circles over the ground, or the mere objects."""
    target = bpy.data.objects[blender.part("touch.target").NAME]
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        angle = 2.0 * time.monotonic()
        target.location = (math.cos(angle), math.sin(angle), DEPTH)
        if not with_touch:
            steps.cursor(blender).location = target.location
        yield FRAME


def _count_draws(blender: Blender) -> list[int]:
    """Count what the 3D view draws; one number in a list."""
    drawn = [0]

    def count() -> None:
        drawn[0] += 1

    bpy.types.SpaceView3D.draw_handler_add(count, (), "WINDOW", "POST_PIXEL")
    return drawn


def _time_ticks(blender: Blender) -> list[float]:
    """Milliseconds of each tick from now on."""
    timer: Any = blender.part("touch.timer")
    tick, times = timer.tick, []

    def timed() -> None:
        began = time.perf_counter()
        tick()
        times.append((time.perf_counter() - began) * 1000.0)

    timer.tick = timed
    return times
