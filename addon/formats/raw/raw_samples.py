"""Raw samples that cannot be mapped as they lie, because touch knows no such type or order of them.

Numbers of 8 bits, unsigned and long whole numbers, a band among others, rows that run from south to
north, and regions across the seam of a whole planet are copied once into rows that touch can use.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from proxygraph import GridLayout

RawSample = Literal["i8", "u8", "i16", "u16", "i32", "u32", "i64", "u64", "f32", "f64"]
ByteOrder = Literal["big", "little"]
Sample = Literal["i16", "u16", "i32", "f32", "f64"]

RAW_BYTES: dict[RawSample, int] = {
    "i8": 1,
    "u8": 1,
    "i16": 2,
    "u16": 2,
    "i32": 4,
    "u32": 4,
    "i64": 8,
    "u64": 8,
    "f32": 4,
    "f64": 8,
}
"""Of every type that a file may have."""

DECODED: dict[RawSample, Sample] = {
    "i8": "i16",
    "u8": "i16",
    "i16": "i16",
    "u16": "u16",
    "i32": "i32",
    "u32": "f64",
    "i64": "f64",
    "u64": "f64",
    "f32": "f32",
    "f64": "f64",
}
"""The type that each becomes: the smallest that loses nothing (whole numbers beyond 2^53 are rounded)."""


@dataclass(frozen=True)
class RawSamples:
    """Where the samples of one band lie in a file."""

    rows: int
    columns: int
    sample: RawSample
    byte_order: ByteOrder
    """Of one sample; means nothing where it is one byte."""
    offset: int = 0
    """Bytes before the band's first sample in the file (the first of its interleaved bands' own)."""
    pixel_stride: int | None = None
    """Bytes from one column to the next; ``None``: the columns are packed."""
    row_stride: int | None = None
    """Bytes from one row to the next; ``None``: the rows are packed."""
    south_first: bool = False
    """Whether the file's first row is the southernmost; row 0 of what is decoded is the northernmost."""
    wraps: bool = False
    """Whether column ``columns`` is column 0 again, so that a region may run on beyond the last one."""

    @staticmethod
    def of(layout: GridLayout) -> RawSamples:
        """The samples of a layout that could be mapped."""
        return RawSamples(
            layout.rows,
            layout.columns,
            layout.sample,
            layout.byte_order,
            offset=layout.offset,
            row_stride=layout.row_stride,
            wraps=layout.wraps,
        )

    @property
    def bytes_to_column(self) -> int:
        """Bytes from one column to the next."""
        return RAW_BYTES[self.sample] if self.pixel_stride is None else self.pixel_stride

    @property
    def bytes_to_row(self) -> int:
        """Bytes from one row to the next."""
        return self.columns * self.bytes_to_column if self.row_stride is None else self.row_stride

    @property
    def byte_length(self) -> int:
        """Bytes that the file must hold at the least, ``offset`` included."""
        last = (self.rows - 1) * self.bytes_to_row + (self.columns - 1) * self.bytes_to_column
        return self.offset + last + RAW_BYTES[self.sample]

    def decoded(
        self,
        cell_width: float,
        cell_height: float,
        *,
        scale: float = 1.0,
        value_offset: float = 0.0,
        void: float | None = None,
    ) -> GridLayout:
        """The layout of the samples once they are copied: packed, from byte 0.

        Args:
            cell_width, cell_height: metres between neighbouring columns and rows.
            scale, value_offset: elevation in metres = sample * scale + value_offset.
            void: the sample value, as it is in the file, that means "no data".

        Raises:
            GridError: naming what no grid can have.
        """
        return GridLayout(
            self.rows,
            self.columns,
            cell_width=cell_width,
            cell_height=cell_height,
            sample=DECODED[self.sample],
            byte_order=self.byte_order,
            scale=scale,
            value_offset=value_offset,
            void=void,
            wraps=self.wraps,
        )

    def properties(self) -> dict[str, Any]:
        """Write it down; counts as text, since whoever keeps it may stop whole numbers at 2^31."""
        return {
            "rows": str(self.rows),
            "columns": str(self.columns),
            "sample": self.sample,
            "byte_order": self.byte_order,
            "offset": str(self.offset),
            "pixel_stride": str(self.bytes_to_column),
            "row_stride": str(self.bytes_to_row),
            "south_first": self.south_first,
            "wraps": self.wraps,
        }

    @staticmethod
    def kept(kept: Mapping[str, Any]) -> RawSamples:
        """Make it again.

        Raises:
            KeyError, TypeError, ValueError: what was kept was changed.
        """
        return RawSamples(
            int(kept["rows"]),
            int(kept["columns"]),
            kept["sample"],
            kept["byte_order"],
            offset=int(kept["offset"]),
            pixel_stride=int(kept["pixel_stride"]),
            row_stride=int(kept["row_stride"]),
            south_first=bool(kept["south_first"]),
            wraps=bool(kept["wraps"]),
        )
