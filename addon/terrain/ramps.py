"""Which colours heights and slopes have."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .material import Ramp
from .mesh import ELEVATION, SLOPE
from .palettes import EARTH_LAND, EARTH_SEA, MARS, NEUTRAL, SLOPES, Colours

COLOURED = (1.0, 99.0)
"""Percentiles of the shown heights at the ends of the colours: a few peaks would take most of them."""

STEEPEST = (1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0)
"""Degrees at which the colours of slopes may end: planets are gentler where their cells are large."""

SHORE = 0.0005
"""Share of the colours below elevation 0 in which sea turns to land: 0 itself is land."""


def heights_ramp(body: str, heights: npt.NDArray[Any]) -> Ramp:
    """Spend the colours on the heights that most of the land has.

    Args:
        heights: metres, NaN where void.
    """
    shown = heights[np.isfinite(heights)]
    if not shown.size:
        return Ramp(ELEVATION, 0.0, 1.0, NEUTRAL)
    low, high = (float(height) for height in np.percentile(shown, COLOURED))
    match body.casefold():
        case "mars":
            return Ramp(ELEVATION, low, high, MARS)
        case "earth":
            # However little there is of sea, or of land beside the sea, it has its colour.
            low = low if low < 0.0 else min(low, float(shown.min()))
            high = high if high > 0.0 else max(high, float(shown.max()))
            return Ramp(ELEVATION, low, high, _earth_colours(low, high))
        case _:
            return Ramp(ELEVATION, low, high, NEUTRAL)


def slopes_ramp(slopes: npt.NDArray[Any]) -> Ramp:
    """End the colours at a round number of degrees that nearly all of the land stays below."""
    steep = float(np.percentile(slopes, COLOURED[1])) if slopes.size else 0.0
    return Ramp(SLOPE, 0.0, next((end for end in STEEPEST if end >= steep), STEEPEST[-1]), SLOPES)


def _earth_colours(low: float, high: float) -> Colours:
    """Blue below elevation 0, and there only."""
    if low >= 0.0:
        return EARTH_LAND
    if high < 0.0 or low == high:
        return EARTH_SEA
    shore = -low / (high - low)
    beach = max(0.0, shore - SHORE)
    sea = tuple((share * beach, colour) for share, colour in EARTH_SEA)
    land = tuple((shore + share * (1.0 - shore), colour) for share, colour in EARTH_LAND)
    return sea + land
