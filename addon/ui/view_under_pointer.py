"""Which 3D view a pointer is over: not the panels, bars and buttons that lie on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..touch.pointer_view import Pixel


@dataclass(frozen=True)
class SeenView:
    """A 3D view, and where in it the pointer is."""

    view: Any
    """Its ``RegionView3D``."""
    size: Pixel
    """Width and height."""
    pointer: Pixel
    """From its lower left."""


def view_under_pointer(window: Any, x: float, y: float) -> SeenView | None:
    """Find the view under a place of the window, pixels from its lower left; one of four in a quad view.

    ``None`` over everything else: other editors, and the bars and panels at a 3D view's edges.
    """
    area = next((area for area in window.screen.areas if _holds(area, x, y)), None)
    if area is None or area.type != "VIEW_3D":
        return None
    under = [region for region in area.regions if _holds(region, x, y)]
    if (
        len(under) != 1 or under[0].type != "WINDOW"
    ):  # sidebar and bars lie on the view where they are translucent
        return None
    region = under[0]
    return SeenView(region.data, (region.width, region.height), (x - region.x, y - region.y))


def has_view(window: Any) -> bool:
    """Whether a window shows any 3D view."""
    return any(area.type == "VIEW_3D" for area in window.screen.areas)


def _holds(box: Any, x: float, y: float) -> bool:
    """Whether an area or a region holds a place; one that is hidden is one pixel wide or high."""
    inside = box.x <= x < box.x + box.width and box.y <= y < box.y + box.height
    return bool(inside and box.width > 1 and box.height > 1)
