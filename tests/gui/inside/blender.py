"""The Blender that a scenario is played in: its files, its window, its pictures, its end."""

from __future__ import annotations

import importlib
import json
import time
from pathlib import Path
from types import ModuleType
from typing import Any

import bpy

from tests.gui.inside.hand import Hand
from tests.gui.inside.picture import Picture, grab
from tests.gui.inside.script import Script

MODULE = "bl_ext.user_default.haptic_terrain"
"""The extension's package, as Blender names what was installed from disk."""

SETTLED = 0.4
"""Seconds after which Blender has drawn what was changed."""


class Blender:
    """Handed to every scenario."""

    def __init__(self, folder: Path) -> None:
        self.files = folder / "files"
        self.options: dict[str, Any] = json.loads((folder / "options.json").read_text(encoding="utf-8"))
        self.figures: dict[str, Any] = {}
        """For the outcome."""
        self._output = folder / "output"
        self._marks: dict[str, float] = {}
        self._pictures = 0
        self.hand = Hand(self)
        bpy.context.preferences.view.show_splash = False
        # A processor draws here: smooth edges would take most of its time.
        bpy.context.preferences.system.viewport_aa = "OFF"

    @property
    def window(self) -> bpy.types.Window:
        """The one window."""
        return bpy.context.window_manager.windows[0]

    @property
    def area(self) -> bpy.types.Area:
        """The 3D view."""
        return next(area for area in self.window.screen.areas if area.type == "VIEW_3D")

    @property
    def space(self) -> Any:
        """The 3D view's settings."""
        return self.area.spaces.active

    def region(self, kind: str = "WINDOW") -> bpy.types.Region:
        """A part of the 3D view."""
        return next(region for region in self.area.regions if region.type == kind)

    def in_view(self) -> Any:
        """A context as if the mouse were over the 3D view, for operators and what looks at the context."""
        return bpy.context.temp_override(window=self.window, area=self.area, region=self.region())

    def press(self, operator: str) -> None:
        """Press a button of the add-on's panels: unlike a script's call, it can be undone."""
        with self.in_view():
            getattr(bpy.ops.haptic_terrain, operator)("INVOKE_DEFAULT", True)

    def part(self, name: str) -> ModuleType:
        """A module of the installed extension."""
        return importlib.import_module(f"{MODULE}.{name}")

    @property
    def touch(self) -> Any:
        """The touch that runs; ``None`` where none does."""
        return self.part("touch.live").live.touch

    def mark(self, what: str) -> None:
        """Note the time of something, for the outcome."""
        self._marks[what] = time.time()

    def picture(self, name: str, *, wait: float = SETTLED) -> Script[Picture]:
        """Take a picture and keep it: ``shown = yield from blender.picture("panel")``."""
        picture = yield from self.look(wait=wait)
        self._keep(picture, name)
        return picture

    def look(self, *, wait: float = SETTLED) -> Script[Picture]:
        """Take a picture only to compare it."""
        self.area.tag_redraw()
        yield wait
        return grab()

    def quit(self, failure: str | None) -> None:
        """Write the outcome and quit as a person would."""
        if failure is not None:
            self._keep(grab(), "failure")
        self.mark("quits")
        outcome = {"failure": failure, "marks": self._marks, "figures": self.figures}
        (self._output / "outcome.json").write_text(json.dumps(outcome, indent=2), encoding="utf-8")
        bpy.ops.wm.quit_blender()

    def _keep(self, picture: Picture, name: str) -> None:
        self._pictures += 1
        picture.save(self._output / f"{self._pictures:02}-{name}.png")
