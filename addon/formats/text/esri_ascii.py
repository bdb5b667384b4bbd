"""Esri ASCII grids (``.asc``): a short header and heights as text; a ``.prj`` beside them says where.

Source: Esri, "ArcGIS Pro: Esri ASCII raster format".
"""

from __future__ import annotations

import math
from pathlib import Path

from proxygraph import EsriAscii, GridError, GridLayout, Progress

from ..body.datums import DATUM_WGS84
from ..decoding import Decoding
from ..elevation_grid import ElevationGrid
from ..frames.map_place import check_place
from ..frames.stated_frame import StatedFrame, read_stated_frame
from ..georeference import Georeference
from ..native_refusal import native_refusal
from ..partner_file import file_in_any_case
from ..projections import Geographic, Unknown

KIND = "esri_ascii"
"""In ``DECODERS``."""

WAY_OUT = "Mend the header or export the grid again; it needs NCOLS, NROWS, a corner and CELLSIZE."


def read_esri_ascii(path: Path, progress: Progress | None = None) -> ElevationGrid:
    """Read the header, and look at every height once.

    Raises:
        FormatError: naming what is not as it should be.
        CancelledError: ``progress`` was asked to end.
    """
    try:
        ascii_grid = EsriAscii.open(path, progress)
    except (GridError, OSError) as error:
        raise native_refusal(path, error, WAY_OUT) from error
    frame = _frame(path, ascii_grid)
    georeference = _georeference(ascii_grid, frame)
    check_place(path, georeference, ascii_grid.rows, ascii_grid.columns)
    try:
        layout = _layout(ascii_grid, georeference, frame)
    except GridError as error:
        raise native_refusal(path, error, WAY_OUT) from error
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=layout,
        georeference=georeference,
        title=path.stem,
        format="Esri ASCII",
        synthetic="synthetic" in path.stem.lower(),
        decoding=Decoding(KIND),
        notes=frame.notes,
    )


def _frame(path: Path, ascii_grid: EsriAscii) -> StatedFrame:
    """What the ``.prj`` file states; degrees on Earth where there is none and the numbers may be degrees."""
    beside = file_in_any_case(path.with_suffix(".prj"))
    stated = None if beside is None else read_stated_frame(beside)
    if stated is not None:
        return stated
    told = "There is no .prj file" if beside is None else f"{beside.name} is not understood"
    (x, y), (step_x, step_y) = ascii_grid.corner, ascii_grid.step
    may_be_degrees = (
        abs(y) <= 90.5
        and abs(y + ascii_grid.rows * step_y) <= 90.5
        and abs(x) <= 360.5
        and abs(x + ascii_grid.columns * step_x) <= 721.0
        and max(step_x, step_y) < 10.0
    )
    if may_be_degrees:
        note = f"{told}: longitude and latitude on WGS 84 are assumed."
        return StatedFrame("Earth", DATUM_WGS84.ellipsoid, Geographic(), "WGS 84 (assumed)", notes=(note,))
    note = f"{told}: coordinates are taken for metres of an unknown map."
    return StatedFrame("", DATUM_WGS84.ellipsoid, Unknown(), "", notes=(note,))


def _georeference(ascii_grid: EsriAscii, frame: StatedFrame) -> Georeference:
    (x, y), (step_x, step_y) = ascii_grid.corner, ascii_grid.step
    x_is_center, y_is_center = ascii_grid.corner_is_center
    west = x if x_is_center else x + step_x / 2.0
    south = y if y_is_center else y + step_y / 2.0
    return Georeference(
        body=frame.body,
        ellipsoid=frame.ellipsoid,
        projection=frame.projection,
        first_x=west * frame.unit + frame.shift_x,
        first_y=(south + (ascii_grid.rows - 1) * step_y) * frame.unit,
        step_x=step_x * frame.unit,
        step_y=step_y * frame.unit,
        vertical_reference="not stated",
        vertical_unit="m" if frame.vertical_unit == 1.0 else f"{frame.vertical_unit:g} m",
        latitude_kind="planetographic",
        registration="cells",
        frame=frame.name,
    )


def _layout(ascii_grid: EsriAscii, georeference: Georeference, frame: StatedFrame) -> GridLayout:
    cell_width, cell_height = georeference.cell_size(ascii_grid.rows)
    void = ascii_grid.void
    return GridLayout(
        ascii_grid.rows,
        ascii_grid.columns,
        cell_width=cell_width,
        cell_height=cell_height,
        sample=ascii_grid.sample or "f64",
        byte_order="little",
        scale=frame.vertical_unit,
        void=None if void is None or math.isnan(void) else void,
        wraps=georeference.spans_the_globe(ascii_grid.columns),
    )
