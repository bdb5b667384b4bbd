"""What cylindrical projections have in common: they repeat themselves eastward."""

from __future__ import annotations

import math
from collections.abc import Callable

from ..body.ellipsoid import Ellipsoid
from .conformal import parallel_radius


def share_of_equator(standard_parallel: float, ellipsoid: Ellipsoid) -> float:
    """The radius of a parallel (degrees) in semi-major axes.

    Raises:
        ValueError: it has none.
    """
    if not -90.0 < standard_parallel < 90.0:
        raise ValueError("no such parallel")
    return parallel_radius(math.radians(standard_parallel), ellipsoid)


def turn_of(scale: Callable[[Ellipsoid], float], ellipsoid: Ellipsoid) -> float | None:
    """Metres of a turn, from the metres of a radian; ``None`` where they make no map."""
    try:
        turn = math.tau * abs(scale(ellipsoid))
    except (ArithmeticError, ValueError):
        return None
    return turn if 0.0 < turn < math.inf else None
