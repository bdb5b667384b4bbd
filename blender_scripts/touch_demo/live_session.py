"""Five seconds and more of touch on the clock, with the extension's timer function called by hand.

In the background Blender's timers never fire.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import bpy
from proxygraph import ScriptedDevice, Session, Statistics, Window

from touch_demo.counts import Counts
from touch_demo.extension import Extension
from touch_demo.hand_path import HandPath

POLL_SECONDS = 0.001
"""Between two looks at the servo's counters: swipes are told apart as finely as this."""


class TouchEndedError(RuntimeError):
    """Touch ended by itself; the text says why."""


@dataclass
class LiveTouch:
    """What the session and the take left behind."""

    statistics: Statistics
    seconds: float
    """Of the servo's clock."""
    swipes: Counts
    contact_model: str
    keyframes: int
    """Of all curves together."""
    take: bpy.types.Object
    trail: bpy.types.Object | None


def touch_live(
    extension: Extension,
    terrain: bpy.types.Object,
    path: HandPath,
    windows: list[Window],
    workspace: tuple[float, float, float],
    say: Callable[[str], None],
) -> LiveTouch:
    """Touch the terrain along a path, record it, and write the take.

    Raises:
        TouchEndedError: touch ended before the path did.
    """
    device = ScriptedDevice(path.points, workspace=workspace)
    touch = extension.start.start_touch(bpy.context, terrain=terrain, device=device, window=windows[0])
    session: Session = touch.session
    with _stopped_at_the_end(extension):
        bpy.ops.haptic_terrain.record_start()
        swipes = _follow(extension, session, path, windows[1], say)
        statistics, seconds = session.statistics(), session.state().time
        extension.tick.tick()
        written = extension.recording.stop_recording(bpy.context, trail=True)
    return LiveTouch(
        statistics=statistics,
        seconds=seconds,
        swipes=swipes,
        contact_model=session.model,
        keyframes=3 * written.keyframes,
        take=written.take,
        trail=written.trail,
    )


def _follow(
    extension: Extension, session: Session, path: HandPath, landforms: Window, say: Callable[[str], None]
) -> Counts:
    """Keep the scene up to date until the path ends; gives what happened within swipes."""
    swipes = Counts()
    exploring = False
    drawn = -1.0
    told = 0.0
    before, before_time = session.statistics(), session.state().time
    while before_time < path.seconds:
        time.sleep(POLL_SECONDS)
        now = time.perf_counter()
        if now - drawn >= extension.timer.SECONDS:
            drawn = now
            extension.tick.tick()
        if extension.live.live.touch is None:
            raise TouchEndedError(extension.live.live.message or "Touch ended before its path did.")
        after_time, after = session.state().time, session.statistics()
        if any(begin <= before_time and after_time <= end for begin, end in path.swipes):
            swipes.add(before, after)
        before, before_time = after, after_time
        if not exploring and after_time >= path.explore_at:
            exploring = True
            session.set_window(landforms)
        if after_time >= told:
            told += 1.0
            say(_told(extension, after_time))
    return swipes


def _told(extension: Extension, seconds: float) -> str:
    readout = extension.live.live.touch.readout
    longitude, latitude = readout.coordinates or (math.nan, math.nan)
    where = f"{longitude:6.1f} E {abs(latitude):5.1f} {'N' if latitude >= 0.0 else 'S'}"
    doing = f"touching, {readout.force:.2f} N" if readout.in_contact else "free"
    return f"  {seconds:4.1f} s  {where}  {doing}"


@contextmanager
def _stopped_at_the_end(extension: Extension) -> Iterator[None]:
    try:
        yield
    finally:
        extension.stop.stop_touch()
