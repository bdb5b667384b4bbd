"""The line of a touch over the terrain; without Blender."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from ..terrain.frame import TerrainFrame
from ..touch.recorder import Recorder

MOST_POINTS = 100_000
"""Of all trails of a take: ten minutes of wild circles would have a million, and millions of vertices."""

Numbers = npt.NDArray[np.float64]

Ground = Callable[[Numbers, Numbers], Numbers]
"""Metres of what must not bury the trail, at terrain metres east and north on the map; NaN for nothing."""


@dataclass(frozen=True)
class Trail:
    """The points of one touch."""

    places: Numbers
    """Terrain metres east, north and up, n x 3."""
    force: Numbers
    """Newtons, n."""


def contact_trails(
    recorder: Recorder, frame: TerrainFrame, ground: Ground, spacing: float, most: int = MOST_POINTS
) -> list[Trail]:
    """Split a take into its touches: from contact to free space, or to the seam of a map that wraps.

    Args:
        spacing: terrain metres. A tick nearer than this to the last point that was kept is left out,
            farther ones are joined along the ground.
        most: points of all trails together; they are farther apart where there would be more.
    """
    columns = recorder.columns
    places = np.stack([np.frombuffer(columns[f"proxy_{axis}"]) for axis in ("east", "north", "up")], axis=1)
    force = np.sqrt(sum(np.frombuffer(columns[f"force_{axis}"]) ** 2 for axis in "xyz"))
    ways = []
    for first, last in _touches(np.frombuffer(columns["feature"]) != 0.0, places[:, 0], frame):
        kept = _kept(places[first:last, :2], spacing) + first
        if len(kept) > 1:  # a single point has no direction to draw
            ways.append((kept, _distances(places[kept], spacing)))
    points = sum(along[-1] + 1.0 for _kept_ticks, along in ways)
    share = min(1.0, most / points) if ways else 1.0
    return [
        Trail(_lifted(_filled(places[kept], along, share), frame, ground), _filled(force[kept], along, share))
        for kept, along in ways
    ]


def _touches(
    in_contact: npt.NDArray[np.bool_], east: Numbers, frame: TerrainFrame
) -> Iterator[tuple[int, int]]:
    """Find the first tick of each touch, and the tick after its last."""
    turns = np.zeros(len(east)) if frame.turn is None else np.floor(east / frame.turn)
    changes = np.flatnonzero((in_contact[1:] != in_contact[:-1]) | (turns[1:] != turns[:-1])) + 1
    bounds = [0, *changes.tolist(), len(east)]
    for first, last in pairwise(bounds):
        if first < last and in_contact[first]:
            yield first, last


def _kept(places: Numbers, spacing: float) -> npt.NDArray[np.intp]:
    """Choose the first tick, and each that is at least ``spacing`` away from the one kept before it."""
    kept = [0]
    last_east, last_north = places[0].tolist()
    apart = spacing * spacing
    # Each choice depends on the one before, which numpy cannot do; plain floats are quick enough.
    for tick, (east, north) in enumerate(places.tolist()):
        if (east - last_east) ** 2 + (north - last_north) ** 2 >= apart:
            kept.append(tick)
            last_east, last_north = east, north
    return np.array(kept)


def _distances(places: Numbers, spacing: float) -> Numbers:
    """Count the steps of about ``spacing`` from the first kept point to each, one at the least."""
    away = np.diff(places[:, :2], axis=0)
    steps = np.maximum(1.0, np.ceil(np.hypot(away[:, 0], away[:, 1]) / spacing))
    return np.concatenate(([0.0], np.cumsum(steps)))


def _filled(values: Numbers, along: Numbers, share: float) -> Numbers:
    """Put a value at every step, or at a share of them, evenly along the way."""
    at = np.linspace(0.0, along[-1], max(2, int((along[-1] + 1.0) * share)))
    columns = values.reshape(len(values), -1).T
    filled = np.stack([np.interp(at, along, column) for column in columns], axis=-1)
    return filled if values.ndim > 1 else filled[:, 0]


def _lifted(places: Numbers, frame: TerrainFrame, ground: Ground) -> Numbers:
    """Lift the points that the ground would bury."""
    places[:, 2] = np.fmax(places[:, 2], ground(frame.on_map(places[:, 0]), places[:, 1]))
    return places
