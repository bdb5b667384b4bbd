"""GridFloat: single-precision heights (``.flt``) with a header of keywords (``.hdr``), as 3DEP gave them.

Format: Esri, "Float To Raster" (ArcGIS documentation): NCOLS, NROWS, XLLCORNER or XLLCENTER, YLLCORNER or
YLLCENTER, CELLSIZE, NODATA_VALUE, BYTEORDER (MSBFIRST or LSBFIRST).
"""

from __future__ import annotations

import math
import struct
from pathlib import Path

from ..elevation_grid import ElevationGrid
from ..file_bytes import check_length, read_head
from ..frames.map_corner import first_sample
from ..frames.map_frame import frame_beside
from .data_beside import first_beside
from .ehdr import BYTE_ORDERS, VOIDS
from .keyword_header import KeywordHeader, read_keyword_header
from .raw_samples import ByteOrder
from .stored_samples import StoredSamples

DATA_SUFFIXES = (".flt", ".bin", ".dat", ".raw")

PLAUSIBLE_HEIGHT = 1e5
"""Metres; no body that is mapped has relief beyond this, and bytes in the wrong order nearly always have."""

LOOKED_AT = 1 << 16
"""Bytes of samples that are looked at to tell the byte order."""


def read_gridfloat(header_path: Path, data_path: Path | None = None) -> ElevationGrid:
    """Read a header, and find its data unless they are given."""
    header = read_keyword_header(header_path)
    data_path = data_path or first_beside(header_path, DATA_SUFFIXES)
    if data_path is None:
        raise header.wrong(
            "data file",
            f"no {header_path.stem}.flt",
            "the data file beside its header",
            "Put both into one folder.",
        )
    rows, columns = header.whole("NROWS"), header.whole("NCOLS")
    void = header.void(*reversed(VOIDS))
    byte_order, order_notes = _byte_order(header, data_path, void)
    samples = StoredSamples(rows, columns, "f32", byte_order, void=void)
    samples.check_size(header.wrong, "NROWS", "NCOLS")
    step_x = header.positive(header.first_of("CELLSIZE", "XDIM", "DX") or "CELLSIZE")
    step_y = header.positive(header.first_of("CELLSIZE", "YDIM", "DY") or "CELLSIZE")
    first_x, first_y, registration = first_sample(header, rows, step_x, step_y)
    size = (columns, rows)
    frame = frame_beside(data_path, (first_x, first_y), (step_x, step_y), size)
    georeference = frame.georeference(first_x, first_y, step_x, step_y, registration, header.wrong, size)
    layout, decoding = frame.in_metres(samples).placed(georeference, header.wrong)
    check_length(data_path, layout.byte_length, f"NROWS and NCOLS in {header_path.name}", exact=True)
    return ElevationGrid(
        path=header_path,
        data_path=data_path,
        layout=layout,
        georeference=georeference,
        title=f"{georeference.body} {header_path.stem}".strip(),
        format="GridFloat",
        decoding=decoding,
        notes=(*order_notes, *frame.notes),
    )


def _byte_order(
    header: KeywordHeader, data_path: Path, void: float | None
) -> tuple[ByteOrder, tuple[str, ...]]:
    """As the header says; without BYTEORDER as the samples look, LSBFIRST by custom."""
    if "BYTEORDER" in header:
        told = header.text("BYTEORDER")
        if told not in BYTE_ORDERS:
            raise header.wrong("BYTEORDER", told, "LSBFIRST or MSBFIRST", "Mend the header.")
        return BYTE_ORDERS[told], ()
    head = read_head(data_path, LOOKED_AT)
    little, big = (_plausible_share(head, order, void) for order in "<>")
    if big > little:
        return "big", ("BYTEORDER is missing: only MSBFIRST makes heights of these samples.",)
    return "little", ("BYTEORDER is missing: LSBFIRST is assumed.",)


def _plausible_share(head: bytes, order: str, void: float | None) -> float:
    """How many samples may be heights in this byte order, 0 to 1."""
    count = len(head) // 4
    values = struct.unpack(f"{order}{count}f", head[: 4 * count])
    fine = sum(
        1
        for value in values
        if value == 0.0 or value == void or (math.isfinite(value) and 1e-6 < abs(value) < PLAUSIBLE_HEIGHT)
    )
    return fine / count if count else 0.0
