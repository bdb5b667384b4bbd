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

MAXIMUM_BYTES = 64 << 10
"""A detached label has 2 to 6 kilobytes; to follow a mebibyte of text takes half a minute."""

MAXIMUM_COUNT = 2**53
"""Beyond it doubles do not count every whole number."""

MAXIMUM_FOUND = 120
"""Letters of what was found that a message repeats."""

Units = Mapping[str, float]
"""What a number is multiplied by for each unit that may be written beside it."""

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
    def number(self, *place: str, units: Units | None = ..., default: float = ...) -> float: ...
    @overload
    def number(self, *place: str, units: Units | None = ..., default: None) -> float | None: ...
    def number(
        self, *place: str, units: Units | None = None, default: float | None = _REQUIRED
    ) -> float | None:
        """Find a keyword's finite number.

        Args:
            units: that may be written beside it, in capitals, the one that is meant where none is written
                first; ``None`` for counts and raw values, which mean the same with any unit.
        """
        value = self.value(*place, default=default)
        if value is None and default is None:
            return None
        number = self._finite(place[-1], getattr(value, "value", value))
        if units is None:
            return number
        unit = str(getattr(value, "units", next(iter(units)))).upper().replace(" ", "")
        if unit not in units:
            raise self.wrong(
                place[-1], f"the unit <{unit}>", f"<{'>, <'.join(units)}> or none", "Mend the label."
            )
        return number * units[unit]

    def whole(self, *place: str, default: int = _REQUIRED) -> int:
        """Find a keyword's whole number, 0 or more."""
        number = self.number(*place, default=default)
        if not 0 <= number <= MAXIMUM_COUNT or number != int(number):
            raise self.wrong(place[-1], f"{number:g}", "a whole number", "Mend the label.")
        return int(number)

    def wrong(self, field: str, found: object, expected: object, way_out: str) -> FormatError:
        """Make the error for one of this label's fields."""
        try:
            text = str(found)
        except ValueError:  # Python does not write whole numbers of thousands of digits
            text = "a number of thousands of digits"
        if len(text) > MAXIMUM_FOUND:
            text = f"{text[:MAXIMUM_FOUND]}..."
        return FormatError(self.path, field, found=text, expected=expected, way_out=way_out)

    def _finite(self, field: str, value: Any) -> float:
        """Make a double; there are whole numbers that are too large for one."""
        try:
            if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value):
                return float(value)
        except OverflowError:
            value = "a number of more than 300 digits"
        raise self.wrong(field, value, "a number", "Mend the label.")


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
            found=f"no {FIRST_KEYWORD}"
            if FIRST_KEYWORD not in text
            else f"more than {MAXIMUM_BYTES:,} bytes",
            expected="a PDS3 label",
            way_out="This is not a label: choose the .lbl file that came with the grid.",
        )
    return text


def _first_line(error: Exception) -> str:
    lines = str(error).strip().splitlines()
    return lines[0][:MAXIMUM_FOUND] if lines else type(error).__name__
