"""Takes of a scene to files, and files to takes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import bpy

from ..formats import FormatError
from ..terrain.kept import KeptError, is_terrain, recall
from ..terrain.progress import Tell
from ..touch.marking import open_grid
from ..touch.placement import Placement
from .about_properties import OtherTerrainError, check_same_terrain
from .chosen_options import chosen_options
from .files.csv_file import read_csv, write_csv
from .files.derived import derived_columns
from .files.geojson_file import write_geojson
from .files.npz_file import read_npz, write_npz
from .files.read_take import ReadTake
from .ground import Ground
from .kept_take import KeptTakeError, recall_take, take_action
from .take_data import TakeAbout, TakeData
from .terrain_about import terrain_about
from .write_take import Take, write_take

READERS: Mapping[str, Callable[[Path], ReadTake]] = {".csv": read_csv, ".npz": read_npz}

PATH = ".geojson"

SUFFIXES = (*READERS, PATH)


def export_take(take: bpy.types.Object, path: Path, tell: Tell) -> tuple[TakeData, str]:
    """Write a take in the format that the path's ending names.

    Returns:
        What was written, and a sentence on what is missing in it; empty where nothing is.

    Raises:
        KeptTakeError: the take has no ticks.
        ValueError: no format has this ending; or (``NoPlaceError``) the take has no place on its body.
        OSError: it cannot be written.
    """
    action = take_action(take)
    if action is None:
        raise KeptTakeError(f"{take.name} is no take.")
    data = recall_take(action)
    suffix = path.suffix.lower()
    if suffix == PATH:
        write_geojson(path, data)
        return data, ""
    if suffix not in READERS:
        raise ValueError(f"{path.name}: a take is exported as {', '.join(SUFFIXES)}.")
    ground = _ground_of(data.about)
    derived = derived_columns(data, None if ground is None else ground.real)
    if suffix == ".csv":
        write_csv(path, data, derived, tell)
    else:
        write_npz(path, data, derived)
    missing = (
        f"Without ground elevations: {data.about.terrain} is not here any more." if ground is None else ""
    )
    return data, missing


def import_take(
    scene: bpy.types.Scene, terrain: bpy.types.Object, path: Path, tell: Tell
) -> tuple[Take, tuple[str, ...]]:
    """Write a take from a file into the scene, from its current frame on, as the settings say.

    Returns:
        The take, and what a person should know of the file.

    Raises:
        FormatError: the file, or the terrain's, cannot be used.
        KeptError: the terrain does not remember its grid.
        KeptTakeError, OtherTerrainError: the take does not belong on this terrain, or to the chosen take.
        OSError: it cannot be read.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise FormatError(
            path,
            "ending",
            found=path.suffix or "none",
            expected=" or ".join(READERS),
            way_out="Choose a take that was exported as CSV or NPZ.",
        )
    found = reader(path)
    kept = recall(terrain)
    check_same_terrain(found.data.about, terrain_about(terrain.name, kept))
    grid = open_grid(terrain, kept)
    ground = Ground.of(grid, kept)
    placement = Placement.of(terrain, kept.frame)
    options = chosen_options(scene, scene.frame_current)
    return write_take(scene, found.data, placement, ground, options, tell), found.notes


def _ground_of(about: TakeAbout) -> Ground | None:
    """Open the grid that a take was felt on; ``None`` where it is gone, or another now."""
    for terrain in filter(is_terrain, bpy.data.objects):
        try:
            kept = recall(terrain)
            check_same_terrain(about, terrain_about(terrain.name, kept))
            grid = open_grid(terrain, kept)
        except (KeptError, OtherTerrainError, FormatError):
            continue
        return Ground.of(grid, kept)
    return None
