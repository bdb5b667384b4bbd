"""From samples of an animated object to a goal for every millisecond; without Blender.

Between samples the goal follows a monotone cubic (F. N. Fritsch and J. Butland, "A method for constructing
local monotone piecewise cubic interpolants", SIAM Journal on Scientific and Statistical Computing 5, 1984):
smooth in speed, and never outside the box of the two samples around it, so that an object that stops does not
swing past its place. Only sums, products and quotients of single numbers: the same bits on every machine.
"""

from __future__ import annotations

import math

import numpy as np

from .take_data import RATE, Numbers


def unwrapped(east: Numbers, turn: float | None) -> Numbers:
    """Let east run on where an object went on at the other end of a map that wraps.

    Args:
        east: terrain metres at each sample.
        turn: metres once around; ``None`` on a map with edges.
    """
    if turn is None:
        return east
    turns = np.concatenate(([0.0], np.cumsum(np.rint(np.diff(east) / turn))))
    return np.asarray(east - turns * turn)


def tick_times(frames: int, frames_per_second: float) -> Numbers:
    """Seconds from the first frame on, a thousandth apart, until the last frame is reached.

    Args:
        frames: from the first to the last, at least 1.
    """
    # A thousandth of a tick: a rate such as 24000/1001 is rounded, which must not add a tick.
    ticks = math.ceil(frames / frames_per_second * RATE - 1e-3) + 1
    return np.arange(ticks, dtype=np.float64) / RATE


def goals_at(times: Numbers, places: Numbers, samples_per_second: float) -> Numbers:
    """Find the goal at each time, n x 3; after the last sample it stays there.

    Args:
        times: seconds from the first sample on.
        places: at evenly spaced samples, m x 3, at least two.
    """
    at = np.minimum(times * samples_per_second, float(len(places) - 1))
    before = np.minimum(at.astype(np.int64), len(places) - 2)
    share = (at - before)[:, None]
    rest = 1.0 - share
    slope = _slopes(places)
    start, end = places[before], places[before + 1]
    goals = (
        start * (rest * rest * (1.0 + 2.0 * share))
        + end * (share * share * (1.0 + 2.0 * rest))
        + slope[before] * (share * rest * rest)
        - slope[before + 1] * (share * share * rest)
    )
    # Rounding may lead a hair out of the box.
    return np.asarray(np.clip(goals, np.minimum(start, end), np.maximum(start, end)))


def _slopes(places: Numbers) -> Numbers:
    """Change from one sample to the next as it is at each sample: 0 where a coordinate turns back."""
    steps = np.diff(places, axis=0)
    earlier, later = steps[:-1], steps[1:]
    same_way = earlier * later > 0.0
    both = np.where(same_way, earlier + later, 1.0)
    between = np.where(same_way, 2.0 * earlier / both * later, 0.0)
    return np.concatenate((steps[:1], between, steps[-1:]))
