"""Which stored value of a TIFF file is no height."""

from __future__ import annotations

import math
from pathlib import Path
from struct import pack, unpack

from proxygraph import GeoTiff, Grid, GridLayout

from ..decoding import Decoding
from .geotiff_decoder import decode_geotiff
from .geotiff_tags import GDAL_NODATA, Tags

LIMITS = {
    "u8": (0, 255),
    "i8": (-128, 127),
    "u16": (0, 65_535),
    "i16": (-32_768, 32_767),
    "u32": (0, 4_294_967_295),
    "i32": (-2_147_483_648, 2_147_483_647),
}
"""Of whole numbers in files."""

LARGEST_SINGLE = unpack("<f", b"\xff\xff\x7f\x7f")[0]

CUSTOMARY = (-32_768.0, -32_767.0, -9_999.0, -99_999.0, -999_999.0, -LARGEST_SINGLE)
"""What people write where there is no height, and forget to say so."""

LONELY = 1_000.0
"""Metres without any height above a value that is no height itself: real ground has heights in between."""

MOST_LOOKED_AT = 1 << 24
"""Samples that are looked at to find what the file does not say; beyond, bands of rows all over it."""

MOST_BANDS = 16


def stated_void(tags: Tags) -> tuple[float | None, list[str]]:
    """Read the tag GDAL_NODATA: the stored value, and what to say of it.

    Nothing to say and ``None`` mean that the file does not state one.
    """
    text = tags.text(GDAL_NODATA).strip().strip("\0")
    if not text:
        return None, []
    stored = tags.tiff.stored
    try:
        value = float(text)
    except ValueError:
        return None, [f'The value for missing heights is "{text[:20]}", which is no number: it is not used.']
    if stored in LIMITS:
        least, most = LIMITS[stored]
        if not (least <= value <= most and value == int(value)):
            return None, [f"No sample can have the stated value for missing heights ({text[:20]})."]
    elif stored == "f32":
        value = as_single(value)
    if not math.isfinite(value):
        return None, ["Samples that are not finite numbers are holes."]
    return value, []


def as_single(value: float) -> float:
    """Round to what 32 bits hold, as the samples are."""
    if not math.isfinite(value):
        return value
    bounded = max(-LARGEST_SINGLE, min(LARGEST_SINGLE, value))
    return float(unpack("<f", pack("<f", bounded))[0])


def unstated_void(
    path: Path, tiff: GeoTiff, layout: GridLayout, decoding: Decoding | None
) -> tuple[float | None, list[str]]:
    """Find a customary value for missing heights in a file that does not state one.

    A value is one of ``CUSTOMARY``, it is the lowest of all samples, and no other sample lies within
    ``LONELY`` metres above it. Ground that really goes down to such a height has neighbours near it.

    Raises:
        DecodeError, GridError, OSError: samples cannot be read.
    """
    if tiff.stored.startswith("u") or tiff.stored == "i8":
        return None, []
    bands = _bands(tiff, layout)
    lowest = _lowest(path, layout, decoding, bands, None)
    if lowest is None or lowest not in CUSTOMARY:
        return None, []
    above = _lowest(path, layout, decoding, bands, lowest)
    if above is None or (above - lowest) * abs(layout.scale) < LONELY:
        return None, []
    looked_at = "" if sum(rows for _, rows in bands) == layout.rows else ", as far as was looked at"
    note = (
        f"The file states no value for missing heights; samples of {lowest:g} are taken for holes: the next "
        f"height is {above:g}{looked_at}."
    )
    if above in CUSTOMARY:
        note += f" Samples of {above:g} may be holes too."
    return lowest, [note]


def _bands(tiff: GeoTiff, layout: GridLayout) -> list[tuple[int, int]]:
    """Choose the rows that are looked at: (first, number), all of them if they are not too many."""
    if layout.samples <= MOST_LOOKED_AT:
        return [(0, layout.rows)]
    if layout.columns > MOST_LOOKED_AT // 2:
        return []
    # Whole strips or tiles where they are small enough: part of one costs as much.
    height = max(tiff.chunk[1], 2)
    rows = max(1, MOST_LOOKED_AT // MOST_BANDS // layout.columns // height) * height
    count = min(MOST_BANDS, max(1, MOST_LOOKED_AT // (rows * layout.columns)))
    rows = min(rows, max(2, MOST_LOOKED_AT // layout.columns), layout.rows)
    last = layout.rows - rows
    firsts = {last * band // max(1, count - 1) // height * height for band in range(count)}
    return [(first, rows) for first in sorted(firsts)]


def _lowest(
    path: Path,
    layout: GridLayout,
    decoding: Decoding | None,
    bands: list[tuple[int, int]],
    void: float | None,
) -> float | None:
    """Find the lowest stored value that is not ``void``."""
    found = [_stored(path, layout, decoding, first, rows, void).range() for first, rows in bands]
    return min((band.minimum for band in found if band is not None), default=None)


def _stored(
    path: Path, layout: GridLayout, decoding: Decoding | None, first: int, rows: int, void: float | None
) -> Grid:
    """Some rows as they are stored, without scale and offset."""
    plain = GridLayout(
        rows,
        layout.columns,
        cell_width=1.0,
        cell_height=1.0,
        sample=layout.sample,
        byte_order=layout.byte_order,
        offset=layout.offset + first * layout.row_stride if decoding is None else 0,
        row_stride=layout.row_stride if decoding is None else None,
        void=void,
    )
    if decoding is None:
        return Grid.open(path, plain)
    options = {**decoding.options, "south_up": False}
    return decode_geotiff(path, plain, Decoding("geotiff", 0, first, options), None)
