"""Starting and stopping a take: written to the scene once, when it stops, and on the disk until then."""

from __future__ import annotations

import logging
from dataclasses import replace

import bpy
from proxygraph import SessionError

from ..terrain.progress import progress
from ..terrain.undone import undone_on_failure
from ..touch.live import Recording, Touch, live
from ..touch.placement import Placement
from ..touch.recorder import Recorder
from ..touch.stop import note_model
from .chosen_options import chosen_options
from .ground import Ground
from .playing import start_playing, stop_playing
from .pre_roll_frames import first_frame
from .spool_text import spool_text
from .spools import new_spool
from .take_data import TakeAbout, TakeData
from .take_options import DEFAULT_TRAILS
from .terrain_about import terrain_about
from .write_take import Take, write_take

log = logging.getLogger(__name__)


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
    about = replace(_about(touch), models=(touch.session.model,))
    recording = Recording(
        touch=touch,
        recorder=Recorder(touch.session),
        placement=Placement.of(terrain, touch.frame),
        start_frame=scene.frame_current,
        not_spooled=_record(touch, spool_text(about, scene.frame_current)),
    )
    if scene.haptic_terrain.play_timeline:
        recording.played = start_playing(context, scene)
    live.recording = recording


def stop_recording(context: bpy.types.Context, *, trail: bool | None = None) -> Take:
    """Write the take as the scene's settings say. While that fails, the recording waits as it is.

    Args:
        trail: whether to draw trails; ``None`` leaves that to the settings.

    Raises:
        RecordingError: no take is being recorded, or nothing was felt.
    """
    if live.touch is not None:
        note_model(live.touch)
    recording = live.recording
    if recording is None:
        raise RecordingError("No take is being recorded.")
    played = recording.played is not None
    stop_playing(context, recording)
    felt = recording.recorder.end()
    if not len(felt):
        _forget(recording)
        raise RecordingError("The take is empty: nothing was written.")
    scene = recording.touch.scene.find() or context.scene
    if scene is None:
        raise RecordingError("The scene in which the take was recorded is gone, and no other one is open.")
    options = chosen_options(scene, first_frame(felt, recording.start_frame, scene, played=played))
    if trail is not None:
        options = replace(options, trails=(options.trails or DEFAULT_TRAILS) if trail else frozenset())
    ground = Ground(recording.touch.grid, recording.touch.surface)
    with progress(context) as tell, undone_on_failure():
        take = write_take(scene, take_data(recording), _placement(recording), ground, options, tell)
    _forget(recording)
    return take


def discard_recording(context: bpy.types.Context) -> None:
    """Let go of the take in the making.

    Raises:
        RecordingError: no take is being recorded.
    """
    recording = live.recording
    if recording is None:
        raise RecordingError("No take is being recorded.")
    stop_playing(context, recording)
    recording.recorder.end()
    _forget(recording)


def take_data(recording: Recording) -> TakeData:
    """What was recorded so far, in the form that all writers take."""
    recorder = recording.recorder
    about = replace(_about(recording.touch), models=tuple(recording.models), lost_ticks=recorder.dropped)
    return TakeData.of(recorder.columns, about)


def _about(touch: Touch) -> TakeAbout:
    return replace(terrain_about(touch.terrain.name, touch.kept), workspace_width=touch.workspace[0])


def _record(touch: Touch, about: str) -> str:
    """Begin, and say why the take is in memory only; an empty text where it is on the disk too.

    Raises:
        RecordingError: the session does not record.
    """
    refused = "the extension has no folder"
    try:
        if live.spool_folder is not None:
            try:
                touch.session.start_recording(about, spool=new_spool(live.spool_folder))
            except OSError as error:
                refused = f"{live.spool_folder} cannot be written to ({error.strerror or error})"
            else:
                return ""
        touch.session.start_recording(about)
    except SessionError as error:
        raise RecordingError(f"Recording cannot start: {error}.") from error
    return refused


def _forget(recording: Recording) -> None:
    """Remove the file of a take that has ended; one that stays is offered again, which loses nothing."""
    live.recording = None
    try:
        recording.recorder.end().discard_spool()
    except OSError as error:
        log.warning("a take's file stays: %s", error)


def _placement(recording: Recording) -> Placement:
    """Find where the terrain stands now: it may have been moved while the hand was on it."""
    terrain = recording.touch.terrain.find()
    now = Placement.of(terrain, recording.placement.frame) if terrain is not None else recording.placement
    return now if now.is_usable else recording.placement
