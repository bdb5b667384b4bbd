"""Starting and stopping a take. Curves are written once, when it stops; until then it is on the disk too."""

from __future__ import annotations

import logging
from dataclasses import dataclass

import bpy
from proxygraph import SessionError

from ..terrain.kept import KeptError, recall
from ..terrain.progress import progress
from ..terrain.undone import undone_on_failure
from ..touch.live import Recording, Touch, live
from ..touch.placement import Placement
from ..touch.recorder import Recorder
from ..touch.stop import note_model
from .about_take import AboutTake, told_of
from .spools import new_spool
from .take import add_take
from .trail import add_trail

log = logging.getLogger(__name__)


class RecordingError(RuntimeError):
    """A take cannot be started or stopped; the text says what to do."""


@dataclass(frozen=True)
class Written:
    """What a take left in the scene."""

    take: bpy.types.Object
    trail: bpy.types.Object | None
    keyframes: int
    """On each of its curves."""
    seconds: float
    dropped: int
    """Ticks that were lost because the computer was too busy, or out of memory."""


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
        grid = recall(terrain).grid
    except KeptError as error:
        raise RecordingError(str(error)) from error
    about = AboutTake(
        terrain=terrain.name,
        title=grid.title,
        source=str(grid.data_path),
        grid=told_of(grid),
        model=touch.session.model,
        start_frame=scene.frame_current,
    )
    live.recording = Recording(
        touch=touch,
        recorder=Recorder(touch.session),
        placement=Placement.of(terrain, touch.frame),
        start_frame=scene.frame_current,
        not_spooled=_record(touch, about.text()),
    )


def stop_recording(context: bpy.types.Context, *, trail: bool = True) -> Written:
    """Write the take, and its trail where one is wanted.

    Raises:
        RecordingError: no take is being recorded, or nothing was felt.
    """
    if live.touch is not None:
        note_model(live.touch)
    recording, live.recording = live.recording, None
    if recording is None:
        raise RecordingError("No take is being recorded.")
    take = recording.recorder.end()
    if not len(take):
        _discard(recording)
        raise RecordingError("The take is empty: nothing was written.")
    scene = recording.touch.scene.find() or context.scene
    if scene is None:
        raise RecordingError("The scene in which the take was recorded is gone, and no other one is open.")
    return write_take(context, scene, recording, _placement(recording), trail=trail)


def write_take(
    context: bpy.types.Context,
    scene: bpy.types.Scene,
    recording: Recording,
    placement: Placement,
    *,
    trail: bool,
) -> Written:
    """Write a take that has ended, and remove its file once it is in the scene."""
    try:
        with progress(context) as tell, undone_on_failure():
            take, keyframes = add_take(scene, recording, placement)
            tell(0.1)
            drawn = add_trail(scene, recording, placement, tell) if trail else None
    except BaseException:
        recording.recorder.end().release_spool()  # to be recovered
        raise
    _discard(recording)
    return Written(take, drawn, keyframes, recording.recorder.seconds, recording.recorder.dropped)


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


def _discard(recording: Recording) -> None:
    """Remove a take's file; one that stays is offered again, which loses nothing."""
    try:
        recording.recorder.end().discard_spool()
    except OSError as error:
        log.warning("a take's file stays: %s", error)


def _placement(recording: Recording) -> Placement:
    """Find where the terrain stands now: it may have been moved while the hand was on it."""
    terrain = recording.touch.terrain.find()
    now = Placement.of(terrain, recording.placement.frame) if terrain is not None else recording.placement
    return now if now.is_usable else recording.placement
