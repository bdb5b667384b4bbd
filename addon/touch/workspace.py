"""The device's workspace, laid over the terrain; without Blender."""

from __future__ import annotations

import math

from proxygraph import GridLayout, Window

from ..terrain.frame import Point, map_centre, map_size


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
