"""Rectangles of a region, in pixels from its lower left corner; without Blender."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

Side = Literal["LEFT", "RIGHT", "TOP", "BOTTOM"]

Point = tuple[float, float]

Segment = tuple[Point, Point]


@dataclass(frozen=True)
class Rect:
    """From (left, bottom) to (right, top)."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Pixels, below 0 where the sides have changed places."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Pixels, as ``width``."""
        return self.top - self.bottom

    def contains(self, x: float, y: float) -> bool:
        """Whether a point is in it, or on its edge."""
        return self.left <= x <= self.right and self.bottom <= y <= self.top

    def inset(self, left: float, bottom: float, right: float, top: float) -> Rect:
        """The same without so many pixels at each side."""
        return Rect(self.left + left, self.bottom + bottom, self.right - right, self.top - top)

    def moved(self, x: float, y: float) -> Rect:
        """The same elsewhere."""
        return Rect(self.left + x, self.bottom + y, self.right + x, self.top + y)

    def has_room(self, free: Rect, taken: Iterable[Rect]) -> bool:
        """Whether it lies in what is free of a region, and on nothing else."""
        inside = self.left >= free.left and self.right <= free.right
        inside = inside and self.bottom >= free.bottom and self.top <= free.top
        return inside and not any(self.overlaps(other) for other in taken)

    def overlaps(self, other: Rect) -> bool:
        """Whether they have more than an edge in common."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.bottom < other.top
            and other.bottom < self.top
        )


def uncovered(region: Rect, beside: Iterable[tuple[Side, Rect]]) -> Rect:
    """What sidebar, toolbar and headers leave of a region; where they lie beside it, all of it.

    Args:
        beside: regions of the same area, and at which side of it each lies.
    """
    left, bottom, right, top = region.left, region.bottom, region.right, region.top
    for side, other in beside:
        if not region.overlaps(other):
            continue
        match side:
            case "LEFT":
                left = max(left, other.right)
            case "RIGHT":
                right = min(right, other.left)
            case "TOP":
                top = min(top, other.bottom)
            case "BOTTOM":
                bottom = max(bottom, other.top)
    return Rect(left, bottom, right, top)


def clipped(segment: Segment, rect: Rect) -> Segment | None:
    """The part of a line that is in a rectangle; ``None`` where there is none.

    Y.-D. Liang and B. A. Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics
    3, 1984.
    """
    (x, y), (end_x, end_y) = segment
    along, up = end_x - x, end_y - y
    first, last = 0.0, 1.0
    for step, room in (
        (-along, x - rect.left),
        (along, rect.right - x),
        (-up, y - rect.bottom),
        (up, rect.top - y),
    ):
        if step == 0.0:
            if room < 0.0:
                return None
        elif step < 0.0:
            first = max(first, room / step)
        else:
            last = min(last, room / step)
    if first >= last:
        return None
    return (x + first * along, y + first * up), (x + last * along, y + last * up)
