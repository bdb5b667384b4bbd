"""A profile as a table: a line for each point, numbers with a point, fields with commas between."""

from __future__ import annotations

import csv
from pathlib import Path

from ..georeference import Georeference
from .profile import Profile

HEADER = (
    "distance_m",
    "longitude_deg_east",
    "latitude_deg_north",
    "map_x",
    "map_y",
    "elevation_m",
    "slope_deg",
)
"""Map coordinates are degrees or metres, as the grid has them. What is not known is left empty."""


def write_profile(path: Path, profile: Profile, georeference: Georeference) -> None:
    """Write the table.

    Raises:
        OSError: it cannot be written.
    """
    with path.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        table.writerow(HEADER)
        for point in profile.points:
            place = georeference.longitude_latitude(point.column, point.row)
            longitude, latitude = ("", "") if place is None else (repr(place[0]), repr(place[1]))
            table.writerow(
                (
                    repr(point.distance),
                    longitude,
                    latitude,
                    repr(georeference.x(point.column)),
                    repr(georeference.y(point.row)),
                    "" if point.elevation is None else repr(point.elevation),
                    "" if point.slope is None else repr(point.slope),
                )
            )
