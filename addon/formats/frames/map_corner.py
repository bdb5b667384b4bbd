"""The first sample's place from the corner that a keyword header speaks of."""

from __future__ import annotations

from ..georeference import Registration
from ..raw.keyword_header import KeywordHeader


def first_sample(
    header: KeywordHeader, rows: int, step_x: float, step_y: float
) -> tuple[float, float, Registration]:
    """The map's coordinates of the first sample, in the upper left.

    ULXMAP and ULYMAP are the centre of the upper left cell; XLLCORNER and YLLCORNER the outer corner of the
    lower left cell; XLLCENTER and YLLCENTER its centre.
    """
    if "ULXMAP" in header:
        return header.number("ULXMAP"), header.number("ULYMAP"), "cells"
    if "XLLCENTER" in header:
        return header.number("XLLCENTER"), header.number("YLLCENTER") + (rows - 1) * step_y, "cells"
    if "XLLCORNER" in header:
        return (
            header.number("XLLCORNER") + step_x / 2.0,
            header.number("YLLCORNER") + (rows - 0.5) * step_y,
            "cells",
        )
    raise header.wrong(
        "ULXMAP",
        "no ULXMAP, XLLCORNER or XLLCENTER",
        "the place of a corner",
        "Add the corner to the header.",
    )
