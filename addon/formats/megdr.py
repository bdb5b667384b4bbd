"""MOLA gridded records: a detached PDS3 label (.lbl) beside raw samples (.img).

Format: "Mars Global Surveyor MOLA Mission Experiment Gridded Data Records", data set
MGS-M-MOLA-5-MEGDR-L3-V1.0, and the PDS3 Standards Reference for the label itself.
"""

from __future__ import annotations

from pathlib import Path, PureWindowsPath
from typing import Literal

from proxygraph import GridError, GridLayout

from .elevation_grid import ElevationGrid
from .ellipsoid import Ellipsoid
from .format_error import FormatError
from .georeference import Georeference
from .label import MAXIMUM_COUNT, Label, Units, read_label
from .partner_file import file_in_any_case, is_file
from .projections import Geographic

Sample = Literal["i16", "u16"]
ByteOrder = Literal["big", "little"]

SAMPLE_TYPES: dict[str, tuple[Sample, ByteOrder]] = {
    "MSB_INTEGER": ("i16", "big"),
    "LSB_INTEGER": ("i16", "little"),
    "MSB_UNSIGNED_INTEGER": ("u16", "big"),
    "LSB_UNSIGNED_INTEGER": ("u16", "little"),
}
"""PDS3 sample types of 16 bits, as (sample, byte order) of a GridLayout."""

PROJECTION = "SIMPLE CYLINDRICAL"

KILOMETRES: Units = {"KM": 1000.0, "M": 1.0}
"""To metres; PDS3 has radii in kilometres."""

DEGREES: Units = {"DEGREE": 1.0, "DEGREES": 1.0, "DEG": 1.0}

PIXELS_PER_DEGREE: Units = {"PIXEL/DEGREE": 1.0, "PIXELS/DEGREE": 1.0, "PIX/DEG": 1.0}

METRES: Units = {"METER": 1.0, "METERS": 1.0, "M": 1.0, "M/DN": 1.0}

LONGEST_NAME = 255
"""Bytes of a file name that common file systems take."""

LONGITUDE_LIMITS = "WESTERNMOST_LONGITUDE and EASTERNMOST_LONGITUDE"
LATITUDE_LIMITS = "MINIMUM_LATITUDE and MAXIMUM_LATITUDE"


def read_megdr(path: Path) -> ElevationGrid:
    """Read a label, given it or its data file."""
    label = read_label(_label_path(path))
    data_path, offset = _data_place(label)
    rows, columns = label.whole("IMAGE", "LINES"), label.whole("IMAGE", "LINE_SAMPLES")
    georeference = _georeference(label, rows, columns)
    layout = _layout(label, georeference, rows, columns, offset)
    _check_length(data_path, label, layout)
    synthetic = _is_synthetic(label)
    return ElevationGrid(
        path=label.path,
        data_path=data_path,
        layout=layout,
        georeference=georeference,
        title=_title(label, georeference, synthetic),
        format="MOLA (PDS3)",
        synthetic=synthetic,
    )


def _label_path(path: Path) -> Path:
    """Find the label that belongs to the chosen file."""
    if path.suffix.lower() == ".lbl":
        found = file_in_any_case(path)
        wanted = path
    else:
        wanted = path.with_suffix(".lbl")
        found = file_in_any_case(wanted)
    if found is None:
        raise FormatError(
            wanted,
            "label",
            found=f"no such file as {wanted.absolute()}",
            expected="a PDS3 label",
            way_out=(
                "Put the .lbl file beside the .img file; labels inside the data file are not read yet."
                if is_file(path)
                else "Check the path."
            ),
        )
    return found


def _data_place(label: Label) -> tuple[Path, int]:
    """Find the data file that ``^IMAGE`` points to, and the byte at which its samples begin."""
    name, offset = _image_pointer(label)
    if not _is_bare_file_name(name):
        # A label that was downloaded has no business in other folders.
        raise label.wrong(
            "^IMAGE", f'"{name}"', "the bare name of a file beside the label", "Mend the label."
        )
    named = label.path.with_name(name)
    beside = label.path.with_suffix(".img")
    found = file_in_any_case(named) or file_in_any_case(beside)
    if found is None:
        raise FormatError(
            label.path,
            "^IMAGE",
            found=f"no file {named.name} beside the label",
            expected="the data file that the label describes",
            way_out=f"Put {named.name} into the folder of the label.",
        )
    return found, offset


def _is_bare_file_name(name: str) -> bool:
    """Whether a name leads to no other folder, on any system, and may be one at all."""
    return (
        name not in {"", ".", ".."}
        and PureWindowsPath(name).name == name
        and name.isprintable()
        and len(name.encode()) <= LONGEST_NAME
    )


def _image_pointer(label: Label) -> tuple[str, int]:
    """Read ``^IMAGE``: a name, or (name, record from 1), or (name, byte from 1 with its unit)."""
    pointer = label.value("^IMAGE")
    if isinstance(pointer, str):
        return pointer, 0
    if isinstance(pointer, list | tuple) and len(pointer) == 2 and isinstance(pointer[0], str):
        name, place = pointer
        in_bytes = "BYTE" in str(getattr(place, "units", "")).upper()
        number = place.value if in_bytes else place
        if isinstance(number, int | float) and 1 <= number <= MAXIMUM_COUNT and number == int(number):
            before = int(number) - 1
            return name, before if in_bytes else before * label.whole("RECORD_BYTES")
    raise label.wrong(
        "^IMAGE",
        pointer,
        "the name of a data file, and where in it the samples begin",
        "Labels inside the data file are not read yet; use a grid with a separate .lbl file.",
    )


def _georeference(label: Label, rows: int, columns: int) -> Georeference:
    """Build the geometry from resolution and limits (``MAP_SCALE`` is rounded)."""
    projection = label.text("IMAGE_MAP_PROJECTION", "MAP_PROJECTION_TYPE").replace("_", " ").upper()
    if projection != PROJECTION:
        raise label.wrong(
            "MAP_PROJECTION_TYPE", projection, PROJECTION, "Other projections are not read yet."
        )
    direction = label.text("IMAGE_MAP_PROJECTION", "POSITIVE_LONGITUDE_DIRECTION", default="EAST").upper()
    if direction != "EAST":
        raise label.wrong(
            "POSITIVE_LONGITUDE_DIRECTION",
            direction,
            "EAST",
            "Maps with longitudes to the west are not read yet.",
        )

    def degrees(field: str) -> float:
        return label.number("IMAGE_MAP_PROJECTION", field, units=DEGREES)

    west, east = degrees("WESTERNMOST_LONGITUDE"), degrees("EASTERNMOST_LONGITUDE")
    if east <= west:
        east += 360.0
    south, north = degrees("MINIMUM_LATITUDE"), degrees("MAXIMUM_LATITUDE")
    if not (0.0 < east - west <= 360.0):
        raise label.wrong(LONGITUDE_LIMITS, f"{west} and {east}", "at most 360 degrees", "Mend the label.")
    if not (-90.0 <= south < north <= 90.0):
        raise label.wrong(
            LATITUDE_LIMITS, f"{south} and {north}", "south < north within +-90", "Mend the label."
        )
    resolution = _positive(label, "MAP_RESOLUTION", PIXELS_PER_DEGREE)
    _check_size(label, rows, columns, (east - west) * resolution, (north - south) * resolution)
    step = 1.0 / resolution
    return Georeference(
        body=label.text("TARGET_NAME").title(),
        ellipsoid=Ellipsoid.sphere(_positive(label, "A_AXIS_RADIUS", KILOMETRES)),
        projection=Geographic(),
        first_x=west + step / 2.0,
        first_y=north - step / 2.0,
        step_x=step,
        step_y=step,
        vertical_reference=_vertical_reference(label),
    )


def _positive(label: Label, field: str, units: Units) -> float:
    number = label.number("IMAGE_MAP_PROJECTION", field, units=units)
    if number <= 0.0:
        raise label.wrong(field, number, "a number above 0", "Mend the label.")
    return number


def _vertical_reference(label: Label) -> str:
    """Radius products count from the body's centre, topography from its areoid."""
    name = label.text("IMAGE", "NAME", default="TOPOGRAPHY").upper()
    if "RADIUS" in name:
        return "centre of the body"
    return "areoid" if label.text("TARGET_NAME").upper() == "MARS" else "reference surface"


def _layout(label: Label, georeference: Georeference, rows: int, columns: int, offset: int) -> GridLayout:
    """Say where the samples lie and what they mean."""
    sample, byte_order = _sample(label)
    unit = label.text("IMAGE", "UNIT", default="METER").upper()
    if unit not in METRES:
        raise label.wrong("UNIT", unit, " or ".join(METRES), "Only heights in metres are read yet.")
    cell_width, cell_height = georeference.cell_size(rows)
    prefix = label.whole("IMAGE", "LINE_PREFIX_BYTES", default=0)
    suffix = label.whole("IMAGE", "LINE_SUFFIX_BYTES", default=0)
    try:
        return GridLayout(
            rows,
            columns,
            cell_width=cell_width,
            cell_height=cell_height,
            sample=sample,
            byte_order=byte_order,
            offset=offset + prefix,
            row_stride=prefix + columns * 2 + suffix,
            scale=label.number("IMAGE", "SCALING_FACTOR", units=METRES, default=1.0),
            value_offset=label.number("IMAGE", "OFFSET", units=METRES, default=0.0),
            void=label.number("IMAGE", "MISSING_CONSTANT", default=None),
            wraps=georeference.spans_the_globe(columns),
        )
    except (GridError, OverflowError) as error:  # the second for what no 64 bits hold
        raise label.wrong("IMAGE", error, "a grid that can be touched", "Mend the label.") from error


def _sample(label: Label) -> tuple[Sample, ByteOrder]:
    """Translate ``SAMPLE_TYPE``, ``SAMPLE_BITS`` and ``BANDS``."""
    sample_type = label.text("IMAGE", "SAMPLE_TYPE").upper()
    if sample_type not in SAMPLE_TYPES:
        raise label.wrong(
            "SAMPLE_TYPE",
            sample_type,
            ", ".join(SAMPLE_TYPES),
            "Convert the grid to 16-bit integers, or mend the label.",
        )
    bits = label.whole("IMAGE", "SAMPLE_BITS")
    if bits != 16:
        raise label.wrong("SAMPLE_BITS", bits, 16, "Only samples of 16 bits are read yet.")
    bands = label.whole("IMAGE", "BANDS", default=1)
    if bands != 1:
        raise label.wrong("BANDS", bands, 1, "Choose a grid with elevations only.")
    return SAMPLE_TYPES[sample_type]


def _check_size(label: Label, rows: int, columns: int, across: float, down: float) -> None:
    """Refuse sizes that make no surface, or that contradict the limits: places would be wrong.

    Args:
        across, down: columns and rows that resolution and limits speak of.
    """
    for field, count in (("LINES", rows), ("LINE_SAMPLES", columns)):
        if count < 2:
            raise label.wrong(field, count, "at least 2", "A single line of samples has no surface to touch.")
    for field, count, degrees in (("LINE_SAMPLES", columns, across), ("LINES", rows, down)):
        if abs(count - degrees) > 0.5:
            raise label.wrong(
                field,
                count,
                f"{degrees:g} from MAP_RESOLUTION and the limits",
                "Mend whichever of them is wrong.",
            )


def _check_length(data_path: Path, label: Label, layout: GridLayout) -> None:
    """Refuse a data file that ends before the label says."""
    try:
        found = data_path.stat().st_size
    except OSError as error:
        raise FormatError(
            data_path,
            "data file",
            found=error.strerror,
            expected="a readable file",
            way_out="Check its permissions.",
        ) from error
    if found < layout.byte_length:
        raise FormatError(
            data_path,
            "length",
            found=f"{found:,} bytes",
            expected=f"{layout.byte_length:,} bytes for LINES and LINE_SAMPLES in {label.path.name}",
            way_out="The file is cut short: download it again.",
        )


def _is_synthetic(label: Label) -> bool:
    """Whether the label owns up to made-up heights."""
    places = (
        "TARGET_NAME",
        "DATA_SET_ID",
        "PRODUCT_ID",
        "INSTRUMENT_ID",
        "INSTRUMENT_NAME",
        "NOTE",
        "DESCRIPTION",
    )
    told = [label.text(place, default="") for place in places]
    told += [label.text("IMAGE", place, default="") for place in ("NAME", "NOTE", "DESCRIPTION")]
    return any("SYNTHETIC" in text.upper() for text in told)


def _title(label: Label, georeference: Georeference, synthetic: bool) -> str:
    """Name the grid for people."""
    title = f"{georeference.body} {label.path.stem}"
    return f"{title} (synthetic)" if synthetic and "synthetic" not in title.lower() else title
