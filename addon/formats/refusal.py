"""Errors for fields of a header, short enough for a dialog."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from .format_error import FormatError

Refuse = Callable[[str, object, object, str], FormatError]
"""Makes the error for a field of a header: what was found, what was expected, and a way out."""

MAXIMUM_FOUND = 120
"""Letters of what was found that a message repeats."""


def refusal(path: Path, field: str, found: object, expected: object, way_out: str) -> FormatError:
    """Make the error for one field of a header; what was found may be of any length."""
    return FormatError(path, field, found=shortened(found), expected=expected, way_out=way_out)


def shortened(found: object) -> str:
    """Write out what was found, cut where it is long, in one line."""
    try:
        text = str(found)
    except ValueError:  # Python does not write whole numbers of thousands of digits
        return "a number of thousands of digits"
    text = "".join(letter if letter.isprintable() else " " for letter in text[: MAXIMUM_FOUND + 1])
    return f"{text[:MAXIMUM_FOUND]}..." if len(text) > MAXIMUM_FOUND else text


def first_line(error: Exception) -> str:
    """The first line of an error's text, or its kind where it has none."""
    lines = str(error).strip().splitlines()
    return shortened(lines[0]) if lines else type(error).__name__
