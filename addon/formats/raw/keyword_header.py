"""Headers of one keyword and its value a line: EHdr (BIL, BIP, BSQ, GTOPO30) and GridFloat.

Format: Esri, "BIL, BIP, and BSQ raster files" (ArcGIS documentation); USGS GTOPO30 README, section 6.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..file_bytes import read_head
from ..format_error import FormatError
from ..refusal import refusal

MAXIMUM_BYTES = 64 << 10
"""Such headers have some 300 bytes."""

MOST_KEYWORD_LETTERS = 32

_REQUIRED: Any = object()


@dataclass(frozen=True)
class KeywordHeader:
    """Words in capitals, each with the first word of its value."""

    path: Path
    words: Mapping[str, str]

    def __contains__(self, keyword: str) -> bool:
        return keyword in self.words

    def text(self, keyword: str, default: str = _REQUIRED) -> str:
        """A value in capitals."""
        found = self.words.get(keyword, default)
        if found is _REQUIRED:
            raise self.wrong(
                keyword, "nothing", "it in the header", "Choose the header of an elevation grid."
            )
        return str(found).upper()

    def number(self, keyword: str, default: float = _REQUIRED) -> float:
        """A finite number."""
        if keyword not in self.words and default is not _REQUIRED:
            return default
        text = self.text(keyword)
        try:
            number = float(text.replace("D", "E"))
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise self.wrong(keyword, text, "a number", "Mend the header.")
        return number

    def void(self, *keywords: str) -> float | None:
        """The value that means "no data": the first of these keywords that has a finite one."""
        for keyword in keywords:
            if keyword in self.words and self.text(keyword) not in {"NAN", "NONE", "NULL", "-NAN"}:
                return self.number(keyword)
        return None

    def whole(self, keyword: str, default: int = _REQUIRED) -> int:
        """A whole number, 0 or more."""
        number = self.number(keyword, default=default)
        if not 0 <= number <= 2**53 or number != int(number):
            raise self.wrong(keyword, f"{number:g}", "a whole number, 0 or more", "Mend the header.")
        return int(number)

    def positive(self, keyword: str) -> float:
        """A number above 0."""
        number = self.number(keyword)
        if number <= 0.0:
            raise self.wrong(keyword, f"{number:g}", "a number above 0", "Mend the header.")
        return number

    def first_of(self, *keywords: str) -> str | None:
        """Which of these the header has."""
        return next((keyword for keyword in keywords if keyword in self.words), None)

    def wrong(self, field: str, found: object, expected: object, way_out: str) -> FormatError:
        """Make the error for one of this header's fields."""
        return refusal(self.path, field, found, expected, way_out)


def read_keyword_header(path: Path) -> KeywordHeader:
    """Read a header; lines that are no keyword with a value are comments."""
    return KeywordHeader(path, keywords_of(read_head(path, MAXIMUM_BYTES)))


def keywords_of(head: bytes) -> dict[str, str]:
    """Keywords of a text, in capitals; the first of each counts."""
    words: dict[str, str] = {}
    for line in head.decode("latin-1").splitlines():
        pair = line.replace("=", " ", 1).split()
        if len(pair) >= 2 and len(pair[0]) <= MOST_KEYWORD_LETTERS and pair[0][0].isalpha():
            words.setdefault(pair[0].upper(), pair[1])
    return words


def looks_like_keyword_header(head: bytes) -> bool:
    """Whether a file begins with such a header and has nothing else: Esri ASCII grids go on with heights."""
    if b"\0" in head or len(head) >= MAXIMUM_BYTES:
        return False
    lines = [line.split() for line in head.decode("latin-1").splitlines() if line.strip()]
    words = keywords_of(head)
    return (
        "NROWS" in words
        and "NCOLS" in words
        and not any(len(line) > 1 and _is_number(line[0]) for line in lines)
    )


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
