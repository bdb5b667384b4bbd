"""From a USGS DEM to a grid in memory."""

from __future__ import annotations

from pathlib import Path

from proxygraph import Grid, GridLayout, Progress, UsgsDem

from ..cache import cache_file
from ..decoding import Decoding


def decode_usgs_dem(path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None) -> Grid:
    """Decode a region; see ``DECODERS``."""
    return UsgsDem.open(path, progress).decode(
        layout,
        decoding.first_column,
        decoding.first_row,
        progress=progress,
        cache=cache_file(path, layout, decoding),
    )
