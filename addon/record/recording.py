"""Starting and stopping a take. Curves are written once, when it stops."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from ..terrain.kept import recall
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
    """On each of the three curves."""
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
    collect_ticks(touch)
    render = context.scene.render
    live.recording = Recording(
        session=touch.session,
        recorder=Recorder(),
        grid=touch.grid,
        surface=touch.surface,
        placement=Placement.of(terrain, recall(terrain).frame),
        start_frame=context.scene.frame_current,
        frames_per_second=render.fps / render.fps_base,
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
    take, keyframes = add_take(context, recording)
    drawn = add_trail(context, recording) if trail else None
    return Take(take, drawn, keyframes, recording.recorder.seconds, recording.dropped)
