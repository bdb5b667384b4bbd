"""Map projections: from longitude and latitude to a map's own coordinates, and back."""

from __future__ import annotations

from .geographic import Geographic
from .projection import Coordinates, Projection
from .unknown import Unknown

__all__ = ["KINDS", "Coordinates", "Geographic", "Projection", "Unknown"]

KINDS: dict[str, type[Projection]] = {kind.name: kind for kind in (Geographic, Unknown)}
"""Every projection by its name, for those who keep one as text and numbers."""
