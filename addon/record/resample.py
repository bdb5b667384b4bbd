"""Ticks at 1 kHz to one key a frame; without Blender.

A key is a tick that was felt, the one nearest to the frame's time. Nothing depends on when the ticks
were collected, so a busy and an idle Blender write the same keys.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise


def ticks_at_frames(times: Sequence[float], frames_per_second: float) -> list[int]:
    """Choose the tick for each frame, from the first tick's time to the last frame within the ticks.

    Args:
        times: seconds, rising.
    """
    chosen: list[int] = []
    if not times:
        return chosen
    tick = 0
    while True:
        wanted = times[0] + len(chosen) / frames_per_second
        # A thousandth of a frame: sums of ticks and of frames are rounded differently.
        if wanted > times[-1] + 1e-3 / frames_per_second:
            return chosen
        while tick + 1 < len(times) and abs(times[tick + 1] - wanted) <= abs(times[tick] - wanted):
            tick += 1
        chosen.append(tick)


def keys_before_jumps(turns: Sequence[int]) -> list[bool]:
    """For each key, whether the next one lies beyond the seam of a map that wraps.

    Args:
        turns: how many times around the planet each key lies.
    """
    jumps = [now != after for now, after in pairwise(turns)]
    return [*jumps, False] if turns else []
