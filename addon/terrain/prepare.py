"""From a grid file to everything that its terrain object shows, in any thread: Blender is not touched."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
from proxygraph import Grid, Progress

from ..formats import ElevationGrid, FormatError, HgtPosition, read_grid
from ..formats.source_stamp import SourceStamp
from .byte_size import in_bytes
from .chosen_region import cut_grid
from .filling import copy_bytes, filled, working_bytes
from .frame import TerrainFrame, fitting_scale, rounded_exaggeration, terrain_frame
from .kept import KeptTerrain
from .options import ImportOptions, SceneScale
from .preview import PreviewSurface, preview_cells, preview_surface, with_filled
from .slope import slopes
from .whole import refuse_damaged
from .work import Work


@dataclass(frozen=True)
class Prepared:
    """A terrain object in the making."""

    kept: KeptTerrain
    samples: Grid
    surface: PreviewSurface
    slopes: npt.NDArray[np.float64]
    """Degrees at the shown samples, rows x columns."""


def read_header(path: Path, options: ImportOptions, progress: Progress | None = None) -> ElevationGrid:
    """What a file describes, as far as it is wanted.

    Raises:
        FormatError: the file cannot be used, or has no such region.
        CancelledError: ``progress`` was asked to end.
    """
    place = options.position
    position = None if place is None else HgtPosition(latitude=place[0], longitude=place[1])
    return cut_grid(read_grid(path, position, progress), options.region)


def prepare(path: Path, options: ImportOptions, work: Work) -> Prepared:
    """Read, decode, fill, measure and choose what is shown.

    Raises:
        FormatError: the file cannot be used, or was cut while it was read.
        CancelledError: the work was asked to end.
    """
    grid = read_header(path.absolute(), options, work.begin("Reading the header", until=0.05))
    stamp = _stamp(grid)
    raw = grid.open(work.begin("Decoding" if grid.decoding else "Opening", until=0.5))
    samples = filled(grid, raw, work.begin(_filling(grid), until=0.7)) if options.fill_voids else raw
    work.begin("Measuring", until=0.8)
    extent = samples.range()
    refuse_damaged(grid, raw)
    if extent is None:
        raise FormatError(
            grid.data_path,
            "samples",
            found="no data in any of them",
            expected="at least one elevation",
            way_out="Check the value that the header has for missing data (MISSING_CONSTANT, NODATA), or "
            "choose another grid or region.",
        )
    work.begin("Choosing what to show", until=1.0)
    frame = _frame(grid, extent.minimum, extent.maximum, options)
    surface = preview_surface(samples, preview_cells(grid.layout, options.vertex_budget))
    if options.fill_voids:
        surface = with_filled(surface, raw)
    kept = KeptTerrain(
        grid,
        frame,
        options.vertex_budget,
        extent.minimum,
        extent.maximum,
        filled=options.fill_voids,
        stamp=stamp,
        region=options.region,
        position=options.position,
    )
    steepness = slopes(samples, surface)
    refuse_damaged(grid, raw)
    return Prepared(kept, samples, surface, steepness)


def _filling(grid: ElevationGrid) -> str:
    """The step in words: it may take much more memory than anything else."""
    meanwhile = copy_bytes(grid.layout) + working_bytes(grid.layout)
    return f"Filling voids in a copy, {in_bytes(meanwhile)} meanwhile"


def _stamp(grid: ElevationGrid) -> SourceStamp | None:
    try:
        return SourceStamp.of(grid.data_path)
    except OSError:
        return None  # opening it says what is wrong


def _frame(grid: ElevationGrid, minimum: float, maximum: float, options: ImportOptions) -> TerrainFrame:
    units_per_metre = {
        SceneScale.FIT: fitting_scale(grid.layout),
        SceneScale.METRE: 1.0,
        SceneScale.KILOMETRE: 0.001,
    }[options.scale]
    exaggeration = options.exaggeration or rounded_exaggeration(grid.layout, minimum, maximum)
    return terrain_frame(
        grid.layout, minimum, maximum, units_per_metre=units_per_metre, exaggeration=exaggeration
    )
