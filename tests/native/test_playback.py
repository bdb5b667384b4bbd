"""Hands that are played again, as Python sees them."""

from __future__ import annotations

import math
from array import array

import pytest
from proxygraph import MODELS, PlaybackDevice, Session, Take

from tests.native.grounds import hills
from tests.native.touching import over_the_middle, touch, wait_until, wandering

HAND = ("time", "hand_x", "hand_y", "hand_z")
PROXY = ("proxy_east", "proxy_north", "proxy_up")


def recorded(session: Session, ticks: int) -> Take:
    session.start_recording()
    session.step(ticks)
    return session.stop_recording()


def bits(take: Take, names: tuple[str, ...]) -> list[bytes]:
    return [take.column(name).tobytes() for name in names]


def test_the_same_model_gives_the_same_proxy_to_the_bit() -> None:
    take = recorded(touch(hills(), wandering()), 900)
    played = PlaybackDevice(*(take.column(name) for name in HAND))
    again = recorded(Session(hills(), played, over_the_middle()), 900)
    assert bits(again, PROXY) == bits(take, PROXY)
    of_take = PlaybackDevice.of_take(take)
    window = of_take.window
    assert window is not None
    assert bits(recorded(Session(hills(), of_take, window), 900), PROXY) == bits(take, PROXY)


def test_every_model_is_led_over_the_same_motion() -> None:
    take = recorded(touch(hills(), wandering()), 900)
    for model in MODELS:
        other = recorded(Session(hills(), PlaybackDevice.of_take(take), over_the_middle(), model=model), 900)
        assert bits(other, HAND[1:]) == bits(take, HAND[1:])


def test_any_sequence_of_numbers_is_played_and_ends() -> None:
    device = PlaybackDevice([0.0, 0.1], (0.0, 0.02), array("d", [0.0, 0.0]), [0.03, 0.03], speed=2.0)
    assert device.seconds == pytest.approx(0.05)
    session = touch(hills(), device)
    session.step(26)
    assert session.state().hand[0] == pytest.approx(0.01)
    assert not device.finished
    session.step(100)
    state = session.state()
    assert device.finished
    assert (state.hand, state.force, state.held) == ((0.02, 0.0, 0.03), (0.0, 0.0, 0.0), "finished")
    assert device.window is None


def test_a_take_is_played_live_to_its_end() -> None:
    take = recorded(touch(hills(), wandering()), 900)
    device = PlaybackDevice.of_take(take, speed=10.0)
    session = Session(hills(), device, over_the_middle())
    session.start()
    wait_until(lambda: session.state().held == "finished")
    session.stop()
    assert device.finished
    assert session.fault is None


def test_buttons_are_pressed_again() -> None:
    columns = [[0.0, 0.05, 0.1], [0.0] * 3, [0.0] * 3, [0.03] * 3]
    device = PlaybackDevice(*columns, buttons=[0, 1, 0], twist=[0.5] * 3)
    session = touch(hills(), device, modes=True)
    take = recorded(session, 100)
    assert take.column("buttons").tolist() == [0.0] * 50 + [1.0] * 50
    assert set(take.column("mode").tolist()) == {0.0, 2.0}


def test_a_take_whose_window_was_moved_leads_over_the_same_ground() -> None:
    session = touch(hills(), wandering(), modes=True)
    session.start_recording()
    for mode in ("normal", "zoom", "normal", "pan", "normal"):
        session.set_mode(mode)
        session.step(180)
    take = session.stop_recording()
    assert len(set(take.column("window_width").tolist())) > 1
    device = PlaybackDevice.of_take(take)
    assert device.window is not None
    again = recorded(Session(hills(), device, device.window), 900)
    for name in ("goal_east", "goal_north", "goal_up"):
        assert again.column(name).tolist() == pytest.approx(take.column(name).tolist(), abs=1e-5)


@pytest.mark.parametrize(
    ("columns", "words"),
    [
        ([[], [], [], []], "at least one point"),
        ([[0.0, 0.0], [0.0] * 2, [0.0] * 2, [0.0] * 2], r"point 1 .* is at 0 s"),
        ([[0.0, 1.0], [0.0] * 2, [0.0] * 2, [0.0, math.nan]], "point 1 .* not finite"),
        ([[0.0, 1.0], [0.0] * 2, [0.0], [0.0] * 2], "hand_y has 1 values; expected 2"),
    ],
)
def test_columns_that_cannot_be_played_are_refused(columns: list[list[float]], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        PlaybackDevice(*columns)


def test_numbers_that_cannot_be_are_refused() -> None:
    one = [[0.0], [0.0], [0.0], [0.0]]
    for speed in (0.09, 101.0, math.nan, -1.0):
        with pytest.raises(ValueError, match="speed"):
            PlaybackDevice(*one, speed=speed)
    for pressed in (-1.0, 0.5, math.nan, 2.0**32):
        with pytest.raises(ValueError, match=r"buttons\[0\]"):
            PlaybackDevice(*one, buttons=[pressed])
    with pytest.raises(ValueError, match="workspace width"):
        PlaybackDevice(*one, workspace=(0.0, 0.1, 0.1))
    with pytest.raises(TypeError):
        PlaybackDevice("abc", *one[1:])  # type: ignore[arg-type]


def test_an_empty_take_is_refused() -> None:
    with pytest.raises(ValueError, match="at least one point"):
        PlaybackDevice.of_take(recorded(touch(hills(), wandering()), 0))
