"""Blender's timer, and what else must end touch: a file is loaded, the extension goes, Blender quits."""

from __future__ import annotations

import atexit
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import bpy
from bpy.app.handlers import persistent

from ..terrain.kept import KeptError, recall
from .live import Recording, live
from .stop import clear_levels, stop_touch
from .tick import tick

SECONDS = 1.0 / 60.0
"""Between two ticks of the timer: screens seldom show more."""


def start_timer() -> None:
    """Call ``tick`` for as long as touch runs, also across file loads."""
    if not bpy.app.timers.is_registered(_run):
        bpy.app.timers.register(_run, first_interval=SECONDS, persistent=True)


def register() -> None:
    """Add the handlers."""
    for handlers, handler in _handlers():
        handlers.append(handler)
    atexit.register(_quit)


def unregister() -> None:
    """End touch and take the handlers back."""
    _quit()
    atexit.unregister(_quit)
    live.recording = None
    live.message = ""
    live.rendering = False
    live.opened.clear()
    for handlers, handler in reversed(_handlers()):
        if handler in handlers:
            handlers.remove(handler)


def _run() -> float | None:
    try:
        tick()
    except Exception:
        # Blender drops a timer that raises; the hand must not go on without anyone watching.
        stop_touch("Touch stopped: the add-on failed; the system console has the details.")
        raise
    return SECONDS if live.touch is not None else None


def _quit() -> None:
    """A timer that is still registered when Python ends hangs or crashes some versions of Blender."""
    stop_touch()
    if bpy.app.timers.is_registered(_run):
        bpy.app.timers.unregister(_run)


@persistent  # type: ignore[untyped-decorator]
def _before_load(*_arguments: object) -> None:
    """The scene is about to go, and with it what a take would be written to."""
    if live.touch is None:
        live.message = ""  # it was about the file before
    live.opened.clear()
    recording, live.recording = live.recording, None
    left = _left_behind(recording)
    if live.touch is None and left:
        live.message = left
    stop_touch(f"Touch stopped: another file was loaded. {left}".rstrip())


def _left_behind(recording: Recording | None) -> str:
    """End a take that cannot be written any more, and tell what becomes of it."""
    if recording is None:
        return ""
    take = recording.recorder.end()
    if recording.not_spooled or take.spool_failure is not None:
        return f"The take of {take.seconds:.1f} s was not kept."
    return f"The take of {take.seconds:.1f} s is on the disk: Recover Last Take writes it to its terrain."


@persistent  # type: ignore[untyped-decorator]
def _render_begins(*_arguments: object) -> None:
    live.rendering = True


@persistent  # type: ignore[untyped-decorator]
def _render_ends(*_arguments: object) -> None:
    live.rendering = False
    clear_levels()


@persistent  # type: ignore[untyped-decorator]
def _before_undo(*_arguments: object) -> None:
    """What the timer made must not be linked to anything while a step is undone: see ``find_cursor``."""
    if live.touch is not None and live.touch.detail is not None and not live.rendering:
        live.touch.detail.put_away()


@persistent  # type: ignore[untyped-decorator]
def _state_returns(*_arguments: object) -> None:
    """An undo, or a file that was saved on its own in mid-touch, brings back what was shown then."""
    clear_levels()
    _stop_on_other_ground()


def _stop_on_other_ground() -> None:
    """An undo beyond the start of touch may take back a rebuild: another ground is seen than is felt."""
    touch = live.touch
    terrain = touch.terrain.find() if touch is not None else None
    if touch is None or terrain is None:
        return
    with suppress(KeptError):  # what was changed by hand is told when touch starts again
        if not recall(terrain).has_ground_of(touch.kept):
            stop_touch("Touch stopped: the terrain shows another ground since the undo; start touch again.")


def _handlers() -> list[tuple[list[Any], Callable[..., None]]]:
    handlers = bpy.app.handlers
    return [
        (handlers.load_pre, _before_load),
        (handlers.load_post, _state_returns),
        (handlers.undo_pre, _before_undo),
        (handlers.redo_pre, _before_undo),
        (handlers.undo_post, _state_returns),
        (handlers.redo_post, _state_returns),
        (handlers.render_init, _render_begins),
        (handlers.render_complete, _render_ends),
        (handlers.render_cancel, _render_ends),
    ]
