"""The timeline that plays while a take is recorded, so that the hand can answer to what is animated."""

from __future__ import annotations

import bpy

from ..touch.live import Played, Recording
from .keys import LAST_FRAME


def start_playing(context: bpy.types.Context, scene: bpy.types.Scene) -> Played | None:
    """Play from the current frame on, at the scene's rate by the clock, as the take's keys will lie.

    The range is opened meanwhile: at its end Blender would begin again, and the hand would not.

    Returns:
        What to put back; ``None`` in the background, and where the screen shows another scene: nothing plays.
    """
    screen = context.screen
    if bpy.app.background or screen is None or context.scene != scene:
        return None
    before = Played(scene.sync_mode, scene.frame_end, scene.use_preview_range)
    scene.sync_mode = "FRAME_DROP"  # Blender leaves frames out rather than fall behind the clock
    scene.use_preview_range = False
    scene.frame_end = LAST_FRAME
    if not screen.is_animation_playing:
        bpy.ops.screen.animation_play()
    return before


def stop_playing(context: bpy.types.Context, recording: Recording) -> None:
    """Stop at the frame that is shown, and put back how the scene plays, where it plays along."""
    before, recording.played = recording.played, None
    if before is None:
        return
    scene = recording.touch.scene.find()
    if scene is not None:
        scene.sync_mode = before.sync_mode
        scene.frame_end = before.frame_end
        scene.use_preview_range = before.uses_preview_range
    if context.screen is not None and context.screen.is_animation_playing:
        bpy.ops.screen.animation_cancel(restore_frame=False)
