"""The header of an ENVI raster: ``keyword = value`` lines, braces around lists that may run over many lines.

Format: "ENVI Header Files" (NV5 Geospatial documentation).
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..file_bytes import read_head
from ..format_error import FormatError
from ..refusal import refusal

MAGIC = b"ENVI"

MAXIMUM_BYTES = 1 << 20
"""Headers of many bands list each; those of elevations have some 500 bytes."""

PAIR = re.compile(r"^[ \t]*([A-Za-z][A-Za-z0-9 _]{0,63}?)[ \t]*=[ \t]*(\{[^}]*\}|[^\r\n{]*)", re.MULTILINE)

UNCLOSED = re.compile(r"^[ \t]*([A-Za-z][A-Za-z0-9 _]{0,63}?)[ \t]*=[ \t]*\{[^}]*\Z", re.MULTILINE)
"""A list that a file ends in."""

_REQUIRED: Any = object()


@dataclass(frozen=True)
class EnviHeader:
    """Keywords in lower case, one space between words; lists without their braces."""

    path: Path
    words: Mapping[str, str]

    def text(self, keyword: str, default: str = _REQUIRED) -> str:
        """A value as it is written."""
        found = self.words.get(keyword, default)
        if found is _REQUIRED:
            raise self.wrong(
                keyword, "nothing", "it in the header", "Choose the header of an elevation grid."
            )
        return str(found)

    def number(self, keyword: str, default: float = _REQUIRED) -> float:
        """A finite number; the first of a list."""
        if keyword not in self.words and default is not _REQUIRED:
            return default
        return self.finite(keyword, self.text(keyword).split(",")[0])

    def whole(self, keyword: str, default: int = _REQUIRED) -> int:
        """A whole number, 0 or more."""
        number = self.number(keyword, default=default)
        if not 0 <= number <= 2**53 or number != int(number):
            raise self.wrong(keyword, f"{number:g}", "a whole number, 0 or more", "Mend the header.")
        return int(number)

    def items(self, keyword: str) -> list[str]:
        """The items of a list; none where the header does not have it."""
        found = self.words.get(keyword, "")
        return [item.strip() for item in found.split(",")] if found.strip() else []

    def finite(self, field: str, text: str) -> float:
        """The finite number that a text holds."""
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise self.wrong(field, text, "a number", "Mend the header.")
        return number

    def wrong(self, field: str, found: object, expected: object, way_out: str) -> FormatError:
        """Make the error for one of this header's fields."""
        return refusal(self.path, field, found, expected, way_out)


def read_envi_header(path: Path) -> EnviHeader:
    """Read a header."""
    text = read_head(path, MAXIMUM_BYTES).decode("latin-1")
    # Looked for after the last brace only, since each list that is closed there would be read up to it.
    unclosed = UNCLOSED.search(text, text.rfind("}") + 1)
    if unclosed is not None:
        raise refusal(
            path,
            unclosed[1],
            "a list without its end",
            "a list in braces",
            "The header is cut short: get it again.",
        )
    words: dict[str, str] = {}
    for keyword, value in PAIR.findall(text):
        name = " ".join(keyword.lower().replace("_", " ").split())
        words.setdefault(name, value.strip().strip("{}").strip())
    return EnviHeader(path, words)
