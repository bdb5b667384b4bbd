"""EHdr rasters: a header of keywords (``.hdr``) beside raw bands (``.bil``, ``.bip``, ``.dem`` ...).

GTOPO30, SRTM30 and GLOBE tiles come so. Format: Esri, "BIL, BIP, and BSQ raster files"; USGS GTOPO30
README, sections 5 and 6: ULXMAP and ULYMAP are the centre of the first cell.
"""

from __future__ import annotations

from pathlib import Path

from ..elevation_grid import ElevationGrid
from ..file_bytes import check_length
from ..frames.map_corner import first_sample
from ..frames.map_frame import MapFrame, frame_beside
from ..georeference import Georeference
from .data_beside import first_beside
from .keyword_header import KeywordHeader, read_keyword_header
from .raw_samples import ByteOrder, RawSample
from .stored_samples import StoredSamples

DATA_SUFFIXES = (".dem", ".bil", ".bip", ".bsq", ".raw", ".img", ".dat", ".bin", ".grd", ".flt", "")

BYTE_ORDERS: dict[str, ByteOrder] = {
    "M": "big",
    "MOTOROLA": "big",
    "MSBFIRST": "big",
    "I": "little",
    "INTEL": "little",
    "LSBFIRST": "little",
}

STORED: dict[tuple[str, int], RawSample] = {
    ("SIGNEDINT", 8): "i8",
    ("UNSIGNEDINT", 8): "u8",
    ("SIGNEDINT", 16): "i16",
    ("UNSIGNEDINT", 16): "u16",
    ("SIGNEDINT", 32): "i32",
    ("UNSIGNEDINT", 32): "u32",
    ("FLOAT", 32): "f32",
    ("FLOAT", 64): "f64",
}

VOIDS = ("NODATA", "NODATA_VALUE")


def read_ehdr(header_path: Path, data_path: Path | None = None) -> ElevationGrid:
    """Read a header, and find its data unless they are given."""
    header = read_keyword_header(header_path)
    data_path = data_path or first_beside(header_path, DATA_SUFFIXES)
    if data_path is None:
        raise header.wrong(
            "data file",
            f"none of {', '.join(f'{header_path.stem}{suffix}' for suffix in DATA_SUFFIXES[:5])}",
            "the data file beside its header",
            "Put both into one folder.",
        )
    samples, notes = _samples(header)
    samples.check_size(header.wrong, "NROWS", "NCOLS")
    georeference, frame = _georeference(header, data_path, samples)
    layout, decoding = frame.in_metres(samples).placed(georeference, header.wrong)
    bands = header.whole("NBANDS", 1)
    check_length(
        data_path,
        samples.byte_length,
        f"NROWS and NCOLS in {header_path.name}",
        exact=bands == 1 and header.whole("TOTALROWBYTES", 0) in {0, samples.columns * samples.sample_bytes},
    )
    return ElevationGrid(
        path=header_path,
        data_path=data_path,
        layout=layout,
        georeference=georeference,
        title=f"{georeference.body} {header_path.stem}".strip(),
        format="GTOPO30" if data_path.suffix.lower() == ".dem" else "EHdr (BIL)",
        decoding=decoding,
        notes=(*notes, *frame.notes),
    )


def _samples(header: KeywordHeader) -> tuple[StoredSamples, tuple[str, ...]]:
    """Where the first band lies, and notes."""
    bits = header.whole("NBITS", 8)
    stored, notes = _stored(header, bits)
    rows, columns, bands = header.whole("NROWS"), header.whole("NCOLS"), header.whole("NBANDS", 1)
    layout = header.text("LAYOUT", "BIL")
    if layout not in {"BIL", "BIP", "BSQ"}:
        raise header.wrong("LAYOUT", layout, "BIL, BIP or BSQ", "Mend the header.")
    if bands < 1:
        raise header.wrong("NBANDS", bands, "at least 1", "Mend the header.")
    if bands > 1:
        notes = (*notes, f"The file has {bands} bands: the first is read.")
    size = bits // 8
    band_row = header.whole("BANDROWBYTES", 0) or columns * size
    packed = {"BIL": band_row * bands, "BIP": columns * size * bands, "BSQ": band_row}[layout]
    samples = StoredSamples(
        rows,
        columns,
        stored,
        _byte_order(header, bits),
        offset=header.whole("SKIPBYTES", 0),
        row_stride=header.whole("TOTALROWBYTES", 0) or packed,
        sample_stride=size * bands if layout == "BIP" and bands > 1 else None,
        void=header.void(*VOIDS),
    )
    return samples, notes


def _stored(header: KeywordHeader, bits: int) -> tuple[RawSample, tuple[str, ...]]:
    """Translate PIXELTYPE and NBITS; GTOPO30 has no PIXELTYPE, and its heights have signs."""
    kind = header.text("PIXELTYPE", "")
    notes: tuple[str, ...] = ()
    if not kind:
        kind = "UNSIGNEDINT" if bits == 8 else "SIGNEDINT"
    if kind in {"FLOATINGPOINT", "REAL"}:
        kind = "FLOAT"
    if (kind, bits) not in STORED:
        expected = ", ".join(f"{bits} {kind}" for kind, bits in STORED)
        raise header.wrong("NBITS and PIXELTYPE", f"{bits} {kind}", expected, "Convert the grid.")
    return STORED[kind, bits], notes


def _byte_order(header: KeywordHeader, bits: int) -> ByteOrder:
    if bits == 8:
        return "big"
    told = header.text("BYTEORDER")
    if told not in BYTE_ORDERS:
        raise header.wrong("BYTEORDER", told, "M (most significant byte first) or I", "Mend the header.")
    return BYTE_ORDERS[told]


def _georeference(
    header: KeywordHeader, data_path: Path, samples: StoredSamples
) -> tuple[Georeference, MapFrame]:
    """Place the first cell's centre."""
    step_x = header.positive(header.first_of("XDIM", "CELLSIZE", "DX") or "XDIM")
    step_y = header.positive(header.first_of("YDIM", "CELLSIZE", "DY") or "YDIM")
    first_x, first_y, registration = first_sample(header, samples.rows, step_x, step_y)
    size = (samples.columns, samples.rows)
    frame = frame_beside(data_path, (first_x, first_y), (step_x, step_y), size)
    return frame.georeference(first_x, first_y, step_x, step_y, registration, header.wrong, size), frame
