"""From the zip to pan and zoom: install, drop a grid, touch it, see the cursor tell what the hand does."""

from __future__ import annotations

from tests.gui.inside import steps
from tests.gui.inside.blender import Blender
from tests.gui.inside.script import Script, check
from tests.gui.inside.silhouette import Silhouette, silhouette


def scenario(blender: Blender) -> Script[None]:
    """Play it."""
    yield from steps.install(blender)
    yield from steps.begin_empty(blender)
    empty = yield from blender.picture("installed")
    yield from steps.drop(blender, "planet.lbl")
    yield from blender.picture("dialog")
    yield from steps.confirm(blender)
    yield from steps.imported(blender)
    yield from steps.drawn(blender, empty)
    yield from blender.picture("imported")
    yield from steps.shade_plainly(blender)
    yield from steps.start_touch(blender)
    blender.mark("touching")
    yield from blender.picture("touching")
    yield from _four_shapes(blender)
    yield from blender.picture("touched")
    blender.mark("touched")
    yield from steps.stop_touch(blender)
    blender.mark("stopped")
    yield 1.0


def _four_shapes(blender: Blender) -> Script[None]:
    """In the air, in contact, pan, zoom: the cursor has a shape and a colour for each."""
    yield from steps.move_target(blender, "Y", "-1.2")  # away from the canyon, onto even ground
    yield steps.at_rest(blender)
    free = yield from silhouette(blender, steps.cursor(blender), "in-the-air")
    yield from steps.move_target(blender, "Z", "-0.6")
    yield steps.contact_is(blender, in_contact=True)
    yield steps.at_rest(blender)
    contact = yield from silhouette(blender, steps.cursor(blender), "in-contact")

    yield from blender.hand.tap("E")
    yield steps.mode_is(blender, "pan")
    before = blender.touch.session.window
    yield from steps.move_target(blender, "X", "0.3")
    yield steps.at_rest(blender)
    pan = yield from silhouette(blender, steps.cursor(blender), "pan")
    yield from blender.hand.tap("E")
    yield steps.mode_is(blender, "normal")
    check(blender.touch.session.window.east != before.east, "the pan did not move the window")

    yield from steps.move_target(blender, "Z", "1.2")
    yield steps.contact_is(blender, in_contact=False)
    yield from blender.hand.tap("E")
    yield steps.mode_is(blender, "zoom")
    yield from steps.move_target(blender, "Z", "0.4")
    yield steps.at_rest(blender)
    zoom = yield from silhouette(blender, steps.cursor(blender), "zoom")
    yield from blender.hand.tap("E")
    yield steps.mode_is(blender, "normal")
    check(blender.touch.session.window.width < before.width, "the zoom did not narrow the window")

    blender.figures["cursor"] = {
        name: vars(shape)
        for name, shape in (("free", free), ("contact", contact), ("pan", pan), ("zoom", zoom))
    }
    _check_shapes(free, contact, pan, zoom)


def _check_shapes(free: Silhouette, contact: Silhouette, pan: Silhouette, zoom: Silhouette) -> None:
    check(0.8 < free.slenderness < 1.25, f"in the air the cursor should be a sphere: {free}")
    check(contact.slenderness > 1.25, f"in contact the cursor should be a cone: {contact}")
    check(pan.slenderness < 0.8, f"in pan the cursor should be flat: {pan}")
    check(zoom.slenderness > 2.0, f"in zoom the cursor should be tall: {zoom}")
    hues = sorted(shape.hue for shape in (free, contact, pan, zoom))
    apart = min(high - low for low, high in zip(hues, [*hues[1:], hues[0] + 360.0], strict=True))
    check(apart > 20.0, f"two modes have nearly the same colour: {hues}")
