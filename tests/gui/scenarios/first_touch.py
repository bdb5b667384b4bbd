"""From the zip to a take: install, import, touch, pan, zoom, record, undo, save, load."""

from __future__ import annotations

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from blender.picture("begin")
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    yield from blender.picture("installed")
    yield from steps.drop(blender, "sample.lbl")
    yield from blender.picture("dialog")
    yield from steps.confirm(blender)
    yield from steps.imported(blender)
    yield from blender.picture("imported", wait=2.0)
    yield from steps.start_touch(blender)
    yield from blender.picture("touching", wait=2.0)
