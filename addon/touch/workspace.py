"""The device's workspace, laid over the terrain; without Blender."""

from __future__ import annotations

import math

from proxygraph import GridLayout, Window

from ..terrain.frame import Point, map_centre, map_size

BETWEEN_WALLS = 0.9
"""Share of the workspace's width and depth that the servo's walls leave to the hand."""


def whole_map(layout: GridLayout, workspace: tuple[float, float, float]) -> tuple[float, float, float]:
    """Find where the workspace holds the map in both directions.

    Args:
        workspace: width, depth and height that the hand can reach, metres.

    Returns:
        Terrain metres east and north of the window's middle, and its width.
    """
    across, down = map_size(layout)
    return *map_centre(layout), max(across, down * workspace[0] / workspace[1])


def to_workspace(place: Point, window: Window, width: float) -> Point:
    """Workspace metres of a terrain place.

    Args:
        width: of the device's workspace, metres.
    """
    east, north, up = place
    scale = width / window.width
    eastward, northward = (east - window.east) * scale, (north - window.north) * scale
    cosine, sine = math.cos(window.turn), math.sin(window.turn)
    return (
        eastward * cosine + northward * sine,
        northward * cosine - eastward * sine,
        (up - window.up) * scale * window.exaggeration,
    )


def nearest_turn(east: float, around: float, turn: float | None) -> float:
    """The east of a place that lies nearest, where a map goes around.

    Args:
        east: terrain metres. around: terrain metres east of the window's middle.
        turn: metres once around; ``None`` on a map with edges.
    """
    if turn is None:
        return east
    turns = (around - east) / turn
    # Half a turn away there are two; a rounding error must not choose the other one.
    return east if abs(turns) <= 0.5 + 1e-6 else east + round(turns) * turn


def from_workspace(place: Point, window: Window, width: float) -> Point:
    """Terrain metres of a workspace place: ``to_workspace`` backwards.

    Args:
        width: of the device's workspace, metres.
    """
    x, y, z = place
    scale = window.width / width
    cosine, sine = math.cos(window.turn), math.sin(window.turn)
    return (
        window.east + (x * cosine - y * sine) * scale,
        window.north + (x * sine + y * cosine) * scale,
        window.up + z * scale / window.exaggeration,
    )


def within_reach(place: Point, workspace: tuple[float, float, float]) -> Point:
    """Bring a workspace place into the width and depth that the hand can reach, metres."""
    x, y, z = place
    across, away = workspace[0] / 2.0, workspace[1] / 2.0
    return min(max(x, -across), across), min(max(y, -away), away), z
