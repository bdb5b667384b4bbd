"""Where the overview map is in a region, and what is where on it; without drawing."""

from __future__ import annotations

import math
from dataclasses import dataclass

from proxygraph import GridLayout, Window

from ..terrain.frame import map_size
from ..touch.workspace import from_workspace
from .rect import Point, Rect, Segment, clipped

LARGEST = 240.0, 200.0
"""Width and height, pixels at a scale of 1."""

MOST_OF_REGION = 0.35
"""Share of a region's width and height that the map takes at most."""

SMALLEST = 48.0
"""Pixels at a scale of 1, of the longer side: below there is nothing to see, and no map."""

SMALLEST_WINDOW = 16.0
"""Pixels at a scale of 1, of the window's longer side: a smaller one is shown so large, around the cursor."""


@dataclass(frozen=True)
class OverviewMap:
    """A map of a whole grid, north up, from its first column to its last."""

    rect: Rect
    across: float
    down: float
    """Terrain metres."""
    wraps: bool

    def at(self, east: float, north: float) -> Point:
        """The pixel of a terrain place, brought back onto a map that wraps."""
        return self._at(east % self.across if self.wraps else east, north)

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Terrain metres east and north of a pixel."""
        rect = self.rect
        return (
            (x - rect.left) / rect.width * self.across,
            (y - rect.top) / rect.height * self.down,
        )

    def outline(self, window: Window, workspace: tuple[float, float, float], scale: float) -> list[Segment]:
        """The edges of a window as far as they are on the map, on both sides of a seam.

        Args:
            workspace: of the device: width, depth and height, metres.
            scale: pixels that a pixel of the design has.
        """
        corners = self._corners(window, workspace, scale)
        edges = list(zip(corners, corners[1:] + corners[:1], strict=True))
        pieces = (
            clipped(((x + shift, y), (end_x + shift, end_y)), self.rect)
            for shift in self._shifts(corners)
            for (x, y), (end_x, end_y) in edges
        )
        return [piece for piece in pieces if piece is not None]

    def _at(self, east: float, north: float) -> Point:
        rect = self.rect
        return (
            rect.left + east / self.across * rect.width,
            rect.top + north / self.down * rect.height,
        )

    def _corners(self, window: Window, workspace: tuple[float, float, float], scale: float) -> list[Point]:
        """Of the workspace on the map, counter-clockwise, never smaller than a person sees."""
        width, depth, _height = workspace
        longest = window.width * max(1.0, depth / width) * self.rect.width / self.across
        grown = max(1.0, SMALLEST_WINDOW * scale / longest)
        half, away = grown * width / 2.0, grown * depth / 2.0
        reached = ((-half, -away), (half, -away), (half, away), (-half, away))
        return [self._at(*from_workspace((x, y, 0.0), window, width)[:2]) for x, y in reached]

    def _shifts(self, corners: list[Point]) -> list[float]:
        """Pixels by which a shape is moved so that all of it is seen that is on the map."""
        if not self.wraps:
            return [0.0]
        least, most = min(x for x, _y in corners), max(x for x, _y in corners)
        turn = self.rect.width
        if most - least >= turn:
            return []  # it reaches around: there is nothing outside
        first, last = math.ceil((self.rect.left - most) / turn), math.floor((self.rect.right - least) / turn)
        return [turns * turn for turns in range(first, last + 1)]


def overview_map(free: Rect, layout: GridLayout, scale: float) -> OverviewMap | None:
    """Put the map into the upper right corner of a rectangle; ``None`` where it would be too small.

    Args:
        free: where it may be. scale: pixels that a pixel of the design has.
    """
    across, down = map_size(layout)
    width = min(LARGEST[0] * scale, MOST_OF_REGION * free.width)
    height = min(LARGEST[1] * scale, MOST_OF_REGION * free.height)
    pixel = max(across / width, down / height) if width > 0.0 and height > 0.0 else math.inf
    width, height = round(across / pixel), round(down / pixel)
    if max(width, height) < SMALLEST * scale or min(width, height) < 2:
        return None
    right, top = round(free.right), round(free.top)
    return OverviewMap(Rect(right - width, top - height, right, top), across, down, layout.wraps)
