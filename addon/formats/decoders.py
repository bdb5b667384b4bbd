"""Every decoder by its name: from a file to a grid in memory."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from proxygraph import Grid, GridLayout, Progress

from .decoding import Decoding
from .geotiff.geotiff_decoder import decode_geotiff
from .raw.raw_decoder import decode_raw
from .text.esri_ascii_decoder import decode_esri_ascii
from .text.usgs_dem_decoder import decode_usgs_dem
from .through_rasterio.rasterio_decoder import decode_through_rasterio

Decoder = Callable[[Path, GridLayout, Decoding, Progress | None], Grid]
"""Takes the data file, the packed layout that is wanted, the decoding, and where to tell progress.

Raises ``DecodeError`` (field, found, expected), ``GridError``, ``OSError`` or ``CancelledError``.
"""

DECODERS: dict[str, Decoder] = {
    "esri_ascii": decode_esri_ascii,
    "geotiff": decode_geotiff,
    "rasterio": decode_through_rasterio,
    "raw": decode_raw,
    "usgs_dem": decode_usgs_dem,
}
