"""Whether the coordinates of a header are a place on any body."""

from __future__ import annotations

import math

from ..georeference import Georeference
from ..refusal import Refuse

FARTHEST = 1e10
"""Metres from a map's origin, well beyond the largest planet's."""


def check_place(georeference: Georeference, rows: int, columns: int, refuse: Refuse) -> None:
    """Refuse coordinates that lie beyond all bodies, or that steps are lost in: all places would be one."""
    west, north = georeference.first_x, georeference.first_y
    step_x, step_y = georeference.step_x, georeference.step_y
    east, south = georeference.x(columns - 1), georeference.y(rows - 1)
    all_finite = all(math.isfinite(number) for number in (west, east, south, north))
    told_apart = all_finite and west + step_x > west and north - step_y < north
    if georeference.projection.in_degrees:
        on_body = (
            max(abs(north), abs(south)) <= 90.0 + step_y
            and max(abs(west), abs(east)) <= 1080.0
            and step_x <= 90.0
        )
    else:
        on_body = max(abs(number) for number in (west, east, south, north)) <= FARTHEST
    if not (told_apart and on_body):
        unit = "degrees" if georeference.projection.in_degrees else "metres"
        raise refuse(
            "place of the grid",
            f"{west:g} to {east:g} and {south:g} to {north:g} {unit}, {step_x:g} and {step_y:g} apart",
            "coordinates on a planet",
            "Mend the header, or the .prj file beside it.",
        )
