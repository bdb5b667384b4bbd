"""What a person does with the extension, step by step, for scenarios to put together."""

from __future__ import annotations

import bpy
from mathutils import Vector

from tests.gui.inside.blender import MODULE, Blender
from tests.gui.inside.picture import Picture, grab
from tests.gui.inside.script import Script, Until, check

TAB = "Haptic Terrain"
"""In the sidebar."""


def install(blender: Blender) -> Script[None]:
    """Install the extension's zip from the disk, which enables it."""
    (package,) = blender.files.glob("*.zip")
    with blender.in_view():
        bpy.ops.extensions.package_install_files(
            filepath=str(package), repo="user_default", enable_on_install=True
        )
    check(MODULE in bpy.context.preferences.addons, "the extension is not enabled after its installation")
    yield 0.2


def begin_empty(blender: Blender) -> Script[None]:
    """Take away what the start-up file has, and show the add-on's tab."""
    bpy.data.batch_remove(list(bpy.data.objects))
    yield from show_tab(blender)


def show_tab(blender: Blender) -> Script[None]:
    """Open the sidebar at the add-on's tab."""
    blender.space.show_region_ui = True
    yield Until("the sidebar is open", lambda: blender.region("UI").width > 50)
    blender.area.tag_redraw()
    yield 0.3  # a region has no tabs before it was drawn
    blender.region("UI").active_panel_category = TAB  # type: ignore[assignment]
    yield 0.2


def drop(blender: Blender, *files: str) -> Script[None]:
    """Let files fall on the middle of the 3D view."""
    yield from blender.hand.over_view()
    with blender.in_view():
        bpy.ops.wm.drop_import_file(
            "INVOKE_DEFAULT", directory=str(blender.files), files=[{"name": name} for name in files]
        )
    yield 0.5


def confirm(blender: Blender) -> Script[None]:
    """Press a dialog's button."""
    yield from blender.hand.tap("RET")


def imported(blender: Blender) -> Script[bpy.types.Object]:
    """Wait for one more terrain."""
    is_terrain = blender.part("terrain.kept").is_terrain

    def found() -> bpy.types.Object | None:
        return next((thing for thing in bpy.data.objects if is_terrain(thing)), None)

    yield Until("the terrain is in the scene", found)
    terrain = found()
    assert terrain is not None
    yield 0.3
    return terrain


def search(blender: Blender, words: str) -> Script[None]:
    """Do something through the menu that finds everything (F3)."""
    yield from blender.hand.over_view()
    yield from blender.hand.tap("F3")
    yield 0.3
    yield from blender.hand.type(words)
    yield 0.5
    yield from blender.hand.tap("RET")
    yield 0.3


def drawn(blender: Blender, before: Picture) -> Script[None]:
    """Wait until the screen shows something else, and stays as it is: shaders are compiled first."""
    seen = [before]

    def is_still() -> bool:
        blender.area.tag_redraw()
        seen.append(grab())
        is_new = seen[-1].share_changed(before) > 0.05
        return is_new and all(last.share_changed(seen[-1]) == 0.0 for last in seen[-4:-1])

    yield Until("the 3D view has drawn the terrain", is_still, seconds=90.0, every=0.5)


def shade_plainly(blender: Blender) -> Script[None]:
    """Show materials' plain colours, which can be drawn often enough without a graphics card."""
    blender.space.shading.type = "SOLID"
    yield 0.2


def hide_sidebar(blender: Blender) -> Script[None]:
    """See more of the view."""
    blender.space.show_region_ui = False
    yield 0.3


def touch_runs(blender: Blender) -> Until:
    """Wait for the first looks at the servo."""
    return Until("the servo runs", lambda: blender.touch is not None and blender.touch.readout.ticks > 100)


def touch_goes_on(blender: Blender) -> Until:
    """Wait for a look at the servo that is newer than this one."""
    now = blender.touch.readout.ticks
    return Until("the servo goes on", lambda: blender.touch.readout.ticks > now + 100)


def start_touch(blender: Blender) -> Script[None]:
    """Start touch."""
    blender.press("touch_start")
    yield touch_runs(blender)


def stop_touch(blender: Blender) -> Script[None]:
    """Stop touch."""
    blender.press("touch_stop")
    check(blender.touch is None, "touch goes on after Stop Touch")
    yield 0.2


def move_target(blender: Blender, axis: str, units: str) -> Script[None]:
    """Move the selected Empty along an axis of the scene by typed Blender units, and let the hand arrive."""
    yield from blender.hand.over_view()
    yield from blender.hand.tap("G")
    yield from blender.hand.tap(axis)
    yield from blender.hand.type(units)
    yield from blender.hand.tap("RET")
    yield 1.0


def mode_is(blender: Blender, mode: str) -> Until:
    """Wait until the panel says so."""
    return Until(f"the mode is {mode}", lambda: blender.touch.readout.mode == mode)


def contact_is(blender: Blender, *, in_contact: bool) -> Until:
    """Wait until the hand touches the ground, or does not."""
    what = "touches the ground" if in_contact else "is in the air"
    return Until(f"the hand {what}", lambda: blender.touch.readout.in_contact is in_contact)


STILL = 0.002
"""Blender units that something may move between two looks and count as still: less than a pixel."""


def at_rest(blender: Blender) -> Until:
    """Wait until cursor and view stand still: a slow Blender shows a motion for long."""
    seen: list[tuple[Vector, float]] = []

    def stands() -> bool:
        view = blender.space.region_3d
        seen.append((cursor(blender).matrix_world.translation.copy(), view.view_distance))
        place, distance = seen[-1]
        return len(seen) > 3 and all(
            (place - earlier).length < STILL and abs(distance - far) < STILL for earlier, far in seen[-4:-1]
        )

    return Until("the hand has come to rest", stands, every=0.5)


def cursor(blender: Blender) -> bpy.types.Object:
    """The cursor's object."""
    name: str = blender.part("touch.cursor").NAME
    return bpy.data.objects[name]
