"""Stopping touch, whoever wants it."""

from __future__ import annotations

import logging

import bpy

from ..terrain.view import redraw
from .live import Touch, live

log = logging.getLogger(__name__)


def stop_touch(message: str = "") -> None:
    """Take the hand away; harmless when touch does not run. A take in the making is kept.

    Args:
        message: for the person, when it was not they who stopped it.
    """
    touch = live.touch
    if touch is None:
        return
    touch.session.stop()
    collect_ticks(touch)
    live.change(None)
    if message:
        live.message = message
        log.warning(message)
    redraw(bpy.context)


def collect_ticks(touch: Touch) -> None:
    """Empty the session's ring: into the take while there is one, else to keep the ring from overflowing."""
    ticks = touch.session.drain()
    recording = live.recording
    if recording is not None and recording.touch is touch:
        recording.recorder.add(ticks)
        if touch.session.model not in recording.models[-1:]:
            recording.models.append(touch.session.model)
        recording.dropped = touch.session.statistics().dropped - recording.dropped_before
