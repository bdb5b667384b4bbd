"""What is known of a file before it is imported, in words."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from ..formats import SUFFIXES, ElevationGrid, FormatError
from ..formats.cache import cache
from ..formats.partner_file import is_file
from ..terrain.byte_size import in_bytes
from ..terrain.chosen_region import ChosenRegion, cut_grid
from ..terrain.filling import copy_bytes, working_bytes
from ..terrain.options import ImportOptions
from ..terrain.prepare import read_header
from ..terrain.preview import preview_cells
from ..terrain.whole import refuse_damaged
from .wrapped import wrapped

DIALOG_LETTERS = 48
"""That a line of the dialog holds."""

MOST_SCANNED = 4_000_000
"""Samples that are looked through for their range while a dialog is drawn: some hundredths of a second."""

NO_DATA = "No data in any sample"


@dataclass(frozen=True)
class Extremes:
    """What a look at all samples found."""

    minimum: float
    maximum: float
    voids: int


def described(path: Path, options: ImportOptions) -> list[str]:
    """Describe a file from its header, and by its samples where they are quickly looked through."""
    if not is_file(path):
        return ["Choose an elevation grid, or its label or header"]
    try:
        grid = _grid(path, options)
    except FormatError as error:
        return wrapped(str(error), DIALOG_LETTERS)
    layout = grid.layout
    shown = preview_cells(layout, options.vertex_budget)
    found = _extremes(path, options, grid)
    all_shown = options.fill_voids or (isinstance(found, Extremes) and found.voids == 0)
    lines = [
        grid.title,
        grid.format,
        f"{layout.columns:,} x {layout.rows:,} = {grid.samples:,} samples to touch",
        f"Cells of {in_metres(layout.cell_width)} x {in_metres(layout.cell_height)} m",
        *_extremes_lines(found),
        f"Memory: {memory(grid)}",
        *([f"Filling: {filling_memory(grid)}"] if options.fill_voids else []),
        f"{shown.vertices:,} vertices to see{'' if all_shown else ' at the most'}",
    ]
    return lines + [line for note in grid.notes for line in wrapped(note, DIALOG_LETTERS)]


def is_unplaced(path: Path, options: ImportOptions) -> bool:
    """Whether a file is an SRTM square that does not say where it lies."""
    if not is_file(path):
        return False
    try:
        grid = _grid(path, replace(options, position=None, region=None))
    except FormatError:
        return False
    return grid.format.startswith("SRTM") and bool(grid.notes)


def memory(grid: ElevationGrid) -> str:
    """What the samples need as they are opened."""
    if grid.decoding is None:
        return "in place, nothing copied"
    size = grid.layout.byte_length
    where = "in a cache file" if size > cache.most_in_memory else "decoded"
    return f"{in_bytes(size)} {where}"


def filling_memory(grid: ElevationGrid) -> str:
    """What filling voids needs besides: a copy that is touched, and more until that is made."""
    copy, working = copy_bytes(grid.layout), working_bytes(grid.layout)
    return f"a copy of {in_bytes(copy)}, {in_bytes(working)} meanwhile"


def in_metres(length: float) -> str:
    """A cell's side for people."""
    return f"{length:,.0f}" if length >= 1000.0 else f"{length:.4g}"


def _extremes(path: Path, options: ImportOptions, grid: ElevationGrid) -> Extremes | str:
    """What a quick look at the samples finds, or in words why there is nothing to tell."""
    if grid.voids is not None:  # the reader has looked already
        return NO_DATA if grid.range is None else Extremes(*grid.range, grid.voids)
    if grid.decoding is not None or grid.samples > MOST_SCANNED:
        return "Range and voids: known when it is read"
    found = _cached_extremes(path, options.position, options.region, _ages(path))
    if isinstance(found, FormatError):
        return str(found)
    return NO_DATA if found is None else found


def _extremes_lines(found: Extremes | str) -> list[str]:
    if isinstance(found, str):
        return wrapped(found, DIALOG_LETTERS)
    return [f"{found.minimum:,.0f} to {found.maximum:,.0f} m, {_voids(found.voids)}"]


def _voids(count: int) -> str:
    return {0: "no voids", 1: "1 void"}.get(count, f"{count:,} voids")


def _grid(path: Path, options: ImportOptions) -> ElevationGrid:
    """The part of the grid that is wanted, from its header.

    Raises:
        FormatError: the file cannot be used, or has no such part.
    """
    ages = _ages(path)
    if options.region is None:
        found = _cached_grid(path, options.position, ages)
    else:
        found = _cached_part(path, options.position, options.region, ages)
    if isinstance(found, FormatError):
        raise found
    return found


@lru_cache(maxsize=2)
def _cached_grid(
    path: Path, position: tuple[float, float] | None, _ages: tuple[int, ...]
) -> ElevationGrid | FormatError:
    """Remember the last headers, also one that is refused: the file browser asks each time it is drawn.

    Always of the whole grid: one of text is looked through, which need not be done for every other region.
    """
    try:
        return read_header(path, ImportOptions(position=position))
    except FormatError as error:
        return error


@lru_cache(maxsize=2)
def _cached_part(
    path: Path, position: tuple[float, float] | None, region: ChosenRegion, ages: tuple[int, ...]
) -> ElevationGrid | FormatError:
    """Remember the last parts: to find one on a map in metres takes some thousand places."""
    whole = _cached_grid(path, position, ages)
    if isinstance(whole, FormatError):
        return whole
    try:
        return cut_grid(whole, region)
    except FormatError as error:
        return error


@lru_cache(maxsize=2)
def _cached_extremes(
    path: Path,
    position: tuple[float, float] | None,
    region: ChosenRegion | None,
    _ages: tuple[int, ...],
) -> Extremes | FormatError | None:
    """Remember the last scans; ``None`` where there is no height at all."""
    try:
        grid = _grid(path, ImportOptions(position=position, region=region))
        samples = grid.open()
        found = samples.range()
        refuse_damaged(grid, samples)
    except FormatError as error:
        return error
    return None if found is None else Extremes(found.minimum, found.maximum, found.voids)


def _ages(path: Path) -> tuple[int, ...]:
    """When the file, its partners and their folder were changed: what was refused may have been mended."""
    ages = []
    for place in (path, path.parent, *(path.with_suffix(suffix) for suffix in SUFFIXES)):
        try:
            ages.append(place.stat().st_mtime_ns)
        except OSError:
            ages.append(0)
    return tuple(ages)
