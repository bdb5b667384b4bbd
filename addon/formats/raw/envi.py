"""ENVI rasters: a text header (``name.hdr`` or ``name.dat.hdr``) beside raw bands.

Format: "ENVI Header Files" (NV5 Geospatial documentation). In ``map info`` pixel (1, 1) is the outer corner
of the first pixel, and (1.5, 1.5) its centre.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from ..body.bodies import body_in
from ..body.datums import WGS84
from ..body.ellipsoid import Ellipsoid
from ..elevation_grid import ElevationGrid
from ..file_bytes import check_length
from ..frames.map_frame import GEOGRAPHIC_WGS84, MapFrame, frame_of_text
from ..georeference import Georeference
from ..partner_file import file_in_any_case
from ..projections import Geographic, TransverseMercator, Unknown
from .data_beside import first_beside
from .envi_header import EnviHeader, read_envi_header
from .envi_units import in_stated_units
from .raw_samples import RAW_BYTES, ByteOrder, RawSample
from .stored_samples import StoredSamples

DATA_SUFFIXES = ("", ".dat", ".img", ".bin", ".raw", ".bsq", ".bil", ".bip", ".envi", ".dem", ".flt", ".grd")

DATA_TYPES: dict[int, RawSample] = {
    1: "u8",
    2: "i16",
    3: "i32",
    4: "f32",
    5: "f64",
    12: "u16",
    13: "u32",
    14: "i64",
    15: "u64",
}

UNKNOWN_STEP = 1.0
"""Metres between samples of a file without ``map info``."""


def read_envi(header_path: Path, data_path: Path | None = None) -> ElevationGrid:
    """Read a header, and find its data unless they are given."""
    header = read_envi_header(header_path)
    data_path = data_path or _data_path(header)
    samples, notes = _samples(header)
    samples.check_size(header.wrong, "lines", "samples")
    georeference, place_notes = _georeference(header, samples)
    layout, decoding = samples.placed(georeference, header.wrong)
    check_length(data_path, samples.byte_length, f"lines and samples in {header_path.name}")
    return ElevationGrid(
        path=header_path,
        data_path=data_path,
        layout=layout,
        georeference=georeference,
        title=f"{georeference.body} {data_path.stem}".strip(),
        format="ENVI",
        decoding=decoding,
        notes=(*notes, *place_notes),
    )


def _data_path(header: EnviHeader) -> Path:
    """``name.dat.hdr`` belongs to ``name.dat``; ``name.hdr`` to ``name`` with any ending."""
    named = file_in_any_case(header.path.with_suffix("")) if header.path.stem else None
    found = named or first_beside(header.path, DATA_SUFFIXES)
    if found is None:
        raise header.wrong(
            "data file",
            f"none named {header.path.stem}, {header.path.stem}.dat or {header.path.stem}.img",
            "the data file beside its header",
            "Put both into one folder.",
        )
    return found


def _samples(header: EnviHeader) -> tuple[StoredSamples, tuple[str, ...]]:
    """Where the first band lies, and notes."""
    if header.whole("file compression", 0) != 0:
        raise header.wrong("file compression", 1, "0", "Unpack the data file first.")
    code = header.whole("data type")
    if code not in DATA_TYPES:
        expected = ", ".join(str(known) for known in DATA_TYPES)
        raise header.wrong("data type", code, expected, "Convert the grid: only real numbers are heights.")
    stored = DATA_TYPES[code]
    size = RAW_BYTES[stored]
    rows, columns, bands = header.whole("lines"), header.whole("samples"), header.whole("bands", 1)
    interleave = header.text("interleave", "bsq").lower()
    if interleave not in {"bsq", "bil", "bip"}:
        raise header.wrong("interleave", interleave, "bsq, bil or bip", "Mend the header.")
    if bands < 1:
        raise header.wrong("bands", bands, "at least 1", "Mend the header.")
    in_row = 1 if interleave == "bsq" else bands
    samples = StoredSamples(
        rows,
        columns,
        stored,
        _byte_order(header, size),
        offset=header.whole("header offset", 0),
        row_stride=in_row * columns * size,
        sample_stride=bands * size if interleave == "bip" and bands > 1 else None,
        scale=header.number("data gain values", 1.0),
        value_offset=header.number("data offset values", 0.0),
        void=_void(header),
    )
    notes = (f"The file has {bands} bands: the first is read.",) if bands > 1 else ()
    return samples, notes


def _void(header: EnviHeader) -> float | None:
    text = header.text("data ignore value", "").lower()
    return None if text in {"", "nan", "-nan", "none"} else header.number("data ignore value")


def _byte_order(header: EnviHeader, size: int) -> ByteOrder:
    order = header.whole("byte order", 0) if size == 1 else header.whole("byte order")
    if order not in {0, 1}:
        raise header.wrong("byte order", order, "0 (least significant byte first) or 1", "Mend the header.")
    return "big" if order else "little"


def _georeference(header: EnviHeader, samples: StoredSamples) -> tuple[Georeference, tuple[str, ...]]:
    """Place the first sample's centre."""
    size = (samples.columns, samples.rows)
    items = header.items("map info")
    positional = [item for item in items if "=" not in item]
    named = dict(item.lower().replace(" ", "").split("=", 1) for item in items if "=" in item)
    if len(positional) < 7:
        frame = MapFrame(
            "",
            WGS84,
            Unknown(),
            vertical_reference="not stated",
            notes=("The header has no map info: cells of 1 m of an unknown map are assumed.",),
        )
        return frame.georeference(
            0.0, 0.0, UNKNOWN_STEP, UNKNOWN_STEP, "cells", header.wrong, size
        ), frame.notes
    if header.finite("map info: rotation", named.get("rotation", "0")) != 0.0:
        raise header.wrong(
            "map info: rotation", named["rotation"], "0", "Turn the grid north up in another program first."
        )
    pixel_x, pixel_y, x, y, step_x, step_y = (header.finite("map info", item) for item in positional[1:7])
    for field, step in (("map info: x size", step_x), ("map info: y size", step_y)):
        if step <= 0.0:
            raise header.wrong(field, f"{step:g}", "a number above 0", "Mend the header.")
    first_x, first_y = x + (1.5 - pixel_x) * step_x, y - (1.5 - pixel_y) * step_y
    frame = in_stated_units(header, _frame(header, positional), named.get("units", ""))
    return (
        frame.georeference(first_x, first_y, step_x, step_y, "cells", header.wrong, size),
        frame.notes,
    )


def _frame(header: EnviHeader, positional: list[str]) -> MapFrame:
    """The coordinate system string where it is understood, else the names in ``map info``."""
    told = header.text("coordinate system string", "")
    frame = frame_of_text(told) if told else None
    if frame is not None:
        return frame
    name = positional[0].lower()
    words = f"{' '.join(positional)} {told}".upper()
    shape = body_in(words)
    body = None if shape is None or shape.body == "Earth" else shape
    if name.startswith("geographic"):
        if body is not None:
            return MapFrame(
                body.name,
                Ellipsoid.sphere(body.ellipsoid.semi_major),
                Geographic(),
                vertical_reference="not stated",
                latitude_kind="planetocentric",
            )
        if "WGS" in words:
            return GEOGRAPHIC_WGS84
        note = "The datum is not understood: WGS 84 is assumed."
        return replace(GEOGRAPHIC_WGS84, frame="WGS 84 (assumed)", notes=(note,))
    utm = _utm(header, positional) if name == "utm" else None
    if utm is not None:
        return utm
    note = f"The projection {positional[0]} is not understood: places are given in the map's metres only."
    return MapFrame(
        body.name if body else "",
        Ellipsoid.sphere(body.ellipsoid.semi_major) if body else WGS84,
        Unknown(),
        vertical_reference="not stated",
        notes=(note,),
    )


def _utm(header: EnviHeader, positional: list[str]) -> MapFrame | None:
    """UTM as ``map info`` states it: after the cells zone, half of the globe, and datum."""
    if len(positional) < 9:
        return None
    zone, half, datum = positional[7], positional[8].lower(), "".join(positional[9:10])
    if not zone.isdigit() or not 1 <= int(zone) <= 60 or half not in {"north", "south"}:
        raise header.wrong(
            "map info: zone", f"{zone}, {half}", "1 to 60, and North or South", "Mend the header."
        )
    projection = TransverseMercator.utm(int(zone), half == "north")
    # The ellipsoids of NAD 83 and others differ from that of WGS 84 by less than a metre.
    known = datum.upper().replace("-", "").replace(" ", "") in {"WGS84", "NAD83", "GRS80"}
    note = f"The datum {datum or 'is not stated, and'} is taken for WGS 84's ellipsoid."
    return MapFrame(
        "Earth", WGS84, projection, f"UTM zone {zone} {half} {datum}", notes=() if known else (note,)
    )
