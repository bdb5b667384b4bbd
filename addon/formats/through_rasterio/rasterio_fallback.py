"""Whatever else GDAL reads, through rasterio where the person has it; never required."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from proxygraph import GridError, GridLayout

from ..body.datums import WGS84
from ..body.ellipsoid import Ellipsoid
from ..decoding import Decoding
from ..elevation_grid import ElevationGrid
from ..file_bytes import file_length, read_head
from ..format_error import FormatError
from ..frames.map_frame import MapFrame, frame_beside, frame_of_text
from ..georeference import Georeference, LatitudeKind
from ..height_units import UNITS
from ..not_a_grid import kind_of_file, without_header
from ..projections import Geographic, Unknown
from ..raw.stored_samples import void_of
from ..refusal import Refuse, first_line, refusal
from ..region import SAMPLE_BYTES
from . import jpeg2000
from .rasterio_library import SAMPLES, open_raster, rasterio_module

KIND = "rasterio"
"""In ``DECODERS``."""

MAGICS = (
    *((magic, "JPEG 2000") for magic in jpeg2000.MAGICS),
    (b"\x89HDF", "HDF5 or NetCDF 4"),
    (b"\x0e\x03\x13\x01", "HDF4"),
    (b"CDF\x01", "NetCDF"),
    (b"CDF\x02", "NetCDF"),
    (b"EHFA_HEADER_TAG", "ERDAS Imagine"),
    (b"GRIB", "GRIB"),
    (b"DSAA", "Surfer grid"),
    (b"DSBB", "Surfer grid"),
    (b"DSRB", "Surfer grid"),
    (b"Object = IsisCube", "ISIS cube"),
    (b"LBLSIZE=", "VICAR"),
    (b"NITF", "NITF"),
    (b"SIMPLE  =", "FITS"),
    (b"UHL1", "DTED"),
    (b"binterr1", "Binary Terrain"),
    (b"PCRASTER", "PCRaster"),
)
"""How formats begin that GDAL reads and that are known by name."""

MAGIC_BYTES = 1024
"""In which one of them is found, behind blanks."""

MOST_BYTES = 4 << 30
"""Of samples that are decoded; a small packed file may stand for more than any machine has."""


LEAST_UNIT = 1e-9
"""Metres; a map's unit is between this and its inverse."""


def may_read(head: bytes) -> bool:
    """Whether this road is worth trying: a format known by name, or any bytes where rasterio is at hand."""
    if kind_of_file(head) is not None:
        return False
    return format_name(head) is not None or rasterio_module() is not None


def format_name(head: bytes) -> str | None:
    """The name of a format that GDAL reads."""
    begun = head.lstrip(b" \t\r\n")
    return next((name for magic, name in MAGICS if head.startswith(magic) or begun.startswith(magic)), None)


def read_through_rasterio(path: Path) -> ElevationGrid:
    """Describe the first band of a raster that rasterio opens."""
    rasterio = rasterio_module()
    if rasterio is None:
        raise FormatError(
            path,
            "format",
            found="a format that only rasterio reads",
            expected="rasterio in this Python",
            way_out="Install rasterio into Blender's Python, or convert the grid to GeoTIFF.",
        )
    try:
        with open_raster(rasterio, path) as source:
            return _described(path, source)
    except FormatError:
        raise
    except Exception as error:  # rasterio raises many kinds, some of them its own
        if format_name(read_head(path, MAGIC_BYTES)) is None:
            # What nobody knows, rasterio included, may be data without its header.
            raise without_header(path, file_length(path)) from error
        raise FormatError(
            path,
            "format",
            found=first_line(error),
            expected="a raster that rasterio reads",
            way_out="Choose the label or header of the grid, or convert it to GeoTIFF.",
        ) from error


def _described(path: Path, source: Any) -> ElevationGrid:
    def refuse(field: str, found: object, expected: object, way_out: str) -> FormatError:
        return refusal(path, field, found, expected, way_out)

    dtype = str(source.dtypes[0]) if source.count else "no band"
    if dtype not in SAMPLES:
        raise refuse("samples", dtype, ", ".join(SAMPLES), "Convert the grid to numbers of 32 bits.")
    sample, _ = SAMPLES[dtype]
    size = source.width * source.height * SAMPLE_BYTES[sample]
    if size > MOST_BYTES:
        raise refuse(
            "size",
            f"{size:,} bytes of samples",
            f"at most {MOST_BYTES:,}",
            "Cut the grid, or convert it to ENVI.",
        )
    heights, notes_on_heights = _heights(source)
    georeference, notes = _georeference(path, source, heights, refuse)
    width, height = georeference.cell_size(source.height, source.width)
    try:
        layout = GridLayout(
            source.height,
            source.width,
            cell_width=width,
            cell_height=height,
            sample=sample,
            byte_order="little",
            scale=float(source.scales[0]) * heights.metres,
            value_offset=float(source.offsets[0]) * heights.metres,
            void=None if source.nodata is None else void_of(sample, float(source.nodata)),
            wraps=georeference.spans_the_globe(source.width),
        )
    except (GridError, OverflowError) as error:
        raise refuse("grid", error, "a grid that can be touched", "Convert the grid.") from error
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=layout,
        georeference=georeference,
        title=f"{georeference.body} {path.stem}".strip(),
        format=f"{source.driver} (rasterio)",
        decoding=Decoding(KIND),
        notes=("Read through rasterio.", *notes, *notes_on_heights),
    )


@dataclass(frozen=True)
class _Heights:
    """The unit of heights."""

    name: str = "m"
    metres: float = 1.0


def _heights(source: Any) -> tuple[_Heights, tuple[str, ...]]:
    """The unit that GDAL found for the first band; metres where there is none."""
    name = str(next(iter(source.units), None) or "").strip()
    metres = UNITS.get(name.lower())
    if metres is not None:
        return _Heights(name, metres), ()
    if not name:
        return _Heights(), ()
    return _Heights(), (f'The unit of heights is "{name[:40]}", which is not known here: m is assumed.',)


def _georeference(
    path: Path, source: Any, heights: _Heights, refuse: Refuse
) -> tuple[Georeference, tuple[str, ...]]:
    """From the transform and the coordinate system that GDAL found."""
    transform = source.transform
    found = (transform.a, transform.b, transform.d, transform.e)
    if transform.b != 0.0 or transform.d != 0.0 or transform.a <= 0.0 or transform.e == 0.0:
        raise refuse("transform", found, "rows to the east, columns to the south", "Warp the grid north up.")
    down = -transform.e
    if down < 0.0:
        raise refuse("transform", found, "the first row in the north", "Flip the grid.")
    first = (transform.c + transform.a / 2.0, transform.f - down / 2.0)
    step, size = (transform.a, down), (source.width, source.height)
    frame = _frame(source.crs) if source.crs is not None else frame_beside(path, first, step, size)
    georeference = frame.georeference(*first, *step, "cells", refuse, size)
    kind: LatitudeKind = "planetocentric" if frame.ellipsoid.is_sphere else "planetographic"
    return (
        replace(
            georeference,
            vertical_reference="not stated",
            vertical_unit=heights.name,
            latitude_kind=kind,
        ).closed(source.width),
        frame.notes,
    )


def _frame(crs: Any) -> MapFrame:
    """The frame of a coordinate system; what the text of it does not tell, rasterio is asked."""
    name = str(crs.to_string())[:200]
    told = frame_of_text(crs.to_wkt())
    if told is not None:
        return replace(told, frame=name)
    ellipsoid = _ellipsoid(crs) or WGS84
    if crs.is_geographic:
        return MapFrame("", ellipsoid, Geographic(), name)
    note = "The projection is not known here: places are given in the map's metres only."
    return MapFrame("", ellipsoid, Unknown(), name, unit=_metres(crs), notes=(note,))


def _metres(crs: Any) -> float:
    """Metres for one unit of a map."""
    try:
        metres = float(crs.linear_units_factor[1])
    except Exception:  # rasterio raises its own where there is none
        return 1.0
    return metres if LEAST_UNIT <= metres <= 1.0 / LEAST_UNIT else 1.0


def _ellipsoid(crs: Any) -> Ellipsoid | None:
    """The sphere or ellipsoid of a PROJ description."""
    told = {key: value for key, value in crs.to_dict().items() if key in {"R", "a", "b"}}
    try:
        major = float(told.get("R", told.get("a", 0.0)))
        minor = float(told.get("b", major))
    except (TypeError, ValueError):
        return None
    return Ellipsoid(major, minor) if 0.0 < minor <= major else None
