"""Which stored value of a TIFF file is no height."""

from __future__ import annotations

import math
from pathlib import Path
from struct import pack, unpack

from proxygraph import GeoTiff, Grid, GridLayout

from ..decoding import Decoding
from ..raw.stored_samples import LARGEST_FLOAT, void_of
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

CUSTOMARY = (-32_768.0, -32_767.0, -9_999.0, -99_999.0, -999_999.0, -LARGEST_FLOAT)
"""What people write where there is no height, and forget to say so."""

FAR_OUT = 0.999 * LARGEST_FLOAT
"""Beyond, values stand for the largest number, written with three digits or more ("-3.4e+38")."""

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
    if not math.isfinite(value):
        return None, ["Samples that are not finite numbers are holes."]
    return (void_of("f32", value) if stored == "f32" else value), []


def void_written_short(
    path: Path, tags: Tags, layout: GridLayout, decoding: Decoding | None, void: float
) -> float:
    """The void value that samples have where the file's text of it has too few digits to tell.

    "-3.402823e+38" and "-3.4e+38" stand for the largest number of 32 bits with its sign, but some programs
    store what they write: the lowest sample decides. ``void`` comes back where there is nothing to decide.

    Raises:
        DecodeError, GridError, OSError: samples cannot be read.
    """
    if tags.tiff.stored != "f32" or void > -FAR_OUT:
        return void
    stated = float(tags.text(GDAL_NODATA).strip().strip("\0"))
    if math.isclose(stated, _single(stated), rel_tol=1e-9):
        return void
    lowest = _lowest(path, layout, decoding, _bands(tags.tiff, layout), None)
    return void if lowest is None or lowest > -FAR_OUT else lowest


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


def _single(value: float) -> float:
    """The number of 32 bits that is nearest to this one."""
    bounded = max(-LARGEST_FLOAT, min(LARGEST_FLOAT, value))
    rounded: float = unpack("<f", pack("<f", bounded))[0]
    return rounded


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
