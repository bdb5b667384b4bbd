"""Undo in mid-touch: what the timer did since the last step must not leave Blender with dead pointers."""

from __future__ import annotations

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script, check


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    yield from steps.drop(blender, "planet.lbl")
    yield from steps.confirm(blender)
    yield from steps.imported(blender)
    yield from steps.shade_plainly(blender)
    # Steps of undo in which the scene stays the same.
    for _ in range(3):
        yield from steps.move_target(blender, "X", "0.1")
    yield from steps.start_touch(blender)
    yield from steps.move_target(blender, "Z", "-0.6")
    yield steps.contact_is(blender, in_contact=True)
    yield from _new_shape(blender)
    yield from _beyond_the_start(blender)


def _new_shape(blender: Blender) -> Script[None]:
    """The cursor has a shape that it never had, and the step that is undone does not know it."""
    for _ in range(2):
        yield from steps.move_target(blender, "X", "0.1")
    yield from blender.hand.tap("E")
    yield steps.mode_is(blender, "pan")
    yield 0.5
    yield from _undo(blender)
    check(blender.touch is not None, "touch ended with an undo")
    yield from blender.hand.tap("E")
    yield steps.mode_is(blender, "normal")


def _beyond_the_start(blender: Blender) -> Script[None]:
    """Undo until before touch began, and further; then all of it again."""
    for _ in range(5):
        yield from _undo(blender)
    yield from blender.picture("undone")
    check(blender.touch is None, "touch goes on although its start was undone")
    for _ in range(5):
        yield from blender.hand.over_view()
        yield from blender.hand.tap("Z", ctrl=True, shift=True)
        yield 1.0
    yield from blender.picture("redone")


def _undo(blender: Blender) -> Script[None]:
    yield from blender.hand.over_view()
    yield from blender.hand.tap("Z", ctrl=True)
    yield 1.0  # the timer looks meanwhile
