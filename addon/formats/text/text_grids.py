"""How grids in text begin: Esri ASCII, and USGS DEM.

Source: Esri, "ASCII To Raster" (ArcGIS documentation); "Standards for Digital Elevation Models" (USGS
National Mapping Program, 1998), part 2, record A.
"""

from __future__ import annotations

from ..raw.keyword_header import keywords_of

WHOLE_FIELDS = ((156, 162), (528, 534), (534, 540))
"""Bytes of the A record that hold whole numbers: system, units of ground, units of height."""

WHOLE_OR_BLANK_FIELDS = ((144, 150), (150, 156), (162, 168))
"""The same of level, pattern and zone, which some files leave blank."""

A_RECORD_BYTES = 864


def looks_like_esri_ascii(head: bytes) -> bool:
    """Whether a file begins with NCOLS and NROWS in text and goes on with numbers."""
    if b"\0" in head[:1024]:
        return False
    first = head[:1024].split(None, 1)
    return (
        bool(first)
        and first[0].upper() in {b"NCOLS", b"NROWS"}
        and {"NCOLS", "NROWS"} <= keywords_of(head[:1024]).keys()
    )


def looks_like_usgs_dem(head: bytes) -> bool:
    """Whether a file begins with an A record: numbers where that has them, and letters everywhere."""
    record = head[:A_RECORD_BYTES]
    if len(record) < 540 or any((byte < 32 and byte not in b"\t\r\n") or byte > 126 for byte in record[144:]):
        return False
    told = (record[start:end].strip() for start, end in WHOLE_OR_BLANK_FIELDS)
    return all(_is_whole(record[start:end]) for start, end in WHOLE_FIELDS) and all(
        not field or _is_whole(field) for field in told
    )


def _is_whole(field: bytes) -> bool:
    return field.strip().lstrip(b"+-").isdigit()
