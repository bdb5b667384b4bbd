"""Copies of raw samples that cannot be used where they lie."""

from __future__ import annotations

from pathlib import Path

import proxygraph
from proxygraph import Grid, GridLayout, Progress

from ..cache import cache_file
from ..decoding import Decoding
from .raw_samples import RawSamples


def decode_raw(path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None) -> Grid:
    """Copy a region, its own rows and columns only; see ``Decoding.of_raw`` and ``DECODERS``."""
    raw = RawSamples.kept(decoding.options["samples"])
    samples = proxygraph.RawSamples(
        raw.rows,
        raw.columns,
        sample=raw.sample,
        byte_order=raw.byte_order,
        offset=raw.offset,
        pixel_stride=raw.bytes_to_column,
        row_stride=raw.bytes_to_row,
        south_first=raw.south_first,
        wraps=raw.wraps,
    )
    return samples.decode(
        path,
        layout,
        decoding.first_column,
        decoding.first_row,
        progress=progress,
        cache=cache_file(path, layout, decoding),
    )
