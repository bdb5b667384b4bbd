"""The scripted hand: fast swipes across the whole map, then a slow way over its landforms."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from types import ModuleType

from proxygraph import Grid, Window

from touch_demo.tour import LIFT, Stop, Tour

Point = tuple[float, float, float, float]
"""Seconds, and x, y, z of the hand in the workspace, metres."""

SWIPE_CELLS_PER_UPDATE = 13.4
"""As fast as the paper's hands: 13.4 vertices in an update (paper 4.4)."""

SWIPES = 8

SWIPE_PRESS = 1.0
"""Millimetres of the workspace under the ground: half a newton on a level plain."""

EXPLORE_SECONDS = 5.6

SECONDS_PER_UPDATE = 0.001


@dataclass(frozen=True)
class Ground:
    """Places of the map in degrees, as the hand in the workspace meets them."""

    laid: ModuleType
    """The extension's ``touch.workspace``: how the device's workspace lies on the terrain."""
    grid: Grid
    west: float
    """Degrees east of the map's outer edge; and north, below."""
    north: float
    cells_per_degree: float
    lowest: float
    highest: float
    """Metres, of the whole grid."""

    def terrain(self, longitude: float, latitude: float) -> tuple[float, float]:
        """Terrain metres east and north; samples are at cell centres."""
        layout = self.grid.layout
        column = (longitude - self.west) * self.cells_per_degree - 0.5
        row = (self.north - latitude) * self.cells_per_degree - 0.5
        column = min(max(column, 0.0), layout.columns - 1.0)
        row = min(max(row, 0.0), layout.rows - 1.0)
        return column * layout.cell_width, -row * layout.cell_height

    def hand(self, stop: Stop, window: Window, width: float) -> tuple[float, float, float]:
        """Where the hand (workspace metres) is at a stop; ``width`` is the workspace's."""
        east, north = self.terrain(stop.longitude, stop.latitude)
        height = self.grid.elevation_at(east, north)
        x, y, z = self.laid.to_workspace(
            (east, north, self.lowest if height is None else height), window, width
        )
        return x, y, z - stop.press / 1000.0


@dataclass(frozen=True)
class HandPath:
    """What the hand does, and when."""

    points: list[Point]
    swipes: list[tuple[float, float]]
    """Beginning and end of each swipe, seconds."""
    explore_at: float
    """Seconds: the workspace is laid over the landforms then; the hand is high in the air."""
    seconds: float
    """All of it."""


def windows(
    ground: Ground, tour: Tour, exaggeration: float, workspace: tuple[float, float, float]
) -> list[Window]:
    """The whole map for the swipes; the landforms for exploring."""
    layout = ground.grid.layout
    east, north, whole = ground.laid.whole_map(layout, workspace)
    middle_up = 0.5 * (ground.lowest + ground.highest)
    stops = [ground.terrain(stop.longitude, stop.latitude) for stop in tour.stops]
    explored = min(whole, tour.window_degrees * ground.cells_per_degree * layout.cell_width)
    return [
        Window(east, north, middle_up, width=whole, exaggeration=exaggeration),
        Window(
            0.5 * (min(stop[0] for stop in stops) + max(stop[0] for stop in stops)),
            0.5 * (min(stop[1] for stop in stops) + max(stop[1] for stop in stops)),
            middle_up,
            width=explored,
            exaggeration=exaggeration,
        ),
    ]


def hand_path(ground: Ground, tour: Tour, chosen: Sequence[Window], width: float) -> HandPath:
    """Write down where the hand is, millisecond by millisecond where it is fast.

    Args:
        chosen: from ``windows``.
        width: of the device's workspace, metres.
    """
    whole, landforms = chosen
    relief = 0.5 * (ground.highest - ground.lowest) * width
    above_all = max(relief * window.exaggeration / window.width for window in chosen) + 0.005
    points: list[Point] = []
    swipes: list[tuple[float, float]] = []
    time = 0.0
    for number in range(SWIPES):
        line = list(_swipe_line(ground, tour.swipe_latitudes[number // 2 % 2], backward=bool(number % 2)))
        hover = Stop(line[0].longitude, line[0].latitude, LIFT)
        points.append((time, *ground.hand(hover, whole, width)))
        time += 0.06
        begin = time
        for stop in line:
            points.append((time, *ground.hand(stop, whole, width)))
            time += SECONDS_PER_UPDATE
        swipes.append((begin, time - SECONDS_PER_UPDATE))
        time += 0.06
        hover = Stop(line[-1].longitude, line[-1].latitude, LIFT)
        points.append((time, *ground.hand(hover, whole, width)))
        time += 0.08
    x, y, _z = points[-1][1:]
    points.append((time + 0.05, x, y, above_all))
    first = ground.hand(tour.stops[0], landforms, width)
    explore_at = time + 0.25
    points.append((time + 0.40, first[0], first[1], above_all))
    time += 0.55
    for share, stop in _explored(tour.stops):
        points.append((time + share * EXPLORE_SECONDS, *ground.hand(stop, landforms, width)))
    return HandPath(points, swipes, explore_at, time + EXPLORE_SECONDS)


def _swipe_line(ground: Ground, latitude: float, *, backward: bool) -> Iterator[Stop]:
    """The places of a swipe, an update apart, from one edge of the map almost to the other."""
    layout = ground.grid.layout
    degrees = layout.columns / ground.cells_per_degree
    updates = max(2, math.floor(0.98 * layout.columns / SWIPE_CELLS_PER_UPDATE))
    step = SWIPE_CELLS_PER_UPDATE / ground.cells_per_degree
    for update in range(updates + 1):
        along = 0.01 * degrees + update * step
        yield Stop(ground.west + (degrees - along if backward else along), latitude, SWIPE_PRESS)


def _explored(stops: Sequence[Stop], per_leg: int = 60) -> Iterator[tuple[float, Stop]]:
    """Smoothly through the stops (Catmull-Rom), each with its share of the time by the way's length."""
    way: list[Stop] = []
    for leg in range(len(stops) - 1):
        around = [stops[min(max(leg + offset, 0), len(stops) - 1)] for offset in (-1, 0, 1, 2)]
        way += [_between(around, step / per_leg) for step in range(per_leg)]
    way.append(stops[-1])
    lengths = [0.0]
    for a, b in pairwise(way):
        lengths.append(lengths[-1] + math.hypot(b.longitude - a.longitude, b.latitude - a.latitude))
    for length, stop in zip(lengths, way, strict=True):
        yield length / lengths[-1], stop


def _between(around: Sequence[Stop], t: float) -> Stop:
    def spline(a: float, b: float, c: float, d: float) -> float:
        return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))

    _a, b, c, _d = around
    return Stop(
        spline(*(stop.longitude for stop in around)),
        spline(*(stop.latitude for stop in around)),
        # A spline would overshoot, and lift the hand where it should press.
        b.press + (c.press - b.press) * t,
    )
