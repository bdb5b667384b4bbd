"""GTOPO30 tiles (``.DEM``) that lost their ``.HDR``: read where size and name leave no doubt.

Source: USGS GTOPO30 README, sections 3 to 6: 27 tiles of 6000 x 4800 and 6 of 3600 x 7200 samples,
30 arc-seconds, named after their upper left corner; one of 5400 x 5400, a polar stereographic map.
"""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path

from ..elevation_grid import ElevationGrid
from ..file_bytes import file_length
from ..frames.map_frame import GEOGRAPHIC_WGS84
from ..not_a_grid import kind_of_file
from ..refusal import refusal
from .stored_samples import StoredSamples

SUFFIX = ".dem"

TILES: dict[int, tuple[int, int]] = {
    2 * rows * columns: (rows, columns) for rows, columns in ((6000, 4800), (3600, 7200))
}
"""Rows and columns by bytes."""

POLAR_BYTES = 58_320_000
"""Of the tile in polar stereographic projection."""

NAME = re.compile(r"^([EW])(\d{3})([NS])(\d{2})$", re.IGNORECASE)

STEP = 1.0 / 120.0
"""Degrees: 30 arc-seconds."""

SEA = -9999.0


def looks_like_headless_dem(path: Path, head: bytes, length: int) -> bool:
    """Whether a file is named like a tile and holds raw bytes."""
    return path.suffix.lower() == SUFFIX and (length in TILES or kind_of_file(head) is None)


def read_headless_dem(path: Path) -> ElevationGrid:
    """Read a tile by its size and name; refuse in words where these do not tell."""
    length = file_length(path)
    corner = NAME.match(path.stem)
    if length not in TILES or corner is None:
        known = ", ".join(f"{size:,} ({rows} x {columns})" for size, (rows, columns) in TILES.items())
        raise refusal(
            path,
            "header",
            f"no {path.stem}.HDR beside {length:,} bytes",
            f"a header, or a GTOPO30 tile (W020N90.DEM ...) of {known} or {POLAR_BYTES:,} bytes (polar)",
            "Put the .HDR file beside it; where the size differs from these the file was cut or mangled.",
        )
    rows, columns = TILES[length]
    west = int(corner[2]) * (1.0 if corner[1].upper() == "E" else -1.0)
    north = int(corner[4]) * (1.0 if corner[3].upper() == "N" else -1.0)
    refuse = partial(refusal, path)
    georeference = GEOGRAPHIC_WGS84.georeference(
        west + STEP / 2.0, north - STEP / 2.0, STEP, STEP, "cells", refuse, (columns, rows)
    )
    samples = StoredSamples(rows, columns, "i16", "big", void=SEA)
    layout, decoding = samples.placed(georeference, refuse)
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=layout,
        georeference=georeference,
        title=f"Earth {path.stem}",
        format="GTOPO30",
        decoding=decoding,
        notes=("There is no .HDR file: size and name of a GTOPO30 tile are followed, and -9999 is the sea.",),
    )
