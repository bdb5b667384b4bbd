"""How long a scale bar is, and what it says; without drawing."""

from __future__ import annotations

import math
from dataclasses import dataclass

from mathutils import Matrix, Vector

LONGEST = 160.0
"""Pixels at a scale of 1."""

SHORTEST_METRES, LONGEST_METRES = 1e-4, 1e9
"""Beyond, a view shows nothing that a length could be read from."""


@dataclass(frozen=True)
class ScaleBar:
    """A round length of terrain."""

    metres: float
    pixels: float

    def words(self, metres_of_hand: float) -> str:
        """What the bar stands for.

        Args:
            metres_of_hand: of the hand's way for a metre of terrain.
        """
        return f"{length_words(self.metres)} = {hand_words(self.metres * metres_of_hand)} of hand"


def scale_bar(metres_per_pixel: float, longest: float) -> ScaleBar | None:
    """The longest bar of 1, 2 or 5 times a power of ten metres; ``None`` where there is none to draw.

    Args:
        longest: pixels.
    """
    most = metres_per_pixel * longest
    if not SHORTEST_METRES <= most <= LONGEST_METRES:
        return None
    decade = 10.0 ** math.floor(math.log10(most))
    # A power of ten that is a rounding error too large still counts.
    step = max(step for step in (0.5, 1.0, 2.0, 5.0) if step * decade <= most * (1.0 + 1e-9))
    return ScaleBar(step * decade, step * decade / metres_per_pixel)


def units_per_pixel(perspective: Matrix, to_right: Vector, place: Vector, width: float) -> float | None:
    """Blender units that a pixel shows at a place, across the view; ``None`` behind the viewer.

    Args:
        perspective: from the scene to clip space. to_right: the view's own right, of length 1.
        width: of the region, pixels.
    """
    away = perspective[3].xyz.dot(place) + perspective[3].w
    across = perspective[0].xyz.dot(to_right)
    if away <= 0.0 or across <= 0.0:
        return None
    return float(2.0 * away / (across * width))


def length_words(metres: float) -> str:
    """A length of terrain in the unit that suits it."""
    if metres >= 1000.0:
        return f"{metres / 1000.0:,.10g} km"
    if metres >= 1.0:
        return f"{metres:.10g} m"
    return f"{metres * 100.0:.10g} cm" if metres >= 0.01 else f"{metres * 1000.0:.3g} mm"


def hand_words(metres: float) -> str:
    """A length of the hand's way, to two digits."""
    millimetres = metres * 1000.0
    digits = max(0, 1 - math.floor(math.log10(millimetres)))
    return f"{millimetres:,.{digits}f} mm"
