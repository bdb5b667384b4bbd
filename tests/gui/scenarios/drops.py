"""Files that Blender takes for pictures too: a drop on the 3D view offers a menu with the terrain in it."""

from __future__ import annotations

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    for name in ("grid.tif", "grid.hdr"):
        yield from steps.drop(blender, name)
        yield from blender.picture(name.replace(".", "-"))
        yield from blender.hand.tap("ESC")
