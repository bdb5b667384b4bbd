"""Colours of land, sea and slopes, all linear; every list goes from low to high."""

from __future__ import annotations

Colour = tuple[float, float, float]

Colours = tuple[tuple[float, Colour], ...]
"""(share of the range, colour)."""

MARS: Colours = (
    (0.0, (0.050, 0.024, 0.020)),
    (0.25, (0.19, 0.055, 0.026)),
    (0.5, (0.47, 0.155, 0.060)),
    (0.75, (0.72, 0.34, 0.14)),
    (0.92, (0.87, 0.60, 0.35)),
    (1.0, (0.96, 0.86, 0.72)),
)
"""Basalt, rust, dust and pale heights."""

EARTH_SEA: Colours = (
    (0.0, (0.010, 0.030, 0.12)),
    (0.6, (0.025, 0.13, 0.36)),
    (1.0, (0.13, 0.40, 0.60)),
)
"""From the deep to the shore."""

EARTH_LAND: Colours = (
    (0.0, (0.055, 0.19, 0.060)),
    (0.2, (0.16, 0.30, 0.080)),
    (0.4, (0.46, 0.42, 0.15)),
    (0.6, (0.36, 0.20, 0.085)),
    (0.8, (0.28, 0.20, 0.16)),
    (0.92, (0.56, 0.53, 0.51)),
    (1.0, (0.92, 0.94, 0.97)),
)
"""Lowland green, dry grass, soil, rock and snow."""

NEUTRAL: Colours = (
    (0.0, (0.030, 0.031, 0.036)),
    (0.35, (0.14, 0.14, 0.145)),
    (0.7, (0.38, 0.375, 0.36)),
    (1.0, (0.82, 0.81, 0.78)),
)
"""Grey rock, for bodies without a palette of their own."""

SLOPES: Colours = (
    (0.0, (0.55, 0.60, 0.50)),
    (0.15, (0.75, 0.62, 0.16)),
    (0.4, (0.75, 0.22, 0.035)),
    (0.75, (0.36, 0.020, 0.060)),
    (1.0, (0.090, 0.006, 0.045)),
)
"""Level ground pale, cliffs dark red."""

FILLED: Colour = (0.42, 0.10, 0.58)
"""Violet, which no land is: heights that were not measured."""

# For what must be told apart by everyone, whatever colours they see: Okabe and Ito, Color Universal Design
# (2008), there as 8-bit sRGB: 86 180 233, 0 158 115, 213 94 0, 204 121 167, 230 159 0 and 240 228 66.
SKY_BLUE: Colour = (0.093, 0.456, 0.815)
BLUISH_GREEN: Colour = (0.0, 0.342, 0.171)
VERMILLION: Colour = (0.665, 0.112, 0.0)
REDDISH_PURPLE: Colour = (0.604, 0.191, 0.386)
ORANGE: Colour = (0.791, 0.347, 0.0)
YELLOW: Colour = (0.871, 0.776, 0.054)
