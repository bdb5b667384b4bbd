"""Blender's draw handlers: they are there while touch runs, and at no other time."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import bpy

from ..touch.live import live
from .overlay import Overlay, Wanted
from .pen import clean_state
from .view import View, view_of

log = logging.getLogger(__name__)

FAILED = "The overlay failed and is off until touch starts again: the system console has the details."


@dataclass
class Handlers:
    """The overlay that is drawn now, and what Blender calls to draw it."""

    overlay: Overlay | None = None
    _added: list[Any] = field(default_factory=list)

    def follow(self) -> None:
        """Draw over the touch that runs; nothing where none does."""
        self.remove()
        if live.touch is None:
            return
        try:
            self.overlay = Overlay.of(live.touch)
        except Exception:
            self._fail()  # what is felt does not depend on what is drawn over the view
            return
        for draw, when in ((self._draw_flat, "POST_PIXEL"), (self._draw_in_scene, "POST_VIEW")):
            self._added.append(bpy.types.SpaceView3D.draw_handler_add(draw, (), "WINDOW", when))

    def remove(self) -> None:
        """Draw nothing any more."""
        self.overlay = None
        for handler in self._added:
            bpy.types.SpaceView3D.draw_handler_remove(handler, "WINDOW")
        self._added.clear()

    def _draw_flat(self) -> None:
        if self.overlay is not None:
            self._draw(self.overlay, self.overlay.draw_flat)

    def _draw_in_scene(self) -> None:
        if self.overlay is not None:
            self._draw(self.overlay, self.overlay.draw_in_scene)

    def _draw(self, overlay: Overlay, draw: Callable[[View, Wanted], None]) -> None:
        """Draw into the region of the context, where it shows the touched scene and overlays are wanted."""
        try:
            context = bpy.context
            scene, space = context.scene, context.space_data
            if scene is None or scene.session_uid != overlay.touch.scene.session_uid:
                return
            view = view_of(context)
            if view is None or not space.overlay.show_overlays:
                return
            with clean_state():
                draw(view, Wanted.by(scene))
        except Exception:
            # Blender would print it at every redraw. The handlers go when touch ends: now they are called.
            self._fail()

    def _fail(self) -> None:
        self.overlay = None
        live.message = FAILED
        log.exception(FAILED)


handlers = Handlers()


def register() -> None:
    """Follow every touch from now on."""
    live.watchers.append(handlers.follow)


def unregister() -> None:
    """Draw nothing any more."""
    live.watchers.remove(handlers.follow)
    handlers.remove()
