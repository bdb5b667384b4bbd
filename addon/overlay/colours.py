"""Colours of the overlay: red, green and blue as a screen takes them (sRGB), and opacity."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ..terrain.palettes import ORANGE, YELLOW, Colour

Rgba = tuple[float, float, float, float]

TEXT: Rgba = (1.0, 1.0, 1.0, 0.95)
QUIET: Rgba = (1.0, 1.0, 1.0, 0.7)
"""Of names, and of what is not so now."""

LINE: Rgba = (1.0, 1.0, 1.0, 0.9)
SHADOW: Rgba = (0.0, 0.0, 0.0, 0.55)
"""Around lines."""

TEXT_SHADOW: Rgba = (0.0, 0.0, 0.0, 0.8)
PLATE: Rgba = (0.0, 0.0, 0.0, 0.7)
"""Under text, so that it can be read on snow: in a 3D view, which mixes linear light, it is weaker."""

BELOW_GROUND = 0.5
"""Share of its opacity that a thing has where the ground hides it."""


def on_screen(shares: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Linear shares of red, green and blue as a screen takes them (IEC 61966-2-1)."""
    shares = np.clip(shares, 0.0, 1.0)
    return np.where(shares <= 0.0031308, 12.92 * shares, 1.055 * shares ** (1.0 / 2.4) - 0.055)


def opaque(colour: Colour) -> Rgba:
    """A linear colour as the overlay has it."""
    red, green, blue = (float(share) for share in on_screen(np.array(colour)))
    return red, green, blue, 1.0


def faded(colour: Rgba, opacity: float) -> Rgba:
    """A colour with a share of its opacity."""
    return (*colour[:3], colour[3] * opacity)


WARNING = opaque(ORANGE)
FORCE = opaque(YELLOW)
