"""Writing a take that a crash left on the disk."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import bpy
from proxygraph import Take as FeltTake

from ..formats import FormatError
from ..terrain.kept import KeptError, KeptTerrain, is_terrain, recall
from ..terrain.opening import open_shown
from ..terrain.progress import progress
from ..terrain.undone import undone_on_failure
from ..touch.live import live
from ..touch.placement import Placement
from ..touch.recorder import TakeColumns
from .about_properties import OtherTerrainError, check_same_terrain
from .chosen_options import chosen_options
from .ground import Ground
from .pre_roll_frames import first_frame
from .recording import RecordingError
from .spool_text import from_spool_text
from .spools import left_takes
from .take_data import TakeAbout, TakeData
from .terrain_about import terrain_about
from .write_take import Take, write_take


@dataclass(frozen=True)
class Recovered:
    """A take that was brought back."""

    written: Take
    lost: str | None
    """What of its file could not be read, in words."""


@dataclass(frozen=True)
class _Left:
    """A take that can be written."""

    data: TakeData
    placement: Placement
    ground: Ground
    first_frame: int


def recover_take(context: bpy.types.Context) -> Recovered:
    """Write the newest take that was left of a terrain in the scene, and remove its file.

    Raises:
        RecordingError: there is none, or it cannot be written here; then its file stays.
    """
    scene = context.scene
    if scene is None:
        raise RecordingError("No scene is open.")
    refused: list[str] = []
    for path, felt in left_takes(live.spool_folder, refused) if live.spool_folder is not None else ():
        try:
            left = _left(scene, path, felt)
        except RecordingError as error:
            felt.release_spool()
            refused.append(str(error))
            continue
        return Recovered(_written(context, scene, left, felt), felt.lost)
    raise RecordingError(" ".join(refused or ["There is no take to recover."]))


def _written(context: bpy.types.Context, scene: bpy.types.Scene, left: _Left, felt: FeltTake) -> Take:
    # Always a take of its own: what was lost is not mixed with what is there.
    options = replace(chosen_options(scene, left.first_frame), onto=None)
    try:
        with progress(context) as tell, undone_on_failure():
            written = write_take(scene, left.data, left.placement, left.ground, options, tell)
    except BaseException:
        felt.release_spool()  # to be recovered again
        raise
    try:
        felt.discard_spool()
    except OSError as error:
        raise RecordingError(f"The take was recovered, but its file cannot be removed: {error}") from error
    return written


def _left(scene: bpy.types.Scene, path: Path, felt: FeltTake) -> _Left:
    """Find what a take needs to be written."""
    try:
        about, asked_at = from_spool_text(felt.about)
    except ValueError as error:
        raise RecordingError(f"{path}: the text about the take cannot be used ({error}).") from error
    terrain, kept = _terrain(scene, about)
    placement = Placement.of(terrain, kept.frame)
    if not placement.is_usable:
        raise RecordingError(f"{terrain.name} has a location, rotation or scale that cannot be used.")
    try:
        grid = open_shown(live.opened, kept)
    except FormatError as error:
        raise RecordingError(str(error)) from error
    data = TakeData.of(TakeColumns(felt), replace(about, lost_ticks=felt.dropped))
    ground = Ground.of(grid, kept)
    return _Left(data, placement, ground, first_frame(felt, asked_at, scene, played=False))


def _terrain(scene: bpy.types.Scene, about: TakeAbout) -> tuple[bpy.types.Object, KeptTerrain]:
    """Find the terrain on which a take was recorded.

    Raises:
        RecordingError: it is not in the scene.
    """
    refusal = (
        f"A take that was left was felt on {about.terrain} ({about.source}), and this scene has no terrain: "
        "import that grid, and recover the take then."
    )
    for terrain in filter(is_terrain, scene.objects):
        try:
            kept = recall(terrain)
            check_same_terrain(about, terrain_about(terrain.name, kept))
        except KeptError:
            continue  # told when it is touched
        except OtherTerrainError as error:
            refusal = str(error)
            continue
        return terrain, kept
    raise RecordingError(refusal)
