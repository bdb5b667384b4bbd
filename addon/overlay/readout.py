"""The readout: what the hand does, where it is, what it feels, and how long a length of terrain is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from gpu.types import GPUBatch

from ..touch.live import Readout, Touch
from ..touch.shown import Shown
from .colours import LINE, PLATE, QUIET, SHADOW, TEXT, WARNING
from .design import LINE_HEIGHT, MARGIN, PADDING, RISE, SYMBOL, TEXT_SIZE
from .pen import at, draw_lines, draw_plate, flat_lines_batch, placed
from .readout_rows import Row, readout_rows, title
from .rect import Rect
from .scale_bar import LONGEST, ScaleBar, scale_bar, units_per_pixel
from .symbols import PlacedSymbol, Symbols
from .view import View
from .writing import Words, Writing

NAMES = 70.0
"""Pixels at a scale of 1 that the column of names takes."""

LEAST_WIDTH = 210.0
"""Of the plate, pixels at a scale of 1: it must not twitch with every digit."""

TICK = 5.0
"""Height of the ends of the scale bar, pixels at a scale of 1."""


@dataclass
class ReadoutBlock:
    """The block, and the bar that is made again when its length changes."""

    _symbols: Symbols = field(default_factory=Symbols)
    _pixels: float = 0.0
    _bar: GPUBatch | None = None

    def draw(
        self,
        touch: Touch,
        readout: Readout,
        shown: Shown,
        view: View,
        writing: Writing,
        taken: Sequence[Rect],
    ) -> Rect | None:
        """Draw it from the lower left corner upwards, where there is room.

        Args:
            taken: where something is drawn already.

        Returns:
            The plate under it; ``None`` where there is no room.
        """
        rows, bar = readout_rows(touch, readout), _bar(shown, view)
        plate = _plate(rows, bar, view, writing)
        if not plate.has_room(view.free, taken):
            return None
        draw_plate(plate, PLATE)
        scale = view.scale
        x, y = plate.left + PADDING * scale, plate.top - (PADDING + LINE_HEIGHT - RISE) * scale
        symbol = PlacedSymbol(shown.shape, x + SYMBOL * scale, y + RISE * scale, SYMBOL * scale)
        self._symbols.draw([symbol], scale)
        words = [Words(title(readout), x + 3.0 * SYMBOL * scale, y, TEXT), *_table(rows, x, y, scale)]
        if bar is not None:
            y = plate.bottom + (PADDING + TICK / 2.0) * scale
            self._draw_bar(bar, x, y, scale)
            hand = touch.workspace[0] / readout.window.width
            words.append(Words(bar.words(hand), x, y + 2.0 * RISE * scale, TEXT))
        writing.draw("readout", words, TEXT_SIZE * scale)
        return plate

    def _draw_bar(self, bar: ScaleBar, x: float, y: float, scale: float) -> None:
        if self._bar is None or bar.pixels != self._pixels:
            self._pixels = bar.pixels
            half, end = TICK * scale / 2.0, bar.pixels
            ends = [((0.0, -half), (0.0, half)), ((end, -half), (end, half))]
            self._bar = flat_lines_batch([((0.0, 0.0), (end, 0.0)), *ends])
        with placed(at(x, y)):
            draw_lines(self._bar, SHADOW, 3.5 * scale)
            draw_lines(self._bar, LINE, 1.5 * scale)


def _plate(rows: Sequence[Row], bar: ScaleBar | None, view: View, writing: Writing) -> Rect:
    """As large as the title, the rows and the bar need it."""
    longest = max((row.value for row in rows), key=len)
    width = NAMES * view.scale + writing.use(TEXT_SIZE * view.scale, longest).width(longest)
    lines = 1 + len(rows) + (2 if bar is not None else 0)
    left, bottom = view.free.left + MARGIN * view.scale, view.free.bottom + MARGIN * view.scale
    return Rect(
        left,
        bottom,
        left + max(LEAST_WIDTH * view.scale, width) + 2.0 * PADDING * view.scale,
        bottom + (lines * LINE_HEIGHT + 2.0 * PADDING) * view.scale,
    )


def _table(rows: Sequence[Row], x: float, y: float, scale: float) -> list[Words]:
    """Names and values, below a base line."""
    words = []
    for number, row in enumerate(rows, start=1):
        base = y - number * LINE_HEIGHT * scale
        words.append(Words(row.name, x, base, QUIET))
        words.append(Words(row.value, x + NAMES * scale, base, WARNING if row.is_warning else TEXT))
    return words


def _bar(shown: Shown, view: View) -> ScaleBar | None:
    """The bar of lengths at the cursor, across the view."""
    units = units_per_pixel(view.perspective, view.to_right, shown.place, view.width)
    return None if units is None else scale_bar(units / shown.units_per_metre, LONGEST * view.scale)
