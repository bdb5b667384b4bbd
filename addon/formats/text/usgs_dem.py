"""USGS digital elevation models as text: 7.5' and 15' quadrangles in UTM, 1 degree in seconds of arc.

Source: U.S. Geological Survey, "Standards for Digital Elevation Models", Part 2: Specifications (1998);
codes of datums: table 2-1, elements 26 and 27.
"""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path

from proxygraph import GridError, GridLayout, Progress, UsgsDem

from ..body.datums import DATUM_WGS72, DATUM_WGS84, NAD27, NAD83, Datum
from ..decoding import Decoding
from ..elevation_grid import ElevationGrid
from ..frames.map_place import check_place
from ..frames.stated_projection import utm
from ..georeference import Georeference
from ..native_refusal import native_refusal
from ..projections import Geographic, Projection, Unknown
from ..refusal import refusal

KIND = "usgs_dem"
"""In ``DECODERS``."""

FOOT = 0.3048
"""Metres; heights."""

SURVEY_FOOT = 1200.0 / 3937.0
"""Metres; state plane coordinates."""

DATUMS: dict[int, Datum] = {
    1: NAD27,
    2: DATUM_WGS72,
    3: DATUM_WGS84,
    4: NAD83,
    5: Datum("Old Hawaiian", NAD27.ellipsoid),
    6: Datum("Puerto Rico", NAD27.ellipsoid),
}

VERTICAL_DATUMS = {1: "local mean sea level", 2: "NGVD 29", 3: "NAVD 88"}

GROUND_UNITS = {
    "radian": math.degrees(1.0),
    "arc-second": 1.0 / 3600.0,
    "metre": 1.0,
    "foot": SURVEY_FOOT,
}
"""To degrees or metres."""

WAY_OUT = "Download the file again, or choose another; a USGS DEM begins with an A record of text."


def read_usgs_dem(path: Path, progress: Progress | None = None) -> ElevationGrid:
    """Read the header, and look at every height once.

    Raises:
        FormatError: naming what is not as it should be.
        CancelledError: ``progress`` was asked to end.
    """
    try:
        dem = UsgsDem.open(path, progress)
    except (GridError, OSError) as error:
        raise native_refusal(path, error, WAY_OUT) from error
    datum, datum_note = _datum(dem)
    georeference = _georeference(dem, datum)
    check_place(georeference, dem.rows, dem.columns, partial(refusal, path))
    try:
        layout = _layout(dem, georeference)
    except GridError as error:
        raise native_refusal(path, error, WAY_OUT) from error
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=layout,
        georeference=georeference,
        title=dem.name or path.stem,
        format="USGS DEM",
        synthetic="SYNTHETIC" in dem.name.upper(),
        decoding=Decoding(KIND),
        notes=(*dem.notes, *datum_note),
        range=_range(dem),
        voids=dem.rows * dem.columns - dem.heights,
    )


def _datum(dem: UsgsDem) -> tuple[Datum, tuple[str, ...]]:
    """The horizontal datum; old files do not say, and are of NAD27's time."""
    code = dem.horizontal_datum
    if code in DATUMS:
        return DATUMS[code], ()
    told = "The file does not say" if code in {None, 0} else f"The code {code} says nothing of"
    return NAD27, (f"{told} its horizontal datum: NAD27 is assumed.",)


def _georeference(dem: UsgsDem, datum: Datum) -> Georeference:
    unit = GROUND_UNITS[dem.ground_unit]
    (first_x, first_y), (step_x, step_y) = dem.first, dem.step
    projection, coordinates = _projection(dem)
    vertical = VERTICAL_DATUMS.get(dem.vertical_datum or 0, "mean sea level")
    return Georeference(
        body="Earth",
        ellipsoid=datum.ellipsoid,
        projection=projection,
        first_x=first_x * unit,
        first_y=first_y * unit,
        step_x=step_x * unit,
        step_y=step_y * unit,
        vertical_reference=vertical,
        vertical_unit="ft" if dem.elevation_unit == "foot" else "m",
        latitude_kind="planetographic",
        registration="points",
        frame=f"{datum.name}, {coordinates}",
    )


def _projection(dem: UsgsDem) -> tuple[Projection, str]:
    """The projection, and what people call the coordinates."""
    if dem.system == "geographic":
        return Geographic(), "longitude and latitude"
    if dem.system == "UTM" and dem.ground_unit == "metre":
        # Zones of the southern half have a minus, or none at all where nothing of the kind is mapped.
        hemisphere = "S" if dem.zone < 0 else "N"
        return utm(abs(dem.zone), north=dem.zone >= 0), f"UTM zone {abs(dem.zone)}{hemisphere}"
    return Unknown(), f"{dem.system} zone {dem.zone}" if dem.zone else dem.system


def _range(dem: UsgsDem) -> tuple[float, float] | None:
    """Metres."""
    if dem.range is None:
        return None
    lowest, highest = dem.range
    return lowest * _metres(dem), highest * _metres(dem)


def _metres(dem: UsgsDem) -> float:
    """Of one unit of the heights."""
    return FOOT if dem.elevation_unit == "foot" else 1.0


def _layout(dem: UsgsDem, georeference: Georeference) -> GridLayout:
    metres = _metres(dem)
    cell_width, cell_height = georeference.cell_size(dem.rows, dem.columns)
    return GridLayout(
        dem.rows,
        dem.columns,
        cell_width=cell_width,
        cell_height=cell_height,
        sample=dem.sample,
        byte_order="little",
        scale=dem.scale * metres,
        value_offset=dem.value_offset * metres,
        void=None if math.isnan(dem.void) else dem.void,
        wraps=georeference.spans_the_globe(dem.columns),
    )
