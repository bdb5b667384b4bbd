"""A take is recorded, undone and done again, saved and loaded; then Blender quits in mid-touch."""

from __future__ import annotations

import bpy

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script, Until, check


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    yield from steps.drop(blender, "planet.lbl")
    yield from steps.confirm(blender)
    terrain = (yield from steps.imported(blender)).name
    yield from steps.shade_plainly(blender)
    yield from steps.start_touch(blender)
    yield from steps.move_target(blender, "Z", "-0.6")

    yield from _record(blender)
    takes = _takes()
    yield from blender.picture("take")
    check(len(takes) == 1, f"there should be one take: {takes}")
    yield from blender.hand.over_view()
    yield from blender.hand.tap("Z", ctrl=True)
    yield Until("the take is undone", lambda: not _takes())
    check(blender.touch is not None, "touch ended with an undo")
    yield steps.touch_goes_on(blender)
    yield from blender.picture("undone")
    yield from blender.hand.tap("Z", ctrl=True, shift=True)
    yield Until("the take is done again", lambda: _takes() == takes)
    yield steps.touch_goes_on(blender)

    yield from _save_and_load(blender)
    check(blender.touch is None, "touch goes on in a file that was loaded")
    check(_takes() == takes, "the take is not in the file")
    check(terrain in bpy.data.objects, "the terrain is not in the file")
    yield from blender.picture("loaded")
    yield from steps.start_touch(blender)
    yield from blender.picture("touching-again")
    blender.mark("touching again")
    yield 1.0


def _record(blender: Blender) -> Script[None]:
    blender.press("record_start")
    for step in ("0.5", "-0.5"):
        yield from steps.move_target(blender, "X", step)
    yield from blender.picture("recording")
    blender.press("record_stop")
    yield 0.5


def _takes() -> set[str]:
    return {thing.name for thing in bpy.data.objects if thing.name.startswith("Touch Take")}


def _save_and_load(blender: Blender) -> Script[None]:
    path = str(blender.files / "touched.blend")
    with blender.in_view():
        bpy.ops.wm.save_as_mainfile(filepath=path)
    yield 0.5
    with blender.in_view():
        bpy.ops.wm.read_homefile()
    yield 0.5
    check(not _takes(), "the start-up file has a take")
    with blender.in_view():
        bpy.ops.wm.open_mainfile(filepath=path)
    yield 0.5
