"""Where the samples of a TIFF file lie in its map: OGC 19-008r4, requirements on raster to model space.

The file speaks of pixels: whole ones, whose outer corner is raster place (0, 0), or points, where it is the
first sample (GTRasterTypeGeoKey). Either way the place of a sample is the pixel's centre.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from ..frames.map_frame import frame_beside
from ..georeference import Registration
from ..partner_file import file_in_any_case
from .geotiff_frame import Frame
from .geotiff_tags import MODEL_PIXEL_SCALE, MODEL_TIEPOINT, MODEL_TRANSFORMATION, Tags

MAXIMUM_WORLD_FILE = 4096
"""Bytes; a world file has six numbers."""

UPRIGHT = "Turn the raster upright first: gdalwarp old.tif new.tif."


@dataclass(frozen=True)
class Place:
    """The centre of the first sample (after turning) and the steps, in degrees or metres."""

    first_x: float
    first_y: float
    step_x: float
    step_y: float
    is_south_up: bool
    """Whether the file's first row is its southernmost: ``first_y`` is of its last row then."""
    registration: Registration
    is_stated: bool
    """Whether the file, or a world file beside it, says where it lies."""
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Affine:
    """x = x0 + column * dx, y = y0 + row * dy; of raster places, or of centres."""

    x0: float
    y0: float
    dx: float
    dy: float
    of_centres: bool
    notes: tuple[str, ...] = ()


def place_of(tags: Tags, frame: Frame) -> tuple[Frame, Place]:
    """Read the place from the tags, else from a world file, else make one up.

    With it comes the frame that its numbers are meant in: that of the keys; where these state none, that of
    a ``.prj`` file beside the raster, else the one that the numbers may be of.

    Raises:
        DecodeError: a tag cannot be read.
    """
    affine = _from_transformation(tags) or _from_tiepoint(tags) or _from_world_file(tags)
    if affine is None:
        return frame, _made_up()
    points = frame.is_points
    half = 0.0 if points or affine.of_centres else 0.5
    first_x, first_y = affine.x0 + half * affine.dx, affine.y0 + half * affine.dy
    is_south_up = affine.dy > 0.0
    if is_south_up:
        first_y += (tags.tiff.rows - 1) * affine.dy
    step_x, step_y = affine.dx, abs(affine.dy)
    if not frame.is_stated:
        size = tags.tiff.columns, tags.tiff.rows
        frame = frame.taken_from(frame_beside(tags.path, (first_x, first_y), (step_x, step_y), size))
    unit = frame.metres_or_degrees
    place = Place(
        first_x=first_x * unit + frame.prime_meridian,
        first_y=first_y * unit,
        step_x=step_x * unit,
        step_y=step_y * unit,
        is_south_up=is_south_up,
        registration="points" if points else "cells",
        is_stated=True,
        notes=affine.notes,
    )
    return frame, place


def _from_transformation(tags: Tags) -> _Affine | None:
    """Read the matrix of ModelTransformation: 16 numbers, row by row."""
    matrix = tags.finite_numbers(MODEL_TRANSFORMATION)
    if not matrix:
        return None
    if len(matrix) != 16:
        raise tags.wrong("ModelTransformation", f"{len(matrix)} numbers", "16")
    dx, turn_x, x0 = matrix[0], matrix[1], matrix[3]
    turn_y, dy, y0 = matrix[4], matrix[5], matrix[7]
    _check_upright(tags, "ModelTransformation", (dx, turn_x, turn_y, dy))
    return _Affine(x0, y0, dx, dy, of_centres=False)


def _from_tiepoint(tags: Tags) -> _Affine | None:
    """Read ModelTiepoint (raster i, j, k, then model x, y, z) with ModelPixelScale."""
    points, scale = tags.finite_numbers(MODEL_TIEPOINT), tags.finite_numbers(MODEL_PIXEL_SCALE)
    if not points and not scale:
        return None
    if len(points) < 6 or len(points) % 6:
        raise tags.wrong("ModelTiepoint", f"{len(points)} numbers", "6, or a multiple of it")
    if not scale and len(points) > 6:
        raise tags.wrong(
            "ModelPixelScale",
            f"nothing, and {len(points) // 6} control points",
            "one scale for the whole raster",
            "The raster is not fitted to a map yet: gdalwarp old.tif new.tif does so.",
        )
    if len(scale) < 2:
        raise tags.wrong("ModelPixelScale", f"{len(scale)} numbers", "3")
    column, row, _, x, y, _ = points[:6]
    dx, dy = scale[0], -abs(scale[1])
    _check_upright(tags, "ModelPixelScale", (dx, 0.0, 0.0, dy))
    notes = []
    if scale[1] < 0.0:
        notes.append("The scale southward is negative; as GDAL does, it is taken as if it were not.")
    return _Affine(x - column * dx, y - row * dy, dx, dy, of_centres=False, notes=tuple(notes))


def _check_upright(tags: Tags, field: str, affine: tuple[float, float, float, float]) -> None:
    """Refuse rasters that are turned, sheared, mirrored or of no size."""
    dx, turn_x, turn_y, dy = affine
    if dx == 0.0 or dy == 0.0:
        raise tags.wrong(field, f"steps of {dx:g} and {dy:g}", "steps other than 0")
    if max(abs(turn_x), abs(turn_y)) > 1e-9 * min(abs(dx), abs(dy)):
        raise tags.wrong(field, f"a turned or sheared raster ({turn_x:g}, {turn_y:g})", "north up", UPRIGHT)
    if dx < 0.0:
        raise tags.wrong(field, f"columns that run west ({dx:g})", "columns that run east", UPRIGHT)


def _from_world_file(tags: Tags) -> _Affine | None:
    """Read a world file beside the raster: six lines, of the first pixel's centre."""
    path = tags.path
    suffixes = dict.fromkeys((".tfw", f"{path.suffix}w", ".wld"))
    found = (file_in_any_case(path.with_suffix(suffix)) for suffix in suffixes if len(suffix) > 2)
    world = next((file for file in found if file is not None), None)
    if world is None:
        return None
    dx, turn_y, turn_x, dy, x0, y0 = _world_numbers(tags, world)
    _check_upright(tags, world.name, (dx, turn_x, turn_y, dy))
    return _Affine(x0, y0, dx, dy, of_centres=True, notes=(f"Its place is from {world.name}.",))


def _world_numbers(tags: Tags, world: Path) -> Sequence[float]:
    way_out = f"Mend {world.name}, or move it elsewhere."
    try:
        with world.open("rb") as file:
            text = file.read(MAXIMUM_WORLD_FILE).decode("latin-1")
        numbers = [float(line.replace(",", ".")) for line in text.split()]
    except (OSError, ValueError) as error:
        raise tags.wrong(world.name, error, "six numbers", way_out) from error
    if len(numbers) != 6 or not all(map(math.isfinite, numbers)):
        raise tags.wrong(world.name, " ".join(text.split()), "six finite numbers", way_out)
    return numbers


def _made_up() -> Place:
    """Lay the raster on a map of its own."""
    return Place(
        first_x=0.0,
        first_y=0.0,
        step_x=1.0,
        step_y=1.0,
        is_south_up=False,
        registration="points",
        is_stated=False,
        notes=("The file does not say where it lies, nor how wide it is: a metre a sample is assumed.",),
    )
