"""Long messages: Blender's labels do not wrap."""

from __future__ import annotations

import textwrap


def wrapped(message: str, letters: int) -> list[str]:
    """Break a message into lines of at most that many letters; words that are longer stay whole."""
    return textwrap.wrap(message, letters, break_long_words=False, break_on_hyphens=False)
