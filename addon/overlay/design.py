"""Sizes that all parts share: pixels at a scale of 1."""

from __future__ import annotations

MARGIN = 16.0
"""Between what is drawn and the region's sides."""

PADDING = 10.0
"""Between what is written and the edge of the plate under it."""

TEXT_SIZE = 11.0
"""Blender's own size of text."""

LINE_HEIGHT = 17.0
"""From one line of text to the next."""

SYMBOL = 6.0
"""From the middle of a symbol to its sides."""

RISE = 4.0
"""From a base line to the middle of what is written."""
