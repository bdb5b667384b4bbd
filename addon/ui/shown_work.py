"""Long work of an operator as a person sees it: a timer to go on by, progress at the pointer, words below."""

from __future__ import annotations

from typing import cast

import bpy

from .status_bar import status_bar


class ShownWork:
    """Of an operator that is modal for as long as the work takes."""

    _timer: bpy.types.Timer | None = None

    def begin_showing(self, context: bpy.types.Context, seconds: float) -> None:
        """Become modal.

        Args:
            seconds: between two events of the timer.
        """
        manager = context.window_manager
        self._timer = manager.event_timer_add(seconds, window=context.window)
        manager.progress_begin(0.0, 1.0)
        manager.modal_handler_add(self)  # type: ignore[arg-type]  # every class of this kind is an operator

    def show_work(self, context: bpy.types.Context, words: str, share: float, ending: str) -> None:
        """Tell how far it is, in every workspace.

        Args:
            share: that is done, from 0 to 1.
            ending: what Esc does, in words.
        """
        context.window_manager.progress_update(share)
        if context.workspace is not None:
            hint = status_bar(f"{words}: {share:.0%} ({ending})")
            context.workspace.status_text_set(cast("str", hint))

    def end_showing(self, context: bpy.types.Context) -> None:
        """Take timer and display back."""
        manager = context.window_manager
        if self._timer is not None:
            manager.event_timer_remove(self._timer)
        manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)
        self._timer = None
