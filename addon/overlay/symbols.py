"""The cursor's four shapes as flat symbols: each tells its mode without its colour."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from gpu.types import GPUBatch

from ..touch.cursor import CONTACT, FREE, PAN, ZOOM, Shape
from .colours import LINE, SHADOW, Rgba, faded, opaque
from .pen import at, circle, closed_batch, draw_filled, draw_lines, filled_batch, placed
from .rect import Point

EDGE = 1.0
"""Pixels at a scale of 1, of the white line around a symbol."""


@dataclass(frozen=True)
class Symbol:
    """A shape seen from the side, in a square from -1 to 1."""

    corners: tuple[Point, ...]
    colour: Rgba


def _ellipse(across: float, high: float) -> tuple[Point, ...]:
    return tuple((x * across, y * high) for x, y in circle())


SYMBOLS: dict[Shape, Symbol] = {
    FREE: Symbol(_ellipse(0.8, 0.8), opaque(FREE.colour)),
    CONTACT: Symbol(((0.0, -0.95), (0.85, 0.8), (-0.85, 0.8)), opaque(CONTACT.colour)),
    PAN: Symbol(_ellipse(1.0, 0.45), opaque(PAN.colour)),
    ZOOM: Symbol(_ellipse(0.45, 1.0), opaque(ZOOM.colour)),
}


def draw_symbol(shape: Shape, x: float, y: float, size: float, scale: float, opacity: float = 1.0) -> None:
    """Draw a shape of the cursor around a place, so many pixels from its middle to its sides."""
    filled, edge = _batches(shape)
    with placed(at(x, y, size + EDGE * scale)):
        draw_filled(filled, faded(SHADOW, opacity))
    with placed(at(x, y, size)):
        draw_filled(filled, faded(SYMBOLS[shape].colour, opacity))
        draw_lines(edge, faded(LINE, opacity), EDGE * scale)


@cache
def _batches(shape: Shape) -> tuple[GPUBatch, GPUBatch]:
    corners = SYMBOLS[shape].corners
    return filled_batch(corners), closed_batch(corners)
