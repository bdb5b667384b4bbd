"""The stylus button as an operator and as a key, and the handle's turn."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import bpy
import pytest

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.addon.stand_in import StandIn
from tests.addon.test_panels import drawn
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(**options: Any) -> Any:
    return module("touch.start").start_touch(bpy.context, **{"on_the_clock": False, **options})


def step(touch: Any, ticks: int = 20) -> None:
    touch.session.step(ticks)
    module("touch.tick").tick()


def keys() -> list[tuple[str, str, str, bool]]:
    """Keymap, operator, key and whether it repeats, of what the extension added for the stylus."""
    keymaps = bpy.context.window_manager.keyconfigs.addon.keymaps
    return [
        (keymap.name, item.idname, item.type, item.repeat)
        for keymap in keymaps
        for item in keymap.keymap_items
        if item.idname in ("haptic_terrain.press", "haptic_terrain.release")
    ]


def test_grab_in_the_air_zooms_and_release_ends_it(terrain: bpy.types.Object) -> None:
    touch = start()
    step(touch)
    assert bpy.ops.haptic_terrain.press() == {"FINISHED"}
    step(touch)
    assert touch.readout.mode == "zoom"
    assert bpy.ops.haptic_terrain.release() == {"FINISHED"}
    step(touch)
    assert touch.readout.mode == "normal"


def test_grab_in_contact_pans(terrain: bpy.types.Object) -> None:
    touch = start()
    bpy.data.objects["Touch Target"].location.z = -0.3
    bpy.ops.haptic_terrain.touch_update()
    step(touch, 3000)
    bpy.ops.haptic_terrain.press()
    step(touch)
    assert touch.readout.mode == "pan"


def test_a_button_that_cannot_be_pressed_says_why(terrain: bpy.types.Object) -> None:
    operators = bpy.ops.haptic_terrain
    for operator in (operators.press, operators.release, operators.twist):
        with pytest.raises(RuntimeError, match="start it first"):
            operator()
    start(device=sweep())
    for operator in (operators.press, operators.release, operators.twist):
        with pytest.raises(RuntimeError, match="A script moves this hand"):
            operator()
    module("touch.stop").stop_touch()
    start(device=sweep(), terrain=terrain, modes=True)
    with pytest.raises(RuntimeError, match="handle of its own"):
        operators.twist()
    with pytest.raises(RuntimeError, match="grab something first"):
        operators.release()
    operators.press()
    with pytest.raises(RuntimeError, match="release it first"):
        operators.press()


def test_a_refusal_of_the_servo_leaves_the_button_as_it_was(terrain: bpy.types.Object) -> None:
    from proxygraph import SessionError

    def refuse(*_arguments: object) -> None:
        raise SessionError("256 commands wait for the servo already")

    touch = start()
    session = touch.session
    touch.session = StandIn(session, press=refuse, release=refuse, set_twist=refuse)
    for operator in (bpy.ops.haptic_terrain.press, bpy.ops.haptic_terrain.twist):
        with pytest.raises(RuntimeError, match="256 commands wait"):
            operator()
    assert (touch.is_pressed, touch.twist) == (False, 0.0)
    touch.session = session
    bpy.ops.haptic_terrain.press()
    touch.session = StandIn(session, release=refuse)
    with pytest.raises(RuntimeError, match="256 commands wait"):
        bpy.ops.haptic_terrain.release()
    assert touch.is_pressed
    touch.session = session


@pytest.mark.parametrize("before", [0.0, 90.0])
def test_twists_add_up_while_the_air_is_held(terrain: bpy.types.Object, before: float) -> None:
    touch = start()
    step(touch)
    if before:
        bpy.ops.haptic_terrain.twist(degrees=before)
        step(touch)
    assert touch.session.window.turn == 0.0
    bpy.ops.haptic_terrain.press()
    step(touch)
    for degrees in (15.0, 15.0, -10.0):
        bpy.ops.haptic_terrain.twist(degrees=degrees)
        step(touch)
    assert touch.session.window.turn == pytest.approx(-math.radians(20.0))


def test_the_panel_offers_what_the_stylus_can_do(terrain: bpy.types.Object) -> None:
    touch = start()
    step(touch)
    panel = "HAPTIC_TERRAIN_PT_touch"
    running = ["haptic_terrain.touch_stop", "haptic_terrain.mouse_touch"]
    assert drawn(panel).operators == [*running, "haptic_terrain.press"]
    bpy.ops.haptic_terrain.press()
    step(touch)
    notes = drawn(panel)
    assert notes.operators[2:] == ["haptic_terrain.release"] + ["haptic_terrain.twist"] * 2
    assert [button.degrees for button in notes.buttons[3:]] == [15.0, -15.0]


def test_one_key_grabs_and_releases_and_goes_with_the_extension() -> None:
    import addon_utils
    from enable_addon import MODULE, enable

    expected = [
        ("Object Mode", "haptic_terrain.press", "E", False),
        ("Object Mode", "haptic_terrain.release", "E", False),
    ]
    assert keys() == expected
    addon_utils.disable(MODULE)
    assert keys() == []
    enable()
    assert keys() == expected


def test_the_key_is_taken_by_one_of_its_operators_at_most(terrain: bpy.types.Object) -> None:
    def takers() -> list[str]:
        names = [operator for _keymap, operator, _key, _repeat in keys()]
        return [name for name in names if getattr(bpy.ops.haptic_terrain, name.split(".")[1]).poll()]

    assert takers() == []
    start()
    assert takers() == ["haptic_terrain.press"]
    bpy.ops.haptic_terrain.press()
    assert takers() == ["haptic_terrain.release"]
