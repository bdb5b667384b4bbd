"""The time that Blender's timer takes of ours while a hand touches, pans, zooms and is recorded."""

from __future__ import annotations

import importlib
import math
import time
from pathlib import Path
from typing import Any

Times = list[tuple[float, float]]
"""Milliseconds of each tick by the clock, and of them at work: other programs may have the processor too."""

BETWEEN = 1.0 / 60.0
"""Seconds between two ticks, as the timer has it."""

PRESS_EVERY = 40
"""Ticks after which the stylus button goes down or up."""


def tick_milliseconds(label: Path, *, seconds: float) -> Times:
    """Time each tick on a live session, half of the time with a take in the making.

    Nothing is drawn: the bpy module has no window, and what a view costs is told apart.
    ``BLENDER_USER_RESOURCES`` must be set, as for every script that enables the extension.
    """
    import bpy
    from enable_addon import MODULE, enable

    bpy.ops.wm.read_factory_settings(use_empty=True)
    enable()
    bpy.ops.haptic_terrain.import_grid(filepath=str(label.resolve()))

    def part(name: str) -> Any:
        return importlib.import_module(f"{MODULE}.{name}")

    bpy.ops.haptic_terrain.touch_start()
    tick, live, stylus = part("touch.tick").tick, part("touch.live").live, part("touch.stylus")
    target = bpy.data.objects[part("touch.target").NAME]
    try:
        times = _ticks(tick, live.touch, stylus, target, seconds / 2.0)
        bpy.ops.haptic_terrain.record_start()
        times += _ticks(tick, live.touch, stylus, target, seconds / 2.0)
    finally:
        part("touch.stop").stop_touch()
        live.recording = None
    return times


def _ticks(tick: Any, touch: Any, stylus: Any, target: Any, seconds: float) -> Times:
    """Lead the hand in circles, down into the ground and up into the air; press the button at times."""
    import bpy

    times: Times = []
    for number in range(round(seconds / BETWEEN)):
        angle = 0.03 * number
        target.location = (2.0 * math.cos(angle), math.sin(angle), 0.6 * math.sin(0.37 * angle))
        bpy.context.view_layer.update()
        if number % PRESS_EVERY == 0:
            (stylus.release if touch.is_pressed else stylus.press)(touch)
        clock, work = time.perf_counter(), time.thread_time()
        tick()
        times.append(((time.perf_counter() - clock) * 1000.0, (time.thread_time() - work) * 1000.0))
        time.sleep(BETWEEN)
    return times
