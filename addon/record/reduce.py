"""Leaving keys out: the fewest between which straight lines stay near enough; without Blender.

A key is always a value at a frame. Whether a line from one frame to another will do says nothing of shorter
lines (the frame between may be the one that sticks out), so a greedy walk would miss better ways: this is a
breadth-first search over the frames, which finds the fewest keys. On long takes it goes on only from the
``BEAM`` farthest frames of those that as many keys reach; the ends that it lets go seldom lead farther.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from .take_data import Numbers

BEAM = 16
"""Frames from which the search goes on. A way of no more frames has the fewest keys for certain."""

FIRST_LOOK = 64
"""Frames ahead that are looked at first; twice as many each time where lines may lead farther."""

MOST_CHECKED = 1 << 16
"""Places that are checked at once: it bounds memory, not the result."""

Clear = Callable[[Numbers], npt.NDArray[np.bool_]]
"""Says of points (n x d) whether nothing buries them."""


def fewest_keys(places: Numbers, tolerance: Numbers, clear: Clear | None = None) -> npt.NDArray[np.intp]:
    """Choose the frames that need a key, the first and the last among them.

    Args:
        places: the value that a key at each frame would have, n x d, rounded as it will be kept.
        tolerance: how far the value at each frame may be from that without a key, n.
        clear: what must also hold at every frame without a key.
    """
    count = len(places)
    if count <= 2:
        return np.arange(count)
    before: dict[int, int] = {}
    reached = [0]
    while True:
        found: dict[int, int] = {}
        for first in sorted(reached, reverse=True):
            # Nearer ends than those that are kept anyway need no check.
            enough = sorted(found, reverse=True)[BEAM - 1] if len(found) >= BEAM else first
            for last in _reachable(places, tolerance, clear, first, enough):
                if last not in before:
                    found.setdefault(last, first)
        reached = sorted(found, reverse=True)[:BEAM]
        before.update((last, found[last]) for last in reached)
        if count - 1 in before:
            return np.array([*_way_back(before, count - 1)][::-1])


def _way_back(before: dict[int, int], frame: int) -> Iterator[int]:
    yield frame
    while frame in before:
        frame = before[frame]
        yield frame


def _reachable(
    places: Numbers, tolerance: Numbers, clear: Clear | None, first: int, beyond: int
) -> list[int]:
    """Find the farthest frames after ``beyond`` that a line from ``first`` leads to, ``BEAM`` at the most."""
    ends = _candidates(places, tolerance, first)
    ends = ends[ends > beyond][::-1]
    found: list[int] = []
    at = 0
    while at < len(ends) and len(found) < BEAM:
        most = max(1, MOST_CHECKED // max(1, int(ends[at]) - first))
        some = ends[at : at + min(BEAM, most)]
        found += some[_hold(places, tolerance, clear, first, some)].tolist()
        at += len(some)
    return found[:BEAM]


def _candidates(places: Numbers, tolerance: Numbers, first: int) -> npt.NDArray[np.intp]:
    """Find the frames to which a line may lead, by a quick look along each axis by itself.

    A line from the first frame has a slope; each frame that it passes allows slopes between two bounds, and
    all of them those between the highest lower and the lowest upper bound.
    """
    ends: list[npt.NDArray[np.intp]] = [np.array([first + 1])]
    low = np.full(places.shape[1], -np.inf)
    high = -low
    start, look = first + 1, FIRST_LOOK
    while start < len(places) and (low <= high).all():
        frames = np.arange(start, min(len(places), start + look))
        steps = (frames - first)[:, None]
        room = tolerance[frames][:, None] * (1.0 + 1e-9)
        slopes = (places[frames] - places[first]) / steps
        lows = np.maximum.accumulate(np.vstack((low, slopes - room / steps)))
        highs = np.minimum.accumulate(np.vstack((high, slopes + room / steps)))
        ends.append(frames[((lows[:-1] <= slopes) & (slopes <= highs[:-1])).all(axis=1)])
        low, high = lows[-1], highs[-1]
        start, look = start + look, 2 * look
    return np.unique(np.concatenate(ends))


def _hold(
    places: Numbers,
    tolerance: Numbers,
    clear: Clear | None,
    first: int,
    ends: npt.NDArray[np.intp],
) -> npt.NDArray[np.bool_]:
    """Check for each end, falling, every frame that a line from ``first`` to it passes."""
    between = np.arange(first + 1, int(ends[0]))
    passed = between[None, :] < ends[:, None]
    shares = np.where(passed, (between - first)[None, :] / (ends - first)[:, None], 0.0)[:, :, None]
    points = places[first] + (places[ends] - places[first])[:, None, :] * shares
    apart = np.linalg.norm(points - places[between], axis=2)
    holds: npt.NDArray[np.bool_] = np.all(~passed | (apart <= tolerance[between]), axis=1)
    if clear is not None and holds.any():
        asked = passed & holds[:, None]
        buried = np.zeros(asked.shape, dtype=bool)
        buried[asked] = ~clear(points[asked])
        holds &= ~buried.any(axis=1)
    return holds


def at_every_frame(frames: npt.NDArray[Any], values: Numbers, held: npt.NDArray[np.bool_]) -> Numbers:
    """What keys say at every whole frame from the first to the last.

    Args:
        frames: of the keys, whole numbers, rising.
        values: of the keys, n x d.
        held: for each key, whether its value stays until the next one.
    """
    whole = np.arange(frames[0], frames[-1] + 1)
    key = np.clip(np.searchsorted(frames, whole, side="right") - 1, 0, max(len(frames) - 2, 0))
    after = np.minimum(key + 1, len(frames) - 1)
    lengths = np.maximum(frames[after] - frames[key], 1)
    shares = (whole - frames[key]) / lengths
    shares[held[key] & (shares < 1.0)] = 0.0
    between: Numbers = values[key] + (values[after] - values[key]) * shares[:, None]
    return between
