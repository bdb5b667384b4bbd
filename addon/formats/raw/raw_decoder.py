"""Copies of raw samples that cannot be used where they lie."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import proxygraph
from proxygraph import Grid, GridLayout, Progress

from ..cache import cache_file
from ..decoding import Decoding
from .raw_samples import RawSamples


def decode_raw(path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None) -> Grid:
    """Copy a region, its own rows and columns only; see ``Decoding.of_raw`` and ``DECODERS``."""
    return raw_samples(decoding.options).decode(
        path,
        layout,
        decoding.first_column,
        decoding.first_row,
        progress=progress,
        cache=cache_file(path, layout, decoding),
    )


def raw_samples(options: Mapping[str, Any]) -> proxygraph.RawSamples:
    """Where the samples lie, from a decoding's options.

    Raises:
        KeyError, TypeError, ValueError, OverflowError: they were changed.
    """
    raw = RawSamples.kept(options["samples"])
    return proxygraph.RawSamples(
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
