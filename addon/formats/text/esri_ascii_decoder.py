"""From an Esri ASCII grid to a grid in memory."""

from __future__ import annotations

from pathlib import Path

from proxygraph import EsriAscii, Grid, GridLayout, Progress

from ..cache import cache_file
from ..decoding import Decoding


def decode_esri_ascii(path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None) -> Grid:
    """Decode a region; see ``DECODERS``."""
    return EsriAscii.open(path, heights=False).decode(
        layout,
        decoding.first_column,
        decoding.first_row,
        progress=progress,
        cache=cache_file(path, layout, decoding),
    )
