"""A PDS3 label, detached or at the head of its data file, with errors that name the file and the field.

Format: Planetary Data System Standards Reference, version 3.8 (JPL D-7669), chapters 5 (labels) and 12 (ODL).
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload

import pvl

from ..file_bytes import read_head
from ..format_error import FormatError
from ..refusal import first_line, refusal
from .label_parser import LabelParser

FIRST_KEYWORD = "PDS_VERSION_ID"

MAXIMUM_BYTES = 64 << 10
"""A label has 2 to 6 kilobytes; to follow a mebibyte of text takes half a minute."""

MOST_ASSIGNMENTS = 1000
"""A label has some 100; pvl follows up to 3 in a millisecond, while Blender waits."""

END_OF_LABEL = re.compile(r"^[ \t]*END[ \t]*(?=\r|\n|\Z)", re.MULTILINE)
"""The statement after which the data begin where label and data are one file."""

MAXIMUM_COUNT = 2**53
"""Beyond it doubles do not count every whole number."""

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
        return refusal(self.path, field, found, expected, way_out)

    def _finite(self, field: str, value: Any) -> float:
        """Make a double; there are whole numbers that are too large for one."""
        try:
            if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value):
                return float(value)
        except OverflowError:
            value = "a number of more than 300 digits"
        raise self.wrong(field, value, "a number", "Mend the label.")


def read_label(path: Path) -> Label:
    """Read a label: a file of its own, or the beginning of the data file."""
    text = _label_text(path)
    assignments = text.count("=")
    if assignments > MOST_ASSIGNMENTS:
        raise _no_label(path, f"{assignments:,} equals signs, where {MOST_ASSIGNMENTS:,} are many")
    try:
        keywords = pvl.loads(text, parser=LabelParser())
    except Exception as error:  # pvl raises several kinds for text that it cannot follow
        raise FormatError(
            path,
            "label",
            found=f"text that cannot be followed ({first_line(error)})",
            expected="PDS3 keywords",
            way_out="Download the label again.",
        ) from error
    return Label(path, keywords)


def _label_text(path: Path) -> str:
    """Read the file up to its END when it looks like a label at all."""
    text = read_head(path, MAXIMUM_BYTES + 1).decode("latin-1")
    if FIRST_KEYWORD not in text:
        raise _no_label(path, f"no {FIRST_KEYWORD}")
    end = END_OF_LABEL.search(text)
    if end is not None:
        return text[: end.end()]
    if len(text) > MAXIMUM_BYTES:
        raise _no_label(path, f"more than {MAXIMUM_BYTES:,} bytes")
    return text


def _no_label(path: Path, found: str) -> FormatError:
    return FormatError(
        path,
        "label",
        found=found,
        expected="a PDS3 label",
        way_out="This is not a label: choose the .lbl file that came with the grid.",
    )
