"""Samples as raw bytes in a file: how many, of which type, where; mapped in place where that is possible."""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass

from proxygraph import GridError, GridLayout

from ..decoding import Decoding
from ..georeference import Georeference
from ..refusal import Refuse
from .raw_samples import RAW_BYTES, ByteOrder, RawSample, RawSamples, Sample

MAPPED: dict[RawSample, Sample] = {"i16": "i16", "u16": "u16", "i32": "i32", "f32": "f32", "f64": "f64"}
"""Types that are touched where they lie."""

LARGEST_FLOAT = 3.4028234663852886e38
"""The largest finite single-precision number: what many programs write where they have no height."""

ISIS_VOIDS = 6 * 2.0**104
"""Below the largest number ISIS (USGS) has special pixels: within 6 of the steps that floats have there."""

MOST_LINES = 2**31 - 1
"""Rows or columns that a grid may have."""


@dataclass(frozen=True)
class StoredSamples:
    """Rows of samples, one height each."""

    rows: int
    columns: int
    stored: RawSample
    byte_order: ByteOrder
    offset: int = 0
    """Bytes before the first sample."""
    row_stride: int | None = None
    """Bytes from one row to the next; ``None`` where rows are packed."""
    sample_stride: int | None = None
    """Bytes from one sample to the next; ``None`` where nothing lies between them."""
    scale: float = 1.0
    value_offset: float = 0.0
    """Metres = sample x ``scale`` + ``value_offset``."""
    void: float | None = None

    @property
    def sample_bytes(self) -> int:
        """Bytes of one sample."""
        return RAW_BYTES[self.stored]

    @property
    def byte_length(self) -> int:
        """Bytes that the file must have at the least, ``offset`` included."""
        return self._raw(wraps=False).byte_length

    def check_size(self, refuse: Refuse, rows_field: str, columns_field: str) -> None:
        """Refuse what makes no surface."""
        for field, count in ((rows_field, self.rows), (columns_field, self.columns)):
            if count < 2:
                raise refuse(field, count, "at least 2", "A single line of samples has no surface to touch.")
            if count > MOST_LINES:
                raise refuse(field, f"{count:,}", f"at most {MOST_LINES:,}", "Mend the header.")

    def placed(self, georeference: Georeference, refuse: Refuse) -> tuple[GridLayout, Decoding | None]:
        """Say how the samples are touched: in place (no decoding), or how they are decoded first."""
        width, height = georeference.cell_size(self.rows, self.columns)
        wraps = georeference.spans_the_globe(self.columns)
        raw = self._raw(wraps)
        if raw.bytes_to_row < self.columns * raw.bytes_to_column:
            raise refuse(
                "bytes of a row",
                f"{raw.bytes_to_row:,}",
                f"at least {self.columns * raw.bytes_to_column:,} for {self.columns:,} columns",
                "Mend the header.",
            )
        void = void_of(self.stored, self.void)
        try:
            if self.stored not in MAPPED or raw.bytes_to_column != self.sample_bytes:
                layout = raw.decoded(
                    width, height, scale=self.scale, value_offset=self.value_offset, void=void
                )
                return layout, Decoding.of_raw(raw)
            return (
                GridLayout(
                    self.rows,
                    self.columns,
                    cell_width=width,
                    cell_height=height,
                    sample=MAPPED[self.stored],
                    byte_order=self.byte_order,
                    offset=self.offset,
                    row_stride=raw.bytes_to_row,
                    scale=self.scale,
                    value_offset=self.value_offset,
                    void=void,
                    wraps=wraps,
                ),
                None,
            )
        except (GridError, OverflowError) as error:  # the second for what no 64 bits hold
            raise refuse("grid", error, "a grid that can be touched", "Mend the header.") from error

    def _raw(self, wraps: bool) -> RawSamples:
        return RawSamples(
            self.rows,
            self.columns,
            self.stored,
            self.byte_order,
            offset=self.offset,
            pixel_stride=self.sample_stride,
            row_stride=self.row_stride,
            wraps=wraps,
        )


def void_of(stored: RawSample, void: float | None) -> float | None:
    """The void value as the samples hold it: rounded to single precision where they are."""
    if void is None or not math.isfinite(void):
        return None  # NaN and infinite samples are void by themselves
    if stored != "f32":
        return void
    # Written with few digits, the largest number is rounded to another; next to it ISIS has its own voids.
    if 0.9999 * LARGEST_FLOAT <= abs(void) < LARGEST_FLOAT - ISIS_VOIDS or abs(void) > LARGEST_FLOAT:
        return math.copysign(LARGEST_FLOAT, void)
    rounded: float = struct.unpack("f", struct.pack("f", void))[0]
    return rounded
