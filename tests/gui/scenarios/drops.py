"""Files that Blender takes for pictures too: a drop on the 3D view offers a menu with the terrain in it."""

from __future__ import annotations

import bpy

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script, check


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    for name in ("grid.tif", "grid.hdr"):
        yield from steps.drop(blender, name)
        yield from blender.picture(f"{name.replace('.', '-')}-menu")
        yield from blender.hand.tap("E")  # the letter of "Elevation terrain" in the menu
        yield 0.5
        yield from blender.picture(f"{name.replace('.', '-')}-dialog")
        yield from steps.confirm(blender)
        terrain = yield from steps.imported(blender)
        check(len(bpy.data.objects) == 1, f"{name} was also taken for a picture")
        bpy.data.objects.remove(terrain)
    yield from _escape(blender)


def _escape(blender: Blender) -> Script[None]:
    """Esc in the dialog: nothing was added."""
    yield from steps.drop(blender, "planet.lbl")
    yield from blender.hand.tap("ESC")
    yield 0.5
    check(not bpy.data.objects, "a terrain was added although Esc was pressed")
