"""The cursor's four shapes as flat symbols: each tells its mode without its colour."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gpu.types import GPUBatch

from ..touch.cursor import CONTACT, FREE, PAN, ZOOM, Shape
from .colours import LINE, SHADOW, Rgba, faded, opaque
from .pen import Coloured, circle, coloured_batch, draw_coloured
from .rect import Point

RINGS: tuple[tuple[float, Rgba | None], ...] = (
    (-1.0, None),
    (-0.3, LINE),
    (0.3, LINE),
    (0.9, SHADOW),
    (2.0, faded(SHADOW, 0.0)),
)
"""Pixels at a scale of 1 outward from a symbol's edge, and the colours there; ``None`` is its own. In between
they run into each other, which is as smooth as lines are."""


ROUND = 16
"""Corners of an ellipse: a symbol is a dozen pixels wide."""


@dataclass(frozen=True)
class Symbol:
    """A shape seen from the side, in a square from -1 to 1."""

    corners: tuple[Point, ...]
    """Of a convex polygon, counter-clockwise."""
    colour: Rgba

    def grown(self, x: float, y: float, size: float, outward: float) -> list[Point]:
        """The corners around a place, with every side moved outward by so many pixels."""
        corners = zip(
            (self.corners[-1], *self.corners[:-1]),
            self.corners,
            (*self.corners[1:], self.corners[0]),
            strict=True,
        )
        grown = []
        for before, corner, after in corners:
            (a, b), (c, d) = _normal(before, corner), _normal(corner, after)
            miter = outward / (1.0 + a * c + b * d)
            grown.append((x + size * corner[0] + miter * (a + c), y + size * corner[1] + miter * (b + d)))
        return grown


def _normal(start: Point, end: Point) -> Point:
    """Outward from a side, of length 1."""
    along, up = end[0] - start[0], end[1] - start[1]
    length = math.hypot(along, up)
    return up / length, -along / length


def _ellipse(across: float, high: float) -> tuple[Point, ...]:
    return tuple((x * across, y * high) for x, y in circle(corners=ROUND))


SYMBOLS: dict[Shape, Symbol] = {
    FREE: Symbol(_ellipse(0.8, 0.8), opaque(FREE.colour)),
    CONTACT: Symbol(((0.0, -0.95), (0.85, 0.8), (-0.85, 0.8)), opaque(CONTACT.colour)),
    PAN: Symbol(_ellipse(1.0, 0.45), opaque(PAN.colour)),
    ZOOM: Symbol(_ellipse(0.45, 1.0), opaque(ZOOM.colour)),
}


@dataclass(frozen=True)
class PlacedSymbol:
    """A shape of the cursor around a place of the region, pixels."""

    shape: Shape
    x: float
    y: float
    size: float
    """From its middle to its sides."""
    opacity: float = 1.0


@dataclass
class Symbols:
    """Some symbols, drawn at once, and made again only when they change."""

    _kept: tuple[list[PlacedSymbol], float] | None = None
    _batch: GPUBatch | None = None

    def draw(self, symbols: list[PlacedSymbol], scale: float) -> None:
        """Draw them.

        Args:
            scale: pixels that a pixel of the design has.
        """
        if self._batch is None or self._kept != (symbols, scale):
            self._kept = symbols, scale
            self._batch = coloured_batch([_triangles(symbol, scale) for symbol in symbols])
        draw_coloured(self._batch)


def _triangles(symbol: PlacedSymbol, scale: float) -> Coloured:
    """From the middle outward, ring by ring."""
    look = SYMBOLS[symbol.shape]
    sides = len(look.corners)
    places, colours, faces = [(symbol.x, symbol.y)], [faded(look.colour, symbol.opacity)], []
    for number, (outward, colour) in enumerate(RINGS):
        places += look.grown(symbol.x, symbol.y, symbol.size, outward * scale)
        colours += [faded(colour or look.colour, symbol.opacity)] * sides
        for side in range(sides):
            one, other = 1 + number * sides + side, 1 + number * sides + (side + 1) % sides
            if number == 0:
                faces.append((0, one, other))
            else:
                faces += [(one - sides, one, other), (one - sides, other, other - sides)]
    return places, colours, faces
