"""Map projections: from longitude and latitude to a map's own coordinates, and back."""

from __future__ import annotations

from .geographic import Geographic
from .polar_stereographic import PolarStereographic
from .projection import Coordinates, Projection
from .transverse_mercator import TransverseMercator
from .unknown import Unknown

__all__ = [
    "KINDS",
    "Coordinates",
    "Geographic",
    "PolarStereographic",
    "Projection",
    "TransverseMercator",
    "Unknown",
]

KINDS: dict[str, type[Projection]] = {
    kind.name: kind for kind in (Geographic, Unknown, TransverseMercator, PolarStereographic)
}
"""Every projection by its name, for those who keep one as text and numbers."""
