"""Writing a take that a crash left on the disk."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import bpy
from proxygraph import Take

from ..formats import FormatError
from ..terrain.kept import KeptError, KeptTerrain, is_terrain, recall
from ..terrain.opening import open_shown
from ..terrain.preview import preview_cells, preview_surface
from ..touch.handle import Handle
from ..touch.live import Recording, Touched, live
from ..touch.placement import Placement
from ..touch.recorder import Recorder
from .about_take import AboutTake, told_of
from .recording import RecordingError, Written, write_take
from .spools import left_takes


@dataclass(frozen=True)
class Recovered:
    """A take that was brought back."""

    written: Written
    lost: str | None
    """What of its file could not be read, in words."""


def recover_take(context: bpy.types.Context, *, trail: bool = True) -> Recovered:
    """Write the newest take that was left of a terrain in the scene, and remove its file.

    Raises:
        RecordingError: there is none, or it cannot be written here; then its file stays.
    """
    scene = context.scene
    if scene is None:
        raise RecordingError("No scene is open.")
    refused: list[str] = []
    for path, take in left_takes(live.spool_folder, refused) if live.spool_folder is not None else ():
        try:
            recording = _recording(scene, path, take)
        except RecordingError as error:
            take.release_spool()
            refused.append(str(error))
            continue
        written = write_take(context, scene, recording, recording.placement, trail=trail)
        return Recovered(written, take.lost)
    raise RecordingError(" ".join(refused or ["There is no take to recover."]))


def _recording(scene: bpy.types.Scene, path: Path, take: Take) -> Recording:
    """Make what the take was in the making."""
    try:
        about = AboutTake.read(take.about)
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
    touched = Touched(
        grid=grid,
        georeference=kept.grid.georeference,
        frame=kept.frame,
        surface=preview_surface(grid, preview_cells(grid.layout, kept.vertex_budget)),
        scene=Handle.to(scene),
        terrain=Handle.to(terrain),
    )
    return Recording(touched, Recorder.of(take), placement, about.start_frame, [about.model])


def _terrain(scene: bpy.types.Scene, about: AboutTake) -> tuple[bpy.types.Object, KeptTerrain]:
    """Find the terrain on which a take was recorded.

    Raises:
        RecordingError: it is not in the scene.
    """
    others = []
    for terrain in filter(is_terrain, scene.objects):
        try:
            kept = recall(terrain)
        except KeptError:
            continue  # told when it is touched
        if told_of(kept.grid) == about.grid:
            return terrain, kept
        others.append(kept.grid.title)
    here = f"this scene has {', '.join(others)}" if others else "this scene has no terrain"
    raise RecordingError(
        f"A take that was left was recorded on {about.title} ({about.source}), and {here}: import that grid, "
        "and recover the take then."
    )
