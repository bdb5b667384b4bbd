"""From a GeoTIFF file to a grid in memory, a region of it only."""

from __future__ import annotations

from pathlib import Path

from proxygraph import GeoTiff, Grid, GridLayout, Progress

from ..cache import cache_file
from ..decoding import Decoding


def decode_geotiff(path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None) -> Grid:
    """Decode the strips or tiles that the region needs.

    Options:
        south_up: whether the file's first row is its southernmost.
        fill: the stored value of strips and tiles that the file leaves out.
    """
    return GeoTiff.open(path).decode(
        layout,
        decoding.first_column,
        decoding.first_row,
        south_up=bool(decoding.options["south_up"]),
        fill=float(decoding.options["fill"]),
        progress=progress,
        cache=cache_file(path, layout, decoding),
    )
