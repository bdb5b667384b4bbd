"""Windows, compared and changed: pan and zoom move the window, never the terrain."""

from __future__ import annotations

from proxygraph import Window


def is_same(one: Window, other: Window) -> bool:
    """Whether two windows lie in the same place, equally wide and turned alike."""
    return lies(one) == lies(other) and one.exaggeration == other.exaggeration


def stretched(window: Window, exaggeration: float) -> Window:
    """The same window with other heights."""
    return Window(
        window.east,
        window.north,
        window.up,
        width=window.width,
        exaggeration=exaggeration,
        turn=window.turn,
    )


def lies(window: Window) -> tuple[float, float, float, float, float]:
    """Where a window lies, how wide it is and how it is turned."""
    return window.east, window.north, window.up, window.width, window.turn
