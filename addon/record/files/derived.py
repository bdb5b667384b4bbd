"""Where on its body a take was, and how high the ground is there."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from ...formats import Georeference
from ...formats.projections import Geographic
from ..take_data import Numbers, TakeData
from .columns import ELEVATION, LATITUDE, LONGITUDE

Elevations = Callable[[Numbers, Numbers], Numbers]
"""Metres of the ground at terrain metres on the map, east and north; NaN where there is none."""


def derived_columns(data: TakeData, elevations: Elevations | None = None) -> dict[str, Numbers]:
    """Work out longitude, latitude and ground elevation of the proxy; NaN where nobody can tell.

    Args:
        elevations: of the terrain that was touched; ``None`` leaves the ground out.
    """
    longitude, latitude = longitudes_latitudes(data)
    columns = {LONGITUDE: longitude, LATITUDE: latitude}
    if elevations is not None:
        east, north, _up = data.places.T
        turn = data.about.turn
        columns[ELEVATION] = elevations(east if turn is None else east % turn, north)
    return columns


def longitudes_latitudes(data: TakeData) -> tuple[Numbers, Numbers]:
    """Degrees east, 0 up to 360, and north of the proxy at each tick; NaN where nobody can tell."""
    about = data.about
    east, north, _up = data.places.T
    columns, rows = east / about.cell_width, -north / about.cell_height
    if isinstance(about.georeference.projection, Geographic):
        return _in_degrees(about.georeference, columns, rows)
    nowhere = (math.nan, math.nan)
    found = (
        about.georeference.longitude_latitude(column, row) or nowhere
        for column, row in zip(columns.tolist(), rows.tolist(), strict=True)
    )
    places = np.fromiter((number for place in found for number in place), float, 2 * len(data))
    return places[0::2], places[1::2]


def _in_degrees(georeference: Georeference, columns: Numbers, rows: Numbers) -> tuple[Numbers, Numbers]:
    """The same for all at once, where the map's own coordinates are what is asked for."""
    longitude = (georeference.first_x + columns * georeference.step_x) % 360.0
    latitude = georeference.first_y - rows * georeference.step_y
    shown = np.abs(latitude) <= 90.0
    return np.where(shown, longitude, np.nan), np.where(shown, latitude, np.nan)
