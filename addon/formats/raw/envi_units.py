"""The ``units`` of an ENVI header's map info: of its coordinates and cells.

Source: "ENVI Header Files" (NV5 Geospatial documentation), map info.
"""

from __future__ import annotations

import math
from dataclasses import replace

from ..frames.map_frame import MapFrame
from .envi_header import EnviHeader

DEGREES = {"degrees": 1.0, "minutes": 1.0 / 60.0, "seconds": 1.0 / 3600.0, "radians": math.degrees(1.0)}

METRES = {
    "meters": 1.0,
    "km": 1000.0,
    "feet": 0.3048,
    "ussurveyfeet": 1200.0 / 3937.0,
    "yards": 0.9144,
    "miles": 1609.344,
    "nauticalmiles": 1852.0,
}

NOT_STATED = {"", "unknown"}

SAME = 1e-4
"""Share by which kinds of feet differ at the most: ``Feet`` is written for all of them."""


def in_stated_units(header: EnviHeader, frame: MapFrame, units: str) -> MapFrame:
    """The frame with the units that map info states, where it states any.

    Args:
        units: lower case, without spaces.
    """
    if units in NOT_STATED:
        return frame
    if units not in {**DEGREES, **METRES}:
        raise header.wrong(
            "map info: units",
            units,
            f"one of {', '.join((*DEGREES, *METRES))}",
            "Mend the header.",
        )
    in_degrees = frame.projection.in_degrees
    factor = (DEGREES if in_degrees else METRES).get(units)
    if factor is None:
        raise header.wrong(
            "map info: units",
            units,
            "Degrees or a part of them: the map is of longitudes and latitudes"
            if in_degrees
            else "Meters or another length: the map is not of longitudes and latitudes",
            "Mend the header.",
        )
    if math.isclose(factor, frame.unit, rel_tol=SAME):
        return frame  # the coordinate system string is more exact
    return replace(frame, unit=factor)
