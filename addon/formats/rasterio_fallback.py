"""Whatever else GDAL reads, through rasterio where the person has it; never required."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any, Literal

from proxygraph import Grid, GridError, GridLayout, Progress

from . import jpeg2000
from .datums import WGS84
from .decoders import DECODERS
from .decoding import Decoding
from .elevation_grid import ElevationGrid
from .ellipsoid import Ellipsoid
from .format_error import FormatError
from .georeference import Georeference
from .map_frame import frame_of_text
from .not_a_grid import kind_of_file
from .projections import Geographic, Projection, Unknown
from .refusal import first_line, refusal

KIND = "rasterio"
"""Of the decoder."""

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

DRIVERS = (
    *("AIG", "BAG", "BT", "BSB", "CTable2", "DTED", "FITS", "GRIB", "GS7BG", "GSAG", "GSBG", "GTiff", "GXF"),
    *("HDF4", "HDF4Image", "HDF5", "HDF5Image", "HFA", "ILWIS", "ISIS2", "ISIS3", "JP2OpenJPEG", "JP2ECW"),
    *("JP2KAK", "KEA", "Leveller", "netCDF", "NITF", "NWT_GRD", "NTv2", "PCRaster", "RMF", "RST", "SAGA"),
    *("SDTS", "SIGDEM", "SNAP_TIFF", "SRTMHGT", "Terragen", "VICAR", "XYZ", "ZMap"),
)
"""GDAL's names of formats that hold their own samples; others lead to other files, or into the network."""

MOST_BYTES = 4 << 30
"""Of samples that are brought into memory; a small packed file may stand for more than any machine has."""

ROWS_AT_ONCE = 256

SampleType = Literal["i16", "u16", "i32", "f32", "f64"]

SAMPLES: dict[str, tuple[SampleType, str]] = {
    "int8": ("i16", "int16"),
    "uint8": ("i16", "int16"),
    "int16": ("i16", "int16"),
    "uint16": ("u16", "uint16"),
    "int32": ("i32", "int32"),
    "uint32": ("f64", "float64"),
    "int64": ("f64", "float64"),
    "uint64": ("f64", "float64"),
    "float32": ("f32", "float32"),
    "float64": ("f64", "float64"),
}
"""By rasterio's names: the sample of the layout, and what rasterio is asked to give."""

SAMPLE_BYTES = {"i16": 2, "u16": 2, "i32": 4, "f32": 4, "f64": 8}


def may_read(head: bytes) -> bool:
    """Whether this road is worth trying: a format known by name, or any bytes where rasterio is at hand."""
    if kind_of_file(head) is not None:
        return False
    return format_name(head) is not None or _rasterio() is not None


def format_name(head: bytes) -> str | None:
    """The name of a format that GDAL reads."""
    begun = head.lstrip(b" \t\r\n")
    return next((name for magic, name in MAGICS if head.startswith(magic) or begun.startswith(magic)), None)


def read_through_rasterio(path: Path) -> ElevationGrid:
    """Describe the first band of a raster that rasterio opens."""
    rasterio = _rasterio()
    if rasterio is None:
        raise FormatError(
            path,
            "format",
            found="a format that only rasterio reads",
            expected="rasterio in this Python",
            way_out="Install rasterio into Blender's Python, or convert the grid to GeoTIFF.",
        )
    try:
        with rasterio.open(path, driver=list(DRIVERS)) as source:
            return _described(path, source)
    except FormatError:
        raise
    except Exception as error:  # rasterio raises many kinds, some of them its own
        raise FormatError(
            path,
            "format",
            found=first_line(error),
            expected="a raster that rasterio reads",
            way_out="Choose the label or header of the grid, or convert it to GeoTIFF.",
        ) from error


def _rasterio() -> Any:
    """The module where the person has it; a broken installation counts as none."""
    try:
        return import_module("rasterio")
    except Exception:  # a library that cannot be loaded raises what it likes
        return None


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
            frame=frame,
        ),
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


def decode_through_rasterio(
    path: Path, layout: GridLayout, decoding: Decoding, progress: Progress | None
) -> Grid:
    """Read the first band, or a region of it, some rows at a time."""
    rasterio = _rasterio()
    if rasterio is None:
        raise OSError("rasterio, which read this file before, is not installed any more")
    windows = import_module("rasterio.windows")
    samples = bytearray(layout.samples * SAMPLE_BYTES[layout.sample])
    row_bytes = layout.columns * SAMPLE_BYTES[layout.sample]
    try:
        with rasterio.open(path, driver=list(DRIVERS)) as source:
            _, asked = SAMPLES[str(source.dtypes[0])]
            for row in range(0, layout.rows, ROWS_AT_ONCE):
                rows = min(ROWS_AT_ONCE, layout.rows - row)
                block = b"".join(_columns(source, windows, asked, decoding, row, rows, layout.columns))
                samples[row * row_bytes : (row + rows) * row_bytes] = block
                if progress is not None:
                    progress.step(row + rows, layout.rows)
    except rasterio.errors.RasterioError as error:
        raise OSError(first_line(error)) from error
    return Grid.from_buffer(samples, layout)


def _columns(
    source: Any, windows: Any, asked: str, decoding: Decoding, row: int, rows: int, columns: int
) -> list[bytes]:
    """Some rows of the region, little-endian; columns across the seam come from the first ones."""
    first = decoding.first_column
    until = min(first + columns, source.width)
    parts = [(first, until - first)]
    if until - first < columns:
        parts.append((0, columns - (until - first)))
    blocks = [
        source.read(1, window=windows.Window(start, decoding.first_row + row, count, rows), out_dtype=asked)
        for start, count in parts
    ]
    little = [block.astype(block.dtype.newbyteorder("<"), copy=False) for block in blocks]
    return [block[line].tobytes() for line in range(rows) for block in little]


DECODERS[KIND] = decode_through_rasterio
