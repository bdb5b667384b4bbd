"""What all panels of the tab share."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .wrapped import wrapped

TAB = "Haptic Terrain"
"""In the sidebar of the 3D view."""

SIDEBAR_LETTERS = 32
"""That a line of the sidebar holds at its usual width."""


def draw_lines(layout: Any, lines: Iterable[tuple[str, str]]) -> None:
    """Show names and values, each on a line."""
    for name, value in lines:
        row = layout.split(factor=0.4)
        row.label(text=name)
        row.label(text=value)


def draw_text(layout: Any, text: str) -> None:
    """Show a long text on several lines."""
    column = layout.column(align=True)
    for line in wrapped(text, SIDEBAR_LETTERS):
        column.label(text=line)


def draw_message(layout: Any, message: str) -> None:
    """Show a long message, which wants to be seen."""
    box = layout.box().column(align=True)
    box.alert = True
    for line in wrapped(message, SIDEBAR_LETTERS):
        box.label(text=line)
