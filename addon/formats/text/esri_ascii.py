"""Esri ASCII grids (``.asc``): a short header and heights as text; a ``.prj`` beside them says where.

Source: Esri, "ArcGIS Pro: Esri ASCII raster format".
"""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path

from proxygraph import EsriAscii, GridError, GridLayout, Progress

from ..decoding import Decoding
from ..elevation_grid import ElevationGrid
from ..frames.map_frame import MapFrame, frame_beside
from ..georeference import Georeference
from ..native_refusal import native_refusal
from ..refusal import refusal

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
    georeference, frame = _georeference(path, ascii_grid)
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
        range=_range(ascii_grid, frame.vertical_unit),
        voids=ascii_grid.voids,
    )


def _range(ascii_grid: EsriAscii, metres: float) -> tuple[float, float] | None:
    """Metres."""
    if ascii_grid.range is None:
        return None
    lowest, highest = ascii_grid.range
    return lowest * metres, highest * metres


def _georeference(path: Path, ascii_grid: EsriAscii) -> tuple[Georeference, MapFrame]:
    """Place the north-west sample: the header has the lower left corner, or its cell's centre."""
    (x, y), (step_x, step_y) = ascii_grid.corner, ascii_grid.step
    x_is_center, y_is_center = ascii_grid.corner_is_center
    first_x = x if x_is_center else x + step_x / 2.0
    south = y if y_is_center else y + step_y / 2.0
    first_y = south + (ascii_grid.rows - 1) * step_y
    size = (ascii_grid.columns, ascii_grid.rows)
    frame = frame_beside(path, (first_x, first_y), (step_x, step_y), size)
    return frame.georeference(first_x, first_y, step_x, step_y, "cells", partial(refusal, path), size), frame


def _layout(ascii_grid: EsriAscii, georeference: Georeference, frame: MapFrame) -> GridLayout:
    cell_width, cell_height = georeference.cell_size(ascii_grid.rows, ascii_grid.columns)
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
