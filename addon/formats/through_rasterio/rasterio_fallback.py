"""Whatever else GDAL reads, through rasterio where the person has it; never required."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from proxygraph import GridError, GridLayout

from ..body.datums import WGS84
from ..body.ellipsoid import Ellipsoid
from ..decoding import Decoding
from ..elevation_grid import ElevationGrid
from ..file_bytes import file_length, read_head
from ..format_error import FormatError
from ..frames.map_frame import frame_of_text
from ..georeference import Georeference
from ..not_a_grid import kind_of_file, without_header
from ..projections import Geographic, Projection, Unknown
from ..refusal import first_line, refusal
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
"""Of samples that are brought into memory; a small packed file may stand for more than any machine has."""


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
    georeference, notes = _georeference(source, refuse)
    width, height = georeference.cell_size(source.height)
    try:
        layout = GridLayout(
            source.height,
            source.width,
            cell_width=width,
            cell_height=height,
            sample=sample,
            byte_order="little",
            scale=float(source.scales[0]),
            value_offset=float(source.offsets[0]),
            void=None if source.nodata is None else float(source.nodata),
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
        notes=("Read through rasterio.", *notes),
    )


def _georeference(source: Any, refuse: Any) -> tuple[Georeference, tuple[str, ...]]:
    """From the transform and the coordinate system that GDAL found."""
    transform = source.transform
    if transform.b != 0.0 or transform.d != 0.0 or transform.a <= 0.0 or transform.e == 0.0:
        raise refuse(
            "transform",
            (transform.a, transform.b, transform.d, transform.e),
            "rows to the east, columns to the south",
            "Warp the grid north up.",
        )
    notes: list[str] = []
    down = -transform.e
    if down < 0.0:
        raise refuse(
            "transform",
            (transform.a, transform.b, transform.d, transform.e),
            "the first row in the north",
            "Flip the grid.",
        )
    projection: Projection = Unknown()
    ellipsoid, body, frame = WGS84, "", ""
    crs = source.crs
    if crs is not None:
        frame = str(crs.to_string())[:200]
        told = frame_of_text(crs.to_wkt())
        if told is not None and (told.unit, told.shift_x) == (1.0, 0.0):
            projection, ellipsoid, body = told.projection, told.ellipsoid, told.body
        elif crs.is_geographic:
            projection, ellipsoid = Geographic(), _ellipsoid(crs) or WGS84
        else:
            notes.append("The projection is not known here: places are given in the map's metres only.")
    else:
        notes.append("The file does not state its coordinate system.")
    return (
        Georeference(
            body=body,
            ellipsoid=ellipsoid,
            projection=projection,
            first_x=transform.c + transform.a / 2.0,
            first_y=transform.f - down / 2.0,
            step_x=transform.a,
            step_y=down,
            vertical_reference="not stated",
            latitude_kind="planetocentric" if ellipsoid.is_sphere else "planetographic",
            frame=frame,
        ).closed(source.width),
        tuple(notes),
    )


def _ellipsoid(crs: Any) -> Ellipsoid | None:
    """The sphere or ellipsoid of a PROJ description."""
    told = {key: value for key, value in crs.to_dict().items() if key in {"R", "a", "b"}}
    try:
        major = float(told.get("R", told.get("a", 0.0)))
        minor = float(told.get("b", major))
    except (TypeError, ValueError):
        return None
    return Ellipsoid(major, minor) if 0.0 < minor <= major else None
