"""The cursor's four shapes, what each means, and the key that leads to it."""

from __future__ import annotations

from collections.abc import Sequence

from ..touch.cursor import CONTACT, FREE, PAN, ZOOM, Shape
from ..touch.shown import Shown
from .colours import PLATE, QUIET, TEXT
from .design import LINE_HEIGHT, MARGIN, PADDING, RISE, SYMBOL, TEXT_SIZE
from .pen import draw_plate
from .rect import Rect
from .symbols import PlacedSymbol, Symbols
from .view import View
from .writing import Words, Writing

UNLIT = 0.6
"""Opacity of the shapes that the cursor does not have now."""


def legend_lines(key: str, *, has_modes: bool) -> list[tuple[Shape, str]]:
    """Each shape and what it means.

    Args:
        key: that grabs. has_modes: whether anything can be grabbed.
    """
    lines = [(FREE, "In the air"), (CONTACT, "On the ground")]
    if has_modes:
        lines += [(PAN, f"Pan: {key} on the ground"), (ZOOM, f"Zoom: {key} in the air")]
    return lines


def draw_legend(
    lines: list[tuple[Shape, str]],
    shown: Shown,
    view: View,
    symbols: Symbols,
    writing: Writing,
    taken: Sequence[Rect],
) -> None:
    """Draw it in the lower right corner, where there is room.

    Args:
        taken: where something is drawn already.
    """
    scale = view.scale
    line, margin, padding = LINE_HEIGHT * scale, MARGIN * scale, PADDING * scale
    size = TEXT_SIZE * scale
    letters = writing.use(size, "".join(meaning for _shape, meaning in lines))
    beside = 4.0 * SYMBOL * scale
    width = beside + max(letters.width(meaning) for _shape, meaning in lines) + 2.0 * padding
    right, bottom = view.free.right - margin, view.free.bottom + margin
    plate = Rect(right - width, bottom, right, bottom + len(lines) * line + 2.0 * padding)
    if not plate.has_room(view.free, taken):
        return
    draw_plate(plate, PLATE)
    y = plate.top - padding - line + RISE * scale
    words, shapes = [], []
    for shape, meaning in lines:
        lit = shape is shown.shape
        x = plate.left + padding
        opacity = 1.0 if lit else UNLIT
        shapes.append(
            PlacedSymbol(shape, x + SYMBOL * scale, y + RISE * scale, SYMBOL * scale, opacity=opacity)
        )
        words.append(Words(meaning, x + beside, y, TEXT if lit else QUIET))
        y -= line
    symbols.draw(shapes, scale)
    writing.draw("legend", words, size)
