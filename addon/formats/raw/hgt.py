"""SRTM heights (``.hgt``): raw samples of a degree square, placed by the file's name.

Format: "SRTM Topography" (NASA/USGS, Quickstart and Documentation of SRTM version 2.1): big-endian signed
16 bits, -32768 void; the name is the latitude and longitude of the lower left sample's centre; outer rows and
columns lie on whole degrees and are shared with the neighbours.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from ..body.datums import WGS84
from ..elevation_grid import ElevationGrid
from ..file_bytes import file_length
from ..format_error import FormatError
from ..georeference import Georeference
from ..projections import Geographic
from ..refusal import refusal
from .stored_samples import StoredSamples

NAME = re.compile(r"(?<![A-Za-z0-9])([NS])(\d{1,2})_?([EW])(\d{1,3})(?!\d)", re.IGNORECASE)

SIZES: dict[int, tuple[int, int]] = {
    2 * rows * columns: (rows, columns)
    for rows, columns in ((3601, 3601), (1201, 1201), (3601, 1801), (1201, 601), (601, 601))
}
"""Rows and columns by bytes: 1 and 3 arc-seconds, and the coarser meridians of high latitudes."""

VOID = -32768.0

SUFFIX = ".hgt"


@dataclass(frozen=True)
class HgtPosition:
    """The lower left corner of a degree square, degrees north and east."""

    latitude: float
    longitude: float


def position_of(name: str) -> HgtPosition | None:
    """The corner that a file name states: ``N51W001`` is 51 north, 1 west."""
    found = NAME.search(name)
    if found is None:
        return None
    latitude = int(found[2]) * (1 if found[1].upper() == "N" else -1)
    longitude = int(found[4]) * (1 if found[3].upper() == "E" else -1)
    if not (-90 <= latitude <= 89 and -180 <= longitude <= 180):
        return None
    return HgtPosition(float(latitude), float(longitude))


def read_hgt(path: Path, position: HgtPosition | None = None) -> ElevationGrid:
    """Read a degree square.

    Args:
        position: of its lower left corner; ``None`` takes it from the file's name.
    """
    size = _size(path)
    place = position or position_of(path.name)
    notes: tuple[str, ...] = ()
    if place is None:
        place = HgtPosition(0.0, 0.0)
        notes = (
            "Its name does not say where it is: it is put at 0 N 0 E, with the cells of the equator. "
            "Give it its name (such as N51W001.hgt, the lower left corner) or a position.",
        )
    _check(path, place)
    rows, columns = size
    georeference = Georeference(
        body="Earth",
        ellipsoid=WGS84,
        projection=Geographic(),
        first_x=place.longitude,
        first_y=place.latitude + 1.0,
        step_x=1.0 / (columns - 1),
        step_y=1.0 / (rows - 1),
        vertical_reference="EGM96 geoid",
        latitude_kind="planetographic",
        registration="points",
        frame="WGS 84, longitude and latitude",
    )
    samples = StoredSamples(rows, columns, "i16", "big", void=VOID)
    layout, decoding = samples.placed(georeference, partial(refusal, path))
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=layout,
        georeference=georeference,
        title=f"Earth {path.stem}",
        format="SRTM (hgt)",
        decoding=decoding,
        notes=notes,
    )


def _size(path: Path) -> tuple[int, int]:
    found = file_length(path)
    if found not in SIZES:
        known = ", ".join(f"{size:,} ({rows} x {columns})" for size, (rows, columns) in SIZES.items())
        raise FormatError(
            path,
            "length",
            found=f"{found:,} bytes",
            expected=f"one of {known}",
            way_out="The file is cut short or is no SRTM square: download it again.",
        )
    return SIZES[found]


def _check(path: Path, place: HgtPosition) -> None:
    if not (-90.0 <= place.latitude <= 89.0 and -360.0 <= place.longitude <= 360.0):
        raise refusal(
            path,
            "position",
            f"{place.latitude:g} N, {place.longitude:g} E",
            "latitudes of -90 to 89 and longitudes within +-360",
            "Give another position.",
        )
