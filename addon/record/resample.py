"""Ticks at 1 kHz to one key a frame; without Blender.

A key is a tick that was felt, the one nearest to the frame's time. Nothing depends on when the ticks
were collected, so a busy and an idle Blender write the same keys.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from .take_data import Numbers

HELD_SECONDS = 0.5
"""Without a tick, after which the point stays where it was instead of moving to where it is felt again."""


def ticks_at_frames(times: Numbers, frames_per_second: float) -> npt.NDArray[np.intp]:
    """Choose the tick for each frame, from the first tick's time to the last frame within the ticks.

    Args:
        times: seconds, rising.
    """
    if not len(times):
        return np.zeros(0, dtype=np.intp)
    # A thousandth of a frame: sums of ticks and of frames are rounded differently.
    count = int((times[-1] - times[0]) * frames_per_second + 1e-3) + 1
    wanted = times[0] + np.arange(count) / frames_per_second
    after = np.clip(np.searchsorted(times, wanted), 1, max(len(times) - 1, 1))
    before = after - 1
    if len(times) == 1:
        return np.asarray(before)
    nearer = np.abs(times[after] - wanted) <= np.abs(times[before] - wanted)
    return np.asarray(np.where(nearer, after, before))


def keys_before_jumps(turns: Numbers, times: Numbers) -> npt.NDArray[np.bool_]:
    """For each key, whether the next one lies beyond the seam of a map that wraps, or beyond a pause.

    Args:
        turns: how many times around the planet each key lies.
        times: seconds, of each key's tick.
    """
    jumps = (np.diff(turns) != 0.0) | (np.diff(times) > HELD_SECONDS)
    return np.append(jumps, False)[: len(turns)]
