"""What the columns of a take mean: a unit and a frame for each, as files name them."""

from __future__ import annotations

from collections.abc import Mapping

LONGITUDE, LATITUDE, ELEVATION = "longitude", "latitude", "ground_elevation"

DERIVED = (LONGITUDE, LATITUDE, ELEVATION)
"""Worked out from the proxy when a file is written, and again when it is read."""

TERRAIN = "terrain frame: from the grid's first sample"
WORKSPACE = "workspace frame: from the middle of the device's reach, x right, y away, z up"

MEANINGS: Mapping[str, str] = {
    "tick": "count, since the session began",
    "time": "s, the servo's clock",
    **{f"hand_{axis}": f"m, {WORKSPACE}" for axis in "xyz"},
    "goal_east": f"m, {TERRAIN}",
    "goal_north": f"m, {TERRAIN}",
    "goal_up": "m, terrain frame: elevation, never exaggerated",
    "proxy_east": f"m, {TERRAIN}; runs on where the map goes around",
    "proxy_north": f"m, {TERRAIN}",
    "proxy_up": "m, terrain frame: elevation, never exaggerated",
    **{f"force_{axis}": f"N, {WORKSPACE}" for axis in "xyz"},
    **{f"normal_{axis}": f"1, unit vector, {WORKSPACE}" for axis in "xyz"},
    "feature": "0 free, 1 face, 2 edge, 3 vertex: what the proxy lies on",
    "mode": "0 normal, 1 pan, 2 zoom",
    "buttons": "bits, the first button is 1",
    "twist": "rad, of the handle, counter-clockwise; unknown where the device does not tell",
    "vertices": "count, visited in the tick",
    "faces": "count, visited in the tick",
    "collision_tests": "count, in the tick",
    "cells": "cells, that the goal moved in the tick",
    "window_east": f"m, {TERRAIN}: under the workspace's middle",
    "window_north": f"m, {TERRAIN}: under the workspace's middle",
    "window_up": "m, terrain frame: elevation at the workspace's z = 0",
    "window_width": "m, of terrain across the width of the device's reach",
    "window_exaggeration": "1, of heights",
    "window_turn": "rad, from east to the workspace's x, counter-clockwise",
    LONGITUDE: "degrees east, 0 up to 360, of the proxy on the body that about names",
    LATITUDE: "degrees north, of the proxy on the body that about names",
    ELEVATION: "m, of the ground at the proxy, above the vertical reference that about names",
}
"""By name: the unit, then what it is measured in or from."""

MAY_BE_UNKNOWN = ("twist",)
"""Columns that have NaN, and in tables nothing, where nobody can tell; the derived ones do, too."""

UNKNOWN = "not described"


def meanings(names: list[str]) -> dict[str, str]:
    """What columns mean, in their order."""
    return {name: MEANINGS.get(name, UNKNOWN) for name in names}
