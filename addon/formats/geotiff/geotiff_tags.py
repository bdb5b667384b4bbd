"""The georeferencing tags of a TIFF file, with errors that name the file and the field."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from proxygraph import GeoTiff

from ..format_error import FormatError

MODEL_PIXEL_SCALE = 33550
MODEL_TIEPOINT = 33922
MODEL_TRANSFORMATION = 34264
GEO_KEY_DIRECTORY = 34735
GEO_DOUBLE_PARAMS = 34736
GEO_ASCII_PARAMS = 34737
GDAL_METADATA = 42112
GDAL_NODATA = 42113

NAMES = {
    MODEL_PIXEL_SCALE: "ModelPixelScale",
    MODEL_TIEPOINT: "ModelTiepoint",
    MODEL_TRANSFORMATION: "ModelTransformation",
}
"""What the standard calls them."""

MAXIMUM_FOUND = 120
"""Letters of what was found that a message repeats."""


@dataclass(frozen=True)
class Tags:
    """Tags by their numbers."""

    path: Path
    tiff: GeoTiff

    def numbers(self, tag: int) -> list[float]:
        """Give the numbers of a tag, or none where the file does not have it.

        Raises:
            DecodeError: the tag cannot be read as numbers.
        """
        return self.tiff.numbers(tag) or []

    def finite_numbers(self, tag: int) -> list[float]:
        """Give the numbers of a tag that must all be finite."""
        numbers = self.numbers(tag)
        for number in numbers:
            if not math.isfinite(number):
                raise self.wrong(NAMES.get(tag, f"tag {tag}"), number, "finite numbers")
        return numbers

    def text(self, tag: int) -> str:
        """Give the text of a tag, empty where the file does not have it.

        Raises:
            DecodeError: the tag cannot be read as text.
        """
        return self.tiff.text(tag) or ""

    def wrong(
        self,
        field: str,
        found: object,
        expected: object,
        way_out: str = "Mend the georeference: gdal_edit.py -a_srs ... -a_ullr ... writes a new one.",
    ) -> FormatError:
        """Make the error for one of this file's fields."""
        text = str(found)
        if len(text) > MAXIMUM_FOUND:
            text = f"{text[:MAXIMUM_FOUND]}..."
        return FormatError(self.path, field, found=text, expected=expected, way_out=way_out)
