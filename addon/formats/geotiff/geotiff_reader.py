"""GeoTIFF: heights in a TIFF file that says where on its body they lie.

Format: "OGC GeoTIFF Standard" 1.1 (OGC 19-008r4) for the georeference; the tags GDAL_METADATA (42112) and
GDAL_NODATA (42113) as the documentation of GDAL's GTiff driver describes them. Strips, tiles and compressions
are undone by ``proxygraph.GeoTiff``.
"""

from __future__ import annotations

import math
from pathlib import Path

from proxygraph import DecodeError, GeoTiff, GridError, GridLayout

from ..decoding import Decoding
from ..elevation_grid import ElevationGrid
from ..format_error import FormatError
from ..frames.map_place import check_place
from ..georeference import Georeference
from ..projections import Unknown
from .geotiff_frame import Frame, frame_of
from .geotiff_nodata import stated_void, unstated_void, void_written_short
from .geotiff_place import Place, place_of
from .geotiff_tags import Tags
from .geotiff_values import Values, values_of

CONVERT = (
    "Convert the file to one that can be read: gdal_translate -co COMPRESS=DEFLATE old.tif new.tif, "
    "or the same with rasterio."
)
REPAIR = "Download or export the file again, or look at it with gdalinfo."

WAYS_OUT = {
    "TIFF header": "This is no TIFF file, whatever its name says: choose the file that holds the heights.",
    "Compression": CONVERT,
    "Predictor": CONVERT,
    "BitsPerSample": "Convert the heights: gdal_translate -ot Float32 old.tif new.tif.",
    "FillOrder": CONVERT,
    "file": "Choose the file itself.",
}
"""By the field that cannot be used; whatever else is wrong, the file is damaged."""


def read_geotiff(path: Path) -> ElevationGrid:
    """Read what a TIFF file says of itself.

    Samples are looked at only where the file does not say which value is no height.
    """
    try:
        tiff = GeoTiff.open(path)
        tags = Tags(path, tiff)
        frame, place = place_of(tags, frame_of(tags))
        values = values_of(tags, frame)
    except DecodeError as error:
        raise refused(path, error) from error
    except OSError as error:
        raise FormatError(
            path,
            "file",
            found=error.strerror or str(error),
            expected="a readable file",
            way_out="Check its path and its permissions.",
        ) from error
    georeference = _georeference(frame, place, values).closed(tiff.columns)
    check_place(georeference, tiff.rows, tiff.columns, lambda *what: tags.wrong(*what[:3]))
    layout, decoding, notes = _samples(tags, georeference, place, values)
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=layout,
        georeference=georeference,
        title=path.stem,
        format="GeoTIFF" if place.is_stated else "TIFF without georeference",
        synthetic="synthetic" in frame.citation.lower(),
        decoding=decoding,
        notes=(*_notes_on_bands(tiff), *frame.notes, *place.notes, *values.notes, *notes),
    )


def refused(path: Path, error: DecodeError) -> FormatError:
    """Say what the decoder found, with a way out."""
    field, found, expected = error.args
    return FormatError(path, field, found=found, expected=expected, way_out=WAYS_OUT.get(field, REPAIR))


def _georeference(frame: Frame, place: Place, values: Values) -> Georeference:
    return Georeference(
        body=frame.body,
        ellipsoid=frame.ellipsoid,
        projection=frame.projection if place.is_stated else Unknown(),
        first_x=place.first_x,
        first_y=place.first_y,
        step_x=place.step_x,
        step_y=place.step_y,
        vertical_reference=frame.vertical_reference,
        vertical_unit=values.unit,
        latitude_kind="planetocentric" if frame.ellipsoid.is_sphere else "planetographic",
        registration=place.registration,
        frame=frame.name,
    )


def _samples(
    tags: Tags, georeference: Georeference, place: Place, values: Values
) -> tuple[GridLayout, Decoding | None, list[str]]:
    """Say where the samples lie, or how they are decoded, and which value is no height."""
    tiff = tags.tiff
    void, notes = stated_void(tags)
    in_place = None if place.is_south_up else tiff.in_place
    # What the file leaves out is no sample to look at: it is filled with the void value only afterwards.
    looked_at = _decoding(place, None) if in_place is None else None
    try:
        layout = _layout(tags, georeference, values, in_place, void)
        fill = stated = void
        if void is not None:
            fill = void = void_written_short(tags.path, tags, layout, looked_at, void)
        elif not notes:
            void, notes = unstated_void(tags.path, tiff, layout, looked_at)
        if void != stated:
            layout = _layout(tags, georeference, values, in_place, void)
    except (GridError, OverflowError) as error:
        if isinstance(error, DecodeError):
            raise refused(tags.path, error) from error
        raise tags.wrong("size and values", error, "a grid that can be touched", REPAIR) from error
    return layout, None if in_place else _decoding(place, fill), notes


def _decoding(place: Place, void: float | None) -> Decoding:
    fill = 0.0 if void is None else void
    return Decoding("geotiff", options={"south_up": place.is_south_up, "fill": fill})


def _layout(
    tags: Tags,
    georeference: Georeference,
    values: Values,
    in_place: tuple[int, int] | None,
    void: float | None,
) -> GridLayout:
    tiff = tags.tiff
    cell_width, cell_height = georeference.cell_size(tiff.rows, tiff.columns)
    offset, row_stride = in_place or (0, None)
    return GridLayout(
        tiff.rows,
        tiff.columns,
        cell_width=cell_width,
        cell_height=cell_height,
        sample=tiff.sample,
        byte_order=tiff.byte_order if in_place else "little",
        offset=offset,
        row_stride=row_stride,
        scale=values.scale,
        value_offset=values.offset,
        void=None if void is None or math.isnan(void) else void,
        wraps=georeference.spans_the_globe(tiff.columns),
    )


def _notes_on_bands(tiff: GeoTiff) -> list[str]:
    notes = []
    if tiff.bands > 1:
        notes.append(f"The first of {tiff.bands} bands is taken for heights.")
    if tiff.photometric == 2:
        notes.append("The file is a picture in red, green and blue: what is red is taken for high.")
    elif tiff.photometric == 3:
        notes.append(
            "The file is a picture with a colour table: the numbers of its colours are taken for heights."
        )
    return notes
