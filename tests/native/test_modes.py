"""Modes of interaction as Python sees them: a button, a window that follows, columns that tell."""

from __future__ import annotations

import math
from typing import Any

import pytest
from proxygraph import ScriptedDevice, Session, SessionError, SimulatedDevice, Ticks, Window

from tests.native.grounds import SIDE, flat
from tests.native.touching import SCALE, over_the_middle, touch, wait_until


def modal(device: ScriptedDevice | SimulatedDevice, **settings: Any) -> Session:
    return Session(flat(), device, over_the_middle(), walls=True, modes=True, **settings)


def dragging() -> ScriptedDevice:
    """Down into the ground, then pressed, 2 cm to the right, and let go at rest."""
    path = [(0.0, 0.0, 0.0, 0.02), (0.1, 0.0, 0.0, -0.005), (0.2, 0.0, 0.0, -0.005), (0.5, 0.02, 0.0, -0.005)]
    return ScriptedDevice(path, handle=[(0.0, 0.0, 0), (0.15, 0.0, 1), (2.0, 0.0, 0)])


def lifting() -> ScriptedDevice:
    """In the air, pressed, 2 cm up while the handle is turned by a quarter, and let go."""
    path = [(0.0, 0.0, 0.0, 0.02), (0.2, 0.0, 0.0, 0.02), (0.5, 0.0, 0.0, 0.04)]
    handle = [(0.0, 0.0, 0), (0.15, 0.0, 1), (0.5, math.pi / 2, 1), (0.6, math.pi / 2, 0)]
    return ScriptedDevice(path, handle=handle)


def test_a_pan_moves_the_window_and_not_the_terrain() -> None:
    session = modal(dragging())
    session.step(1900)
    state = session.state()
    assert state.mode == "pan"
    assert state.proxy == pytest.approx((SIDE / 2, -SIDE / 2, 0.0), abs=1e-9)
    assert state.window.east == pytest.approx(SIDE / 2 - 0.02 / SCALE, abs=0.05)
    assert (session.window.east, session.window.north) == (state.window.east, state.window.north)
    session.step(200)
    assert session.state().mode == "normal"
    assert session.statistics().mode_changes == 2


def test_a_zoom_narrows_and_turns_the_window() -> None:
    session = modal(lifting())
    session.step(700)
    window = session.window
    assert session.state().mode == "normal"
    assert window.width == pytest.approx(over_the_middle().width / 2)
    assert window.turn == pytest.approx(-math.pi / 2)
    assert session.state().goal[:2] == pytest.approx((SIDE / 2, -SIDE / 2))
    assert window.exaggeration == 1.0


def test_every_tick_tells_its_mode_and_window() -> None:
    session = modal(lifting())
    session.step(700)
    ticks = session.drain()
    assert Ticks.columns[-12:-5] == (
        "mode",
        "window_east",
        "window_north",
        "window_up",
        "window_width",
        "window_exaggeration",
        "window_turn",
    )
    assert set(ticks.column("mode")) == {0.0, 2.0}
    window = session.window
    for name in ("east", "north", "up", "width", "exaggeration", "turn"):
        assert ticks.column(f"window_{name}")[-1] == getattr(window, name)
    assert ticks.column("window_width")[0] == over_the_middle().width


def test_keys_and_scripts_change_the_mode() -> None:
    session = modal(SimulatedDevice(target=(0.0, 0.0, 0.03)))
    session.step(10)
    session.press()
    session.set_twist(0.0)
    session.step(1)
    assert session.state().mode == "zoom"
    session.set_twist(0.5)
    session.step(1)
    assert session.window.turn == pytest.approx(-0.5)
    session.release()
    session.step(1)
    assert session.state().mode == "normal"
    session.set_mode("pan")
    session.step(1)
    assert session.state().mode == "pan"
    session.set_mode("normal")
    session.step(1)
    assert session.state().mode == "normal"


def test_a_live_session_takes_keys_and_its_window_follows() -> None:
    session = modal(SimulatedDevice(target=(0.0, 0.0, 0.03)), real_time=False)
    session.start()
    wait_until(lambda: session.state().tick > 0)
    session.press()
    wait_until(lambda: session.state().mode == "zoom")
    session.set_target(0.0, 0.0, 0.05)
    wait_until(lambda: session.window.width < 0.9 * over_the_middle().width)
    session.release()
    wait_until(lambda: session.state().mode == "normal")
    session.stop()


def test_without_modes_there_is_none_to_ask_for_and_a_button_does_nothing() -> None:
    session = touch(flat(), lifting())
    session.step(700)
    assert session.window.width == over_the_middle().width
    assert session.statistics().mode_changes == 0
    for ask in (session.press, session.release, lambda: session.set_mode("zoom")):
        with pytest.raises(SessionError, match="without modes"):
            ask()


def test_walls_hold_the_hand_where_they_are_asked_for() -> None:
    beside = [(0.0, 0.0, 0.0, 0.02), (0.2, 0.076, 0.0, 0.02)]
    for walls, force in ((True, -2.0), (False, 0.0)):
        session = Session(flat(), ScriptedDevice(beside), over_the_middle(), walls=walls)
        session.step(400)
        assert session.state().force == pytest.approx((force, 0.0, 0.0), abs=1e-9)


def test_a_turned_window_turns_the_hand() -> None:
    device = ScriptedDevice([(0.0, 0.03, 0.01, 0.02)])
    turn = 0.4
    session = Session(flat(), device, Window(20.0, -30.0, 0.0, width=16.0, turn=turn))
    session.step(1)
    east, north = (
        20.0 + 100.0 * (0.03 * math.cos(turn) - 0.01 * math.sin(turn)),
        -30.0 + 100.0 * (0.03 * math.sin(turn) + 0.01 * math.cos(turn)),
    )
    assert session.state().goal == pytest.approx((east, north, 2.0))
    assert "turn=0.4" in repr(session.window)


def test_a_puck_steers_by_velocity_and_the_ground_holds_its_hand() -> None:
    device = ScriptedDevice(
        [(0.0, 0.0, 0.0, -1.0), (1.5, 0.0, 0.0, -1.0), (1.501, 0.0, 0.0, 0.0)], by_velocity=True
    )
    session = Session(flat(), device, over_the_middle())
    session.step(1000)
    assert session.state().hand[2] == pytest.approx(-0.0008, abs=1e-5)
    assert session.state().force[2] == pytest.approx(0.4, abs=1e-2)
    session.step(600)
    assert session.state().hand[2] == pytest.approx(0.0, abs=1e-6), "it springs back"


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"pan_mass": 0.0}, "pan_mass"),
        ({"drift_time": math.nan}, "drift_time"),
        ({"zoom_travel": -1.0}, "zoom_travel"),
        ({"detent_force": math.inf}, "detent_force"),
        ({"zoom_widths": (2.0, 1.0)}, "widest"),
        ({"zoom_widths": (0.0, 1.0)}, "narrowest"),
    ],
)
def test_numbers_that_no_mode_can_have_are_refused(settings: dict[str, Any], words: str) -> None:
    device = SimulatedDevice()
    with pytest.raises(ValueError, match=words):
        modal(device, **settings)
    modal(device)


def test_names_angles_and_handles_that_cannot_be_are_refused() -> None:
    session = modal(SimulatedDevice())
    with pytest.raises(ValueError, match="'fly'"):
        session.set_mode("fly")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="twist"):
        session.set_twist(math.nan)
    with pytest.raises(ValueError, match="turn"):
        Window(0.0, 0.0, 0.0, width=1.0, turn=math.inf)
    with pytest.raises(ValueError, match="after"):
        ScriptedDevice([(0.0, 0.0, 0.0, 0.0)], handle=[(1.0, 0.0, 0), (0.5, 0.0, 1)])
