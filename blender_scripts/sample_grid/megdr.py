"""Writing elevations as MOLA's gridded products are written: a PDS3 label beside a raw image."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sample_grid.sphere import RADIUS_KM

_LABEL = """\
PDS_VERSION_ID                = PDS3
/* SYNTHETIC TERRAIN: made by Haptic Terrain's blender_scripts/make_sample_grid.py. */
/* No such planet exists; the fields are those of a MOLA MEGDR topography product.  */
RECORD_TYPE                   = FIXED_LENGTH
FILE_RECORDS                  = {rows}
RECORD_BYTES                  = {record_bytes}
^IMAGE                        = "{image}"
DATA_SET_ID                   = "HAPTIC_TERRAIN_SYNTHETIC"
PRODUCT_ID                    = "HAPTIC_TERRAIN_SYNTHETIC"
SPACECRAFT_NAME               = "N/A"
INSTRUMENT_ID                 = "N/A"
TARGET_NAME                   = "SYNTHETIC PLANET"
OBJECT                        = IMAGE
    NAME                      = MEDIAN_TOPOGRAPHY
    LINES                     = {rows}
    LINE_SAMPLES              = {columns}
    SAMPLE_TYPE               = MSB_INTEGER
    SAMPLE_BITS               = 16
    UNIT                      = METER
    SCALING_FACTOR            = 1
    OFFSET                    = 0
END_OBJECT                    = IMAGE
OBJECT                        = IMAGE_MAP_PROJECTION
    MAP_PROJECTION_TYPE       = "SIMPLE CYLINDRICAL"
    MAP_RESOLUTION            = {per_degree:.1f} <PIXEL/DEGREE>
    A_AXIS_RADIUS             = {radius:.1f} <KM>
    B_AXIS_RADIUS             = {radius:.1f} <KM>
    C_AXIS_RADIUS             = {radius:.1f} <KM>
    FIRST_STANDARD_PARALLEL   = 'N/A'
    SECOND_STANDARD_PARALLEL  = 'N/A'
    POSITIVE_LONGITUDE_DIRECTION = "EAST"
    CENTER_LATITUDE           = 0.0 <DEGREE>
    CENTER_LONGITUDE          = 180.0 <DEGREE>
    REFERENCE_LATITUDE        = 'N/A'
    REFERENCE_LONGITUDE       = 'N/A'
    LINE_FIRST_PIXEL          = 1
    LINE_LAST_PIXEL           = {rows}
    SAMPLE_FIRST_PIXEL        = 1
    SAMPLE_LAST_PIXEL         = {columns}
    MAP_PROJECTION_ROTATION   = 0.0
    MAP_SCALE                 = {scale:.3f} <KM/PIXEL>
    MAXIMUM_LATITUDE          = 90 <DEGREE>
    MINIMUM_LATITUDE          = -90 <DEGREE>
    WESTERNMOST_LONGITUDE     = 0 <DEGREE>
    EASTERNMOST_LONGITUDE     = 360 <DEGREE>
    LINE_PROJECTION_OFFSET    = {line_offset:.1f}
    SAMPLE_PROJECTION_OFFSET  = {sample_offset:.1f}
    COORDINATE_SYSTEM_TYPE    = "BODY-FIXED ROTATING"
    COORDINATE_SYSTEM_NAME    = "PLANETOCENTRIC"
END_OBJECT                    = IMAGE_MAP_PROJECTION
END
"""


def label_text(rows: int, columns: int, image: str) -> str:
    """The label of a global grid, with the line ends that PDS3 demands."""
    per_degree = rows / 180.0
    text = _LABEL.format(
        rows=rows,
        columns=columns,
        record_bytes=2 * columns,
        image=image.upper(),
        per_degree=per_degree,
        radius=RADIUS_KM,
        # The circumference over the number of columns.
        scale=2.0 * 3.141592653589793 * RADIUS_KM / columns,
        line_offset=rows / 2.0 + 0.5,
        sample_offset=columns / 2.0 + 0.5,
    )
    return text.replace("\n", "\r\n")


def write_pair(folder: Path, name: str, elevation: NDArray[np.int16]) -> Path:
    """Write ``name.img`` and ``name.lbl``; gives the label's path.

    The label comes last and each file appears whole: a label never names a half-written image.
    """
    rows, columns = elevation.shape
    folder.mkdir(parents=True, exist_ok=True)
    image = folder / f"{name}.img"
    label = folder / f"{name}.lbl"
    for path, content in (
        (image, elevation.astype(">i2").tobytes()),
        (label, label_text(rows, columns, image.name).encode("ascii")),
    ):
        part = path.with_suffix(path.suffix + ".part")
        part.write_bytes(content)
        part.replace(path)
    return label
