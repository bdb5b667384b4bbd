"""Starting and stopping a take. Curves are written once, when it stops."""

from __future__ import annotations

from dataclasses import replace

import bpy

from ..terrain.kept import KeptError, recall
from ..terrain.progress import progress
from ..terrain.undone import undone_on_failure
from ..touch.live import Recording, live
from ..touch.placement import Placement
from ..touch.recorder import Recorder
from ..touch.stop import collect_ticks
from .chosen_options import chosen_options
from .ground import Ground
from .playing import start_playing, stop_playing
from .take_data import TakeAbout, TakeData
from .take_options import DEFAULT_TRAILS
from .terrain_about import grid_of
from .write_take import Take, write_take


class RecordingError(RuntimeError):
    """A take cannot be started or stopped; the text says what to do."""


def start_recording(context: bpy.types.Context) -> None:
    """Keep every tick from now on.

    Raises:
        RecordingError: touch does not run, or a take is being recorded.
    """
    touch = live.touch
    if touch is None:
        raise RecordingError("Start touch before recording.")
    if live.recording is not None:
        raise RecordingError("A take is being recorded already: stop it first.")
    terrain = touch.terrain.find()
    if terrain is None:
        raise RecordingError("The terrain is gone from the scene: import it again.")
    scene = touch.scene.find()
    if scene is None:
        raise RecordingError("The scene in which touch was started is gone: start it again.")
    try:
        kept = recall(terrain)
    except KeptError as error:
        raise RecordingError(str(error)) from error
    collect_ticks(touch)
    recording = Recording(
        touch=touch,
        recorder=Recorder(),
        placement=Placement.of(terrain, touch.frame),
        start_frame=scene.frame_current,
        source=kept.grid.data_path.name,
        digest=kept.stamp.digest if kept.stamp is not None else "",
        dropped_before=touch.session.statistics().dropped,
    )
    if scene.haptic_terrain.play_timeline:
        recording.played = start_playing(context, scene)
    live.recording = recording


def stop_recording(context: bpy.types.Context, *, trail: bool | None = None) -> Take:
    """Write the take as the scene's settings say. While that fails, the recording stays as it is.

    Args:
        trail: whether to draw trails; ``None`` leaves that to the settings.

    Raises:
        RecordingError: no take is being recorded, or nothing was felt.
    """
    if live.touch is not None:
        collect_ticks(live.touch)
    recording = live.recording
    if recording is None:
        raise RecordingError("No take is being recorded.")
    stop_playing(context, recording)
    if not len(recording.recorder):
        live.recording = None
        raise RecordingError("The take is empty: nothing was written.")
    scene = recording.touch.scene.find() or context.scene
    if scene is None:
        raise RecordingError("The scene in which the take was recorded is gone, and no other one is open.")
    options = chosen_options(scene, recording.start_frame)
    if trail is not None:
        options = replace(options, trails=(options.trails or DEFAULT_TRAILS) if trail else frozenset())
    ground = Ground(recording.touch.grid, recording.touch.surface)
    with progress(context) as tell, undone_on_failure():
        take = write_take(scene, take_data(recording), _placement(recording), ground, options, tell)
    live.recording = None
    return take


def discard_recording(context: bpy.types.Context) -> None:
    """Let go of the take in the making.

    Raises:
        RecordingError: no take is being recorded.
    """
    if live.recording is None:
        raise RecordingError("No take is being recorded.")
    stop_playing(context, live.recording)
    live.recording = None


def take_data(recording: Recording) -> TakeData:
    """What was recorded so far, in the form that all writers take."""
    touch = recording.touch
    about = TakeAbout(
        terrain=touch.terrain.name,
        source=recording.source,
        digest=recording.digest,
        georeference=touch.georeference,
        workspace_width=touch.workspace[0],
        models=tuple(recording.models),
        lost_ticks=recording.dropped,
        **grid_of(touch.grid.layout),
    )
    return TakeData.of(recording.recorder.columns, about)


def _placement(recording: Recording) -> Placement:
    """Find where the terrain stands now: it may have been moved while the hand was on it."""
    terrain = recording.touch.terrain.find()
    now = Placement.of(terrain, recording.placement.frame) if terrain is not None else recording.placement
    return now if now.is_usable else recording.placement
