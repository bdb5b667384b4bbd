"""Stopping touch, whoever wants it."""

from __future__ import annotations

import logging

import bpy

from ..terrain.levels_object import put_away_levels
from ..terrain.view import redraw
from .follow_view import give_back_views
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
    note_model(touch)
    give_back_views(touch)
    live.change(None)
    if touch.detail is not None:
        touch.detail.end()
        clear_levels()
    if message:
        live.message = message
        log.warning(message)
    redraw(bpy.context)


def clear_levels() -> None:
    """Take away what the views showed of a touch that has ended; not while a picture is rendered."""
    if live.touch is None and not live.rendering:
        put_away_levels()


def note_model(touch: Touch) -> None:
    """Let the take know which contact model answers."""
    recording = live.recording
    if recording is None or recording.touch is not touch:
        return
    if touch.session.model not in recording.models[-1:]:
        recording.models.append(touch.session.model)
