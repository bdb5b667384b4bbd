"""Starting and stopping a take. Curves are written once, when it stops."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from ..terrain.progress import progress
from ..terrain.undone import undone_on_failure
from ..touch.live import Recording, live
from ..touch.placement import Placement
from ..touch.recorder import Recorder
from ..touch.stop import collect_ticks
from .take import add_take
from .trail import add_trail


class RecordingError(RuntimeError):
    """A take cannot be started or stopped; the text says what to do."""


@dataclass(frozen=True)
class Take:
    """What a take left in the scene."""

    take: bpy.types.Object
    trail: bpy.types.Object | None
    keyframes: int
    """On each of its curves."""
    seconds: float
    dropped: int
    """Ticks that were lost because Blender was busy for longer than the ring lasts."""


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
    collect_ticks(touch)
    live.recording = Recording(
        touch=touch,
        recorder=Recorder(),
        placement=Placement.of(terrain, touch.frame),
        start_frame=scene.frame_current,
        dropped_before=touch.session.statistics().dropped,
    )


def stop_recording(context: bpy.types.Context, *, trail: bool = True) -> Take:
    """Write the take, and its trail where one is wanted.

    Raises:
        RecordingError: no take is being recorded, or nothing was felt.
    """
    if live.touch is not None:
        collect_ticks(live.touch)
    recording, live.recording = live.recording, None
    if recording is None:
        raise RecordingError("No take is being recorded.")
    if not len(recording.recorder):
        raise RecordingError("The take is empty: nothing was written.")
    scene = recording.touch.scene.find() or context.scene
    if scene is None:
        raise RecordingError("The scene in which the take was recorded is gone, and no other one is open.")
    placement = _placement(recording)
    with progress(context) as tell, undone_on_failure():
        take, keyframes = add_take(scene, recording, placement)
        tell(0.1)
        drawn = add_trail(scene, recording, placement, tell) if trail else None
    return Take(take, drawn, keyframes, recording.recorder.seconds, recording.dropped)


def _placement(recording: Recording) -> Placement:
    """Find where the terrain stands now: it may have been moved while the hand was on it."""
    terrain = recording.touch.terrain.find()
    now = Placement.of(terrain, recording.placement.frame) if terrain is not None else recording.placement
    return now if now.is_usable else recording.placement
