"""The first band of a raster, brought through rasterio into memory, or into a cache file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from proxygraph import Grid, GridLayout, Progress

from ..cache import cache_file
from ..decoding import Decoding
from ..refusal import first_line
from ..unfinished import unfinished_file
from .rasterio_library import SAMPLES, open_raster, rasterio_module

ROWS_AT_ONCE = 256


def decode_through_rasterio(
    path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None
) -> Grid:
    """Read the first band, or a region of it, some rows at a time."""
    rasterio = rasterio_module()
    if rasterio is None:
        raise OSError("rasterio, which read this file before, is not installed any more")
    rows = _rows(rasterio, path, layout, decoding, progress)
    place = cache_file(path, layout, decoding)
    if place is None:
        samples = bytearray()
        for block in rows:
            samples += block  # joined, they would be there twice
        return Grid.from_buffer(samples, layout)
    with unfinished_file(place) as file:
        file.writelines(rows)
    return Grid.open(place, layout)


def _rows(
    rasterio: Any, path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None
) -> Iterator[bytes]:
    """The bytes of the region, some rows at a time.

    Raises:
        OSError: in the words of rasterio.
    """
    try:
        with open_raster(rasterio, path) as source:
            _check_region(source, layout, decoding)
            _, asked = SAMPLES[str(source.dtypes[0])]
            for row in range(0, layout.rows, ROWS_AT_ONCE):
                rows = min(ROWS_AT_ONCE, layout.rows - row)
                yield b"".join(_columns(source, asked, decoding, row, rows, layout.columns))
                if progress is not None:
                    progress.step(row + rows, layout.rows)
    except rasterio.errors.RasterioError as error:
        raise OSError(first_line(error)) from error


def _check_region(source: Any, layout: GridLayout, decoding: Decoding) -> None:
    """Refuse what is not on the raster, before there is room for it in memory."""
    fits = (
        0 <= decoding.first_column < source.width >= layout.columns
        and 0 <= decoding.first_row <= source.height - layout.rows
    )
    if not fits:
        raise OSError(
            f"{layout.columns} columns from {decoding.first_column} and {layout.rows} rows from "
            f"{decoding.first_row} are not on its {source.width} x {source.height} samples"
        )


def _columns(source: Any, asked: str, decoding: Decoding, row: int, rows: int, columns: int) -> list[bytes]:
    """Some rows of the region, little-endian; columns across the seam come from the first ones."""
    first, first_row = decoding.first_column, decoding.first_row + row
    until = min(first + columns, source.width)
    parts = [(first, until - first)]
    if until - first < columns:
        parts.append((0, columns - (until - first)))
    blocks = [
        source.read(1, window=((first_row, first_row + rows), (start, start + count)), out_dtype=asked)
        for start, count in parts
    ]
    little = [block.astype(block.dtype.newbyteorder("<"), copy=False) for block in blocks]
    return [block[line].tobytes() for line in range(rows) for block in little]
