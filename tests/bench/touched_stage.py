"""A hand that circles on a terrain, seen in a view off the screen."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy
from enable_addon import enable

from tests.addon.scene import import_grid, module
from tests.addon.stage import Stage, save, wait_for_map, why_not

DEPTH = 0.004
"""Workspace metres below the ground under the hand at first: it presses with some newtons."""

REACH = 0.02
"""Radius of the circle, workspace metres."""

SECONDS = 2.0
"""For a circle."""


@dataclass
class TouchedStage:
    """A touch, its overlay, and the view."""

    touch: Any
    overlay: Any
    stage: Stage
    milliseconds: int = 0

    def advance(self, milliseconds: int) -> None:
        """Let the hand move on, and Blender's timer look."""
        self.milliseconds += milliseconds
        angle = 2.0 * math.pi * self.milliseconds / (1000.0 * SECONDS)
        x, y, _z = self.touch.session.state().hand
        self.touch.session.set_target(REACH * math.cos(angle), REACH * math.sin(angle), self._height(x, y))
        self.touch.session.step(milliseconds)
        module("touch.tick").tick()

    def draw(self) -> None:
        """Draw the overlay."""
        self.stage.draw_overlay(self.overlay, module("overlay.overlay").Wanted())

    def finish(self) -> None:
        """Wait for the driver."""
        self.stage.read()

    def picture(self, path: Path) -> None:
        """Draw it over the terrain, and keep that."""
        wanted = module("overlay.overlay").Wanted()
        save(self.stage.draw(self.overlay, wanted, ground=self.touch.terrain.find()), path)

    def _height(self, x: float, y: float) -> float:
        """Workspace metres at which the hand presses on the ground there."""
        workspace = module("touch.workspace")
        window, width = self.touch.session.window, self.touch.workspace[0]
        east, north, _up = workspace.from_workspace((x, y, 0.0), window, width)
        ground = self.touch.grid.elevation_at(self.touch.frame.on_map(east), north) or window.up
        z: float = workspace.to_workspace((east, north, ground), window, width)[2]
        return z - DEPTH


def touched_stage(grid: Path) -> TouchedStage:
    """Import a grid, touch it, and look at the hand.

    Raises:
        SystemExit: Blender cannot draw here; the text says why.
    """
    reason = why_not()
    if reason is not None:
        raise SystemExit(reason)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    enable()
    import_grid(grid.resolve())
    touch = module("touch.start").start_touch(bpy.context, on_the_clock=False)
    bpy.data.objects.remove(touch.target.find())  # the hand circles by itself
    overlay = module("overlay.handlers").handlers.overlay
    wait_for_map(overlay)
    here = TouchedStage(touch, overlay, Stage())
    for _ in range(100):
        here.advance(20)
    here.stage = Stage(at=touch.shown.place, distance=5.0)
    return here
