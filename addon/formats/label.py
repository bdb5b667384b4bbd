"""A PDS3 label, with errors that name the file and the field."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload

import pvl

from .format_error import FormatError

FIRST_KEYWORD = "PDS_VERSION_ID"

MAXIMUM_BYTES = 1 << 20
"""A detached label has a few kilobytes; more than this is not one, and is not read whole."""

_REQUIRED: Any = object()


@dataclass(frozen=True)
class Label:
    """Keywords of a label, looked up as ``(object, ..., keyword)``."""

    path: Path
    keywords: Mapping[str, Any]

    def value(self, *place: str, default: Any = _REQUIRED) -> Any:
        """Find a keyword or object."""
        found: Any = self.keywords
        for depth, keyword in enumerate(place):
            if not isinstance(found, Mapping) or keyword not in found:
                if default is not _REQUIRED:
                    return default
                missing = " in ".join(reversed(place[: depth + 1]))
                raise self.wrong(
                    missing, "nothing", "it in the label", "Choose the label of an elevation grid."
                )
            found = found[keyword]
        return found

    def text(self, *place: str, default: str = _REQUIRED) -> str:
        """Find a keyword's text; numbers and lists are written out."""
        return str(self.value(*place, default=default))

    @overload
    def number(self, *place: str, default: float = ...) -> float: ...
    @overload
    def number(self, *place: str, default: None) -> float | None: ...
    def number(self, *place: str, default: float | None = _REQUIRED) -> float | None:
        """Find a keyword's finite number, whatever unit is written beside it."""
        value = self.value(*place, default=default)
        if value is None:
            if default is None:
                return None
        else:
            value = getattr(value, "value", value)
        if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value):
            return float(value)
        raise self.wrong(place[-1], repr(value), "a number", "Mend the label.")

    def whole(self, *place: str, default: int = _REQUIRED) -> int:
        """Find a keyword's whole number, 0 or more."""
        number = self.number(*place, default=default)
        if number < 0 or number != int(number):
            raise self.wrong(place[-1], number, "a whole number", "Mend the label.")
        return int(number)

    def wrong(self, field: str, found: object, expected: object, way_out: str) -> FormatError:
        """Make the error for one of this label's fields."""
        return FormatError(self.path, field, found=found, expected=expected, way_out=way_out)


def read_label(path: Path) -> Label:
    """Read a detached label."""
    text = _label_text(path)
    try:
        keywords = pvl.loads(text)
    except Exception as error:  # pvl raises several kinds for text that it cannot follow
        raise FormatError(
            path,
            "label",
            found=f"text that cannot be followed ({_first_line(error)})",
            expected="PDS3 keywords",
            way_out="Download the label again.",
        ) from error
    return Label(path, keywords)


def _label_text(path: Path) -> str:
    """Read the file when it looks like a label at all."""
    try:
        with path.open("rb") as file:
            text = file.read(MAXIMUM_BYTES + 1).decode("latin-1")
    except OSError as error:
        raise FormatError(
            path, "label", found=error.strerror, expected="a readable file", way_out="Check its permissions."
        ) from error
    if FIRST_KEYWORD not in text or len(text) > MAXIMUM_BYTES:
        raise FormatError(
            path,
            "label",
            found=f"no {FIRST_KEYWORD}" if FIRST_KEYWORD not in text else "more than a mebibyte",
            expected="a PDS3 label",
            way_out="This is not a label: choose the .lbl file that came with the grid.",
        )
    return text


def _first_line(error: Exception) -> str:
    return str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
