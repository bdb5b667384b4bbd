"""From a grid file to a terrain object."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

import bpy
import numpy as np

from ..formats import ElevationGrid, FormatError, read_grid
from .frame import TerrainFrame, fitting_scale, rounded_exaggeration, terrain_frame
from .kept import KeptTerrain, keep
from .material import HYPSOMETRIC, Ramp, ramp_material
from .mesh import ELEVATION, preview_mesh
from .preview import VERTEX_BUDGET, PreviewSurface, preview_cells, preview_surface
from .progress import Tell, progress
from .select import select_only
from .undone import undone_on_failure

SHARES_DONE = {"header": 0.05, "range": 0.6, "samples": 0.8}
"""Of an import, by its usual times: after the label, the scan of the whole grid, and the shown samples."""

COLOURED = (1.0, 99.0)
"""Percentiles of the shown heights at the ends of the colour ramp."""


class SceneScale(StrEnum):
    """What a Blender unit stands for."""

    FIT = "FIT"
    METRE = "METRE"
    KILOMETRE = "KILOMETRE"


@dataclass(frozen=True)
class ImportOptions:
    """A person's choices."""

    vertex_budget: int = VERTEX_BUDGET
    scale: SceneScale = SceneScale.FIT
    exaggeration: float = 0.0
    """Of heights; 0 chooses."""


def import_terrain(context: bpy.types.Context, path: Path, options: ImportOptions) -> bpy.types.Object:
    """Make a terrain object and put it into the scene; a failure leaves nothing there.

    Raises:
        FormatError: the file cannot be used.
    """
    with progress(context) as tell, undone_on_failure():
        return _import(context, path.absolute(), options, tell)


def _import(context: bpy.types.Context, path: Path, options: ImportOptions, tell: Tell) -> bpy.types.Object:
    grid = read_grid(path)
    samples = grid.open()
    tell(SHARES_DONE["header"])
    extent = samples.range()
    tell(SHARES_DONE["range"])
    if extent is None:
        raise FormatError(
            grid.data_path,
            "samples",
            found="no data in any of them",
            expected="at least one elevation",
            way_out="Check the label's MISSING_CONSTANT, or choose another grid.",
        )
    frame = _frame(grid, extent.minimum, extent.maximum, options)
    surface = preview_surface(samples, preview_cells(grid.layout, options.vertex_budget))
    tell(SHARES_DONE["samples"])
    kept = KeptTerrain(grid, frame, options.vertex_budget, extent.minimum, extent.maximum)
    return _add_object(context, kept, surface)


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


def _ramp(surface: PreviewSurface) -> Ramp:
    """Spend the colours on the heights that most of the land has; a few peaks would take most of them."""
    shown = surface.heights[np.isfinite(surface.heights)]
    low, high = np.percentile(shown, COLOURED) if shown.size else (0.0, 1.0)
    return Ramp(ELEVATION, float(low), float(high), HYPSOMETRIC)


def _add_object(context: bpy.types.Context, kept: KeptTerrain, surface: PreviewSurface) -> bpy.types.Object:
    title = kept.grid.title
    mesh = preview_mesh(title, surface, kept.frame)
    mesh.materials.append(ramp_material(f"{title} heights", _ramp(surface)))
    terrain = bpy.data.objects.new(title, mesh)
    keep(terrain, kept)
    context.collection.objects.link(terrain)
    select_only(context, terrain)
    return terrain
