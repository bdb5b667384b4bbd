"""The line of a touch over the terrain, and the tube that shows it; without Blender."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ..terrain.frame import TerrainFrame
from ..touch.recorder import Recorder

SIDES = 8
"""Of the tube around a trail."""

Ground = Callable[[float, float], float | None]
"""Metres of whatever must not bury the trail, at terrain metres east and north on the map."""


@dataclass(frozen=True)
class TrailPoint:
    """A place of the trail, terrain metres, and the force there, newtons."""

    east: float
    north: float
    up: float
    force: float


@dataclass(frozen=True)
class Tube:
    """Triangles around trails, and the force at each of their vertices."""

    positions: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int32]
    force: npt.NDArray[np.float64]


def contact_trails(
    recorder: Recorder, frame: TerrainFrame, ground: Ground, spacing: float
) -> Iterator[list[TrailPoint]]:
    """Split a take into its touches: from contact to free space, or to the seam of a map that wraps.

    Args:
        spacing: terrain metres; ticks closer together are left out, farther ones are joined along the ground.
    """
    trail: list[TrailPoint] = []
    turns = 0
    for point, in_contact in _ticks(recorder):
        crossed = bool(trail) and frame.turns(point.east) != turns
        if not in_contact or crossed:
            yield from _long_enough(trail)
            trail = []
        if in_contact:
            turns = frame.turns(point.east)
            _extend(trail, _lifted(point, frame, ground), frame, ground, spacing)
    yield from _long_enough(trail)


def tube(trails: list[list[TrailPoint]], frame: TerrainFrame, radius: float) -> Tube:
    """Wrap trails into tubes of ``radius`` (object coordinates), resting on the ground."""
    parts = [_tube(trail, frame, radius) for trail in trails]
    firsts = np.cumsum([0, *(len(part.positions) for part in parts)])
    return Tube(
        np.concatenate([part.positions for part in parts]),
        np.concatenate([part.triangles + first for part, first in zip(parts, firsts, strict=False)]).astype(
            np.int32
        ),
        np.concatenate([part.force for part in parts]),
    )


def _ticks(recorder: Recorder) -> Iterator[tuple[TrailPoint, bool]]:
    columns = recorder.columns
    names = ("proxy_east", "proxy_north", "proxy_up", "force_x", "force_y", "force_z", "feature")
    for east, north, up, x, y, z, feature in zip(*(columns[name] for name in names), strict=True):
        yield TrailPoint(east, north, up, math.hypot(x, y, z)), feature != 0.0


def _long_enough(trail: list[TrailPoint]) -> Iterator[list[TrailPoint]]:
    """A single point has no direction to draw."""
    if len(trail) > 1:
        yield trail


def _extend(
    trail: list[TrailPoint], point: TrailPoint, frame: TerrainFrame, ground: Ground, spacing: float
) -> None:
    """Append a point, and before it what lies between it and the last one along the ground."""
    if not trail:
        trail.append(point)
        return
    last = trail[-1]
    distance = math.hypot(point.east - last.east, point.north - last.north)
    if distance < spacing:
        return
    steps = math.ceil(distance / spacing)
    trail.extend(_lifted(_between(last, point, step / steps), frame, ground) for step in range(1, steps))
    trail.append(point)


def _between(start: TrailPoint, end: TrailPoint, share: float) -> TrailPoint:
    def mix(first: float, second: float) -> float:
        return first + share * (second - first)

    return TrailPoint(
        mix(start.east, end.east),
        mix(start.north, end.north),
        mix(start.up, end.up),
        mix(start.force, end.force),
    )


def _lifted(point: TrailPoint, frame: TerrainFrame, ground: Ground) -> TrailPoint:
    height = ground(frame.on_map(point.east), point.north)
    up = point.up if height is None else max(point.up, height)
    return TrailPoint(point.east, point.north, up, point.force)


def _tube(trail: list[TrailPoint], frame: TerrainFrame, radius: float) -> Tube:
    line = np.array([frame.to_object(point.east, point.north, point.up) for point in trail])
    along = np.gradient(line, axis=0)
    # A trail is never steeper than the ground; where it is nearly upright, any side will do.
    side = np.cross(along, (0.0, 0.0, 1.0))
    side[np.linalg.norm(side, axis=1) < 1e-12] = (1.0, 0.0, 0.0)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    over = np.cross(side, along)
    over /= np.maximum(np.linalg.norm(over, axis=1, keepdims=True), 1e-300)
    angles = np.linspace(0.0, 2.0 * math.pi, SIDES, endpoint=False)
    ring = np.cos(angles)[None, :, None] * side[:, None, :] + np.sin(angles)[None, :, None] * over[:, None, :]
    positions = (line[:, None, :] + radius * ring).reshape(-1, 3)
    force = np.repeat([point.force for point in trail], SIDES)
    return Tube(positions, _tube_triangles(len(trail)), force)


def _tube_triangles(points: int) -> npt.NDArray[np.int32]:
    """Join each ring to the next; the ends stay open."""
    rings = np.arange(points - 1)[:, None] * SIDES
    corner = np.arange(SIDES)[None, :]
    following = (corner + 1) % SIDES
    a, b = rings + corner, rings + following
    c, d = b + SIDES, a + SIDES
    triangles: npt.NDArray[np.int32] = np.stack((a, b, c, a, c, d), axis=-1).reshape(-1, 3).astype(np.int32)
    return triangles
