"""A terrain object that gets another preview of its grid: object, place, name and materials stay."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import cast

import bpy
import numpy as np
import numpy.typing as npt
from proxygraph import GridLayout

from ..formats import FormatError
from ..formats.partner_file import is_file
from .bend import Bend
from .frame import fitting_scale
from .job import Job
from .kept import KeptError, KeptTerrain, is_terrain, keep, keep_frame, recall
from .mesh import ELEVATION, preview_mesh
from .opened import OpenedGrids
from .options import ImportOptions, SceneScale
from .prepare import Prepared, prepare, read_header
from .work import Tell, Work


def options_of(kept: KeptTerrain) -> ImportOptions:
    """As it was imported, and as it is shown now."""
    scale = {1.0: SceneScale.METRE, 0.001: SceneScale.KILOMETRE}.get(kept.frame.units_per_metre)
    return ImportOptions(
        vertex_budget=kept.vertex_budget,
        scale=scale or SceneScale.FIT,
        exaggeration=kept.frame.exaggeration,
        region=kept.region,
        fill_voids=kept.filled,
        position=kept.position,
    )


def header_of(kept: KeptTerrain) -> Path:
    """The file that describes the grid: where it was, else beside the data file, which may have moved.

    Raises:
        FormatError: it is in neither place.
    """
    moved = kept.grid.data_path.with_name(kept.grid.path.name)
    for path in (kept.grid.path, moved):
        if is_file(path):
            return path
    raise FormatError(
        kept.grid.path,
        "file",
        found="no such file",
        expected="the grid that was imported",
        way_out="Use Relink to say where it is now.",
    )


class RebuildJob(Job):
    """Reads a terrain's file again; ``finish`` then shows it."""

    def __init__(self, terrain: bpy.types.Object, options: ImportOptions, tell: Tell | None = None) -> None:
        """Raises KeptError or FormatError where the terrain or its file is not what it was."""
        super().__init__(terrain.name, tell)
        self._terrain = terrain.session_uid
        self._before = recall(terrain)
        self._path = header_of(self._before)
        self._options = options
        self._prepared: Prepared | None = None

    def do(self, work: Work) -> None:
        """Prepare the new preview."""
        self._prepared = prepare(self._path, self._options, work)

    def finish(self, opened: OpenedGrids) -> bpy.types.Object:
        """Give the object its new mesh.

        Raises:
            CancelledError: it was cancelled.
            FormatError: the file cannot be used; the object is as it was.
            KeptError: the object has gone meanwhile.
        """
        self.check()
        prepared = self._prepared
        terrain = next((thing for thing in bpy.data.objects if thing.session_uid == self._terrain), None)
        if terrain is None or prepared is None:
            raise KeptError("The terrain is gone: undo, or import the grid again.")
        kept = _shown_as(prepared.kept, self._before)
        _swap_mesh(terrain, replace(prepared, kept=kept))
        keep(terrain, kept)
        opened.add(kept, prepared.samples)
        return terrain


def relink(terrain: bpy.types.Object, path: Path) -> None:
    """Note that the grid's files are elsewhere now; they must be the same ones.

    Raises:
        FormatError: it is another grid.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(terrain)
    found = read_header(path.absolute(), options_of(kept))
    if kept.stamp is not None:
        kept.stamp.check(found.data_path)
    if found.layout != kept.grid.layout:
        raise FormatError(
            path,
            "layout",
            found=_size(found.layout),
            expected=_size(kept.grid.layout),
            way_out="This is another grid: import it.",
        )
    keep(terrain, replace(kept, grid=replace(kept.grid, path=found.path, data_path=found.data_path)))


def _size(layout: GridLayout) -> str:
    return f"{layout.columns:,} x {layout.rows:,} samples of {layout.sample}"


def exaggerate(terrain: bpy.types.Object, exaggeration: float) -> None:
    """Show and feel heights otherwise, at once and without the grid's file: every vertex knows its elevation.

    Raises:
        KeptError: the terrain does not remember its grid, or its mesh is being edited.
    """
    frame = recall(terrain).frame
    new = replace(frame, exaggeration=exaggeration)
    mesh = terrain.data
    if isinstance(mesh, bpy.types.Mesh) and mesh.is_editmode:  # what is edited knows no elevations
        raise KeptError(f"{terrain.name} is in Edit Mode: leave that to change its heights.")
    elevations = mesh.attributes.get(ELEVATION) if isinstance(mesh, bpy.types.Mesh) else None
    if elevations is not None and len(elevations.data) == len(mesh.vertices) > 0:
        heights = np.empty(len(mesh.vertices), dtype=np.float32)
        elevations.data.foreach_get("value", heights)
        positions = np.empty((len(heights), 3), dtype=np.float32)
        mesh.attributes["position"].data.foreach_get("vector", positions.ravel())
        up = heights.astype(np.float64) - frame.up
        if frame.bend is None:
            positions[:, 2] = up * (new.units_per_metre * exaggeration)
        else:
            _move_out(positions, frame.bend, up, frame.exaggeration, new.exaggeration, frame.units_per_metre)
        mesh.attributes["position"].data.foreach_set("vector", positions.ravel())
        mesh.update()
    for other in _showing(terrain):
        keep_frame(other, replace(recall(other).frame, exaggeration=exaggeration))


def _showing(terrain: bpy.types.Object) -> list[bpy.types.Object]:
    """The terrains that show the same mesh: linked duplicates have one between them."""
    return [thing for thing in bpy.data.objects if thing.data == terrain.data and is_terrain(thing)]


def _move_out(
    positions: npt.NDArray[np.float32],
    bend: Bend,
    up: npt.NDArray[np.float64],
    before: float,
    after: float,
    units_per_metre: float,
) -> None:
    """Put places on a sphere nearer to its centre or further away: their directions stay."""
    centre = np.array((0.0, 0.0, -bend.radius * units_per_metre))
    away = (bend.radius + up * after) / (bend.radius + up * before)
    positions[:] = centre + (positions - centre) * away[:, None]


def _shown_as(kept: KeptTerrain, before: KeptTerrain) -> KeptTerrain:
    """Bent where it was bent; and of its old size where that was neither fitted nor a round one."""
    frame = kept.frame
    if before.frame.bend is not None:
        bend = Bend.of(kept.grid.georeference, kept.grid.layout.rows)
        frame = replace(frame, bend=bend if bend.radius > 0.0 else None)
    if before.grid.layout == kept.grid.layout or before.frame.units_per_metre != fitting_scale(
        before.grid.layout
    ):
        frame = replace(frame, units_per_metre=before.frame.units_per_metre)
    return replace(kept, frame=frame)


def _swap_mesh(terrain: bpy.types.Object, prepared: Prepared) -> None:
    """A new mesh with the old one's materials and name, which other users of the old one do not get."""
    old = cast("bpy.types.Mesh", terrain.data)
    mesh = preview_mesh(old.name, prepared.surface, prepared.kept.frame, prepared.slopes)
    for material in old.materials:
        mesh.materials.append(material)
    terrain.data = mesh
    if old.users == 0:
        name = old.name
        bpy.data.meshes.remove(old)
        mesh.name = name
