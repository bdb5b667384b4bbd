"""Sessions, stepped: what a tick does, as Python sees it."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from proxygraph import ScriptedDevice, Session, SessionError, SimulatedDevice, Ticks, Window

from tests.native.grounds import SIDE, flat, hills
from tests.native.touching import SCALE, over_the_middle, pressing, rows, touch, wandering


def test_stepping_twice_gives_the_same_bits() -> None:
    one, other = touch(hills(), wandering()), touch(hills(), wandering())
    one.step(1000)
    for _ in range(100):
        other.step(10)
    found = rows(one.drain())
    assert found == rows(other.drain())
    features = {row[Ticks.columns.index("feature")] for row in found}
    assert 0.0 in features
    assert len(features) > 1, "it went in and out of contact"


def test_ticks_have_a_column_of_doubles_for_each_quantity() -> None:
    session = touch(flat(), pressing())
    session.step(30)
    ticks = session.drain()
    assert len(ticks) == 30
    for name in Ticks.columns:
        column = ticks.column(name)
        assert (column.format, len(column)) == ("d", 30)
    assert ticks.column("tick").tolist() == list(range(1, 31))
    assert ticks.column("time").tolist() == [tick / 1000 for tick in range(1, 31)]
    with pytest.raises(KeyError, match="hand_w"):
        ticks.column("hand_w")
    assert len(session.drain()) == 0


def test_the_last_tick_and_the_state_agree() -> None:
    session = touch(hills(), wandering())
    session.step(333)
    state, last = session.state(), dict(zip(Ticks.columns, rows(session.drain())[-1], strict=True))
    assert (state.tick, state.time) == (333, 0.333)
    for name, axes in {"hand": "xyz", "force": "xyz"}.items():
        assert getattr(state, name) == tuple(last[f"{name}_{axis}"] for axis in axes)
    for name in ("goal", "proxy"):
        assert getattr(state, name) == tuple(last[f"{name}_{axis}"] for axis in ("east", "north", "up"))
    assert state.feature == ("free", "face", "edge", "vertex")[int(last["feature"])]
    assert state.in_contact == (last["feature"] > 0)
    assert state.mode == "normal"


def test_before_the_first_tick_all_rests_over_the_window() -> None:
    session = touch(flat(), pressing())
    state = session.state()
    assert (state.tick, state.time, state.force, state.in_contact) == (0, 0.0, (0.0, 0.0, 0.0), False)
    assert state.goal == (SIDE / 2, -SIDE / 2, 0.0)
    assert (session.running, session.fault) == (False, None)
    assert session.statistics().update_us(0.5) == 0.0


def test_statistics_are_the_sums_of_the_ticks() -> None:
    session = touch(hills(), wandering())
    session.step(900)
    counts, ticks = session.statistics(), session.drain()
    assert counts.ticks == len(ticks) == 900
    for name in ("vertices", "faces", "collision_tests", "cells"):
        assert getattr(counts, name) == sum(ticks.column(name))
    assert counts.vertices + counts.faces > 0
    assert counts.collision_tests > 0
    assert counts.cells > 0
    assert counts.contact_ticks == sum(feature > 0 for feature in ticks.column("feature"))
    places = zip(ticks.column("goal_east"), ticks.column("goal_north"), strict=True)
    way = sum(math.dist(one, other) for one, other in pairwise(places))
    assert counts.goal_cells == pytest.approx(way)
    assert (counts.missed_ticks, counts.dropped, counts.not_finite, counts.unfinished) == (0, 0, 0, 0)
    assert 0.0 < counts.update_us(0.0) <= counts.update_us(0.5) <= counts.update_us(1.0)


def test_the_spring_pushes_straight_out_of_flat_ground() -> None:
    session = touch(flat(), pressing(0.01))
    session.step(50)
    state = session.state()
    assert state.force == pytest.approx((0.0, 0.0, 5.0), abs=1e-9)
    assert state.goal[2] == pytest.approx(-0.01 / SCALE)
    assert state.proxy == pytest.approx((state.goal[0], state.goal[1], 0.0))


def test_a_scripted_hand_follows_its_path_and_stays_at_its_ends() -> None:
    path = [(0.01, 0.01, 0.0, 0.03), (0.02, 0.02, -0.04, 0.05)]
    session = touch(flat(), ScriptedDevice(path))
    session.step(30)
    hands = [row[2:5] for row in rows(session.drain())]
    assert hands[0] == hands[8] == (0.01, 0.0, 0.03)
    assert hands[14] == pytest.approx((0.015, -0.02, 0.04))
    assert hands[29] == (0.02, -0.04, 0.05)


def test_a_simulated_hand_settles_where_its_muscle_and_the_ground_balance() -> None:
    session = touch(flat(), SimulatedDevice(muscle_stiffness=300.0), stiffness=500.0)
    session.set_target(0.0, 0.0, -0.02)
    session.step(5000)
    ticks = session.drain()
    assert min(ticks.column("proxy_up")) >= 0.0, "the proxy stays on the surface"
    assert min(ticks.column("hand_z")) > -0.02, "the hand never reaches its target"
    state = session.state()
    depth = 300.0 * 0.02 / (500.0 + 300.0)
    assert state.hand == pytest.approx((0.0, 0.0, -depth), abs=1e-6)
    assert state.force == pytest.approx((0.0, 0.0, 500.0 * depth), abs=1e-3)
    assert session.state().in_contact


def test_a_simulated_hand_follows_its_target_in_the_air() -> None:
    session = touch(flat(), SimulatedDevice(target=(0.0, 0.0, 0.04)))
    session.step(1)
    assert session.state().hand == (0.0, 0.0, 0.04)
    session.set_target(0.05, -0.03, 0.02)
    session.step(5000)
    assert session.state().hand == pytest.approx((0.05, -0.03, 0.02), abs=1e-9)
    assert session.statistics().contact_ticks == 0


@pytest.mark.parametrize("of_device", [False, True])
def test_the_force_is_never_above_its_limit(of_device: bool) -> None:
    device = SimulatedDevice(max_force=1.5 if of_device else 8.0)
    session = touch(hills(), device, stiffness=5000.0, max_force=8.0 if of_device else 1.5)
    session.set_target(0.03, 0.02, -0.05)
    session.step(2000)
    forces = [math.hypot(*row[11:14]) for row in rows(session.drain())]
    assert max(forces) == pytest.approx(1.5)
    assert all(force <= 1.5 * (1.0 + 1e-12) for force in forces)
    counts, at_the_limit = session.statistics(), sum(force > 1.5 * (1.0 - 1e-12) for force in forces)
    # While it is ramped in, or its change is limited, a force that was cut is less than the limit.
    assert at_the_limit <= counts.clamped <= at_the_limit + counts.ramped + counts.slew_limited


def test_a_full_ring_drops_the_newest_ticks_and_counts_them() -> None:
    session = touch(flat(), pressing(), ring_seconds=0.01)
    session.step(25)
    assert session.statistics().dropped == 15
    assert session.drain().column("tick").tolist() == list(range(1, 11))
    session.step(5)
    assert session.drain().column("tick").tolist() == list(range(26, 31))
    assert session.statistics().dropped == 15


def test_the_window_is_moved_with_the_next_tick() -> None:
    session = touch(flat(), pressing())
    session.step(50)
    assert session.state().force[2] > 0.0
    elsewhere = Window(20.0, -30.0, 3.0, width=8.0, exaggeration=2.0)
    session.set_window(elsewhere)
    found = session.window
    assert (found.east, found.north, found.up) == (20.0, -30.0, 3.0)
    assert (found.width, found.exaggeration) == (8.0, 2.0)
    session.step(1)
    state = session.state()
    assert state.goal == pytest.approx((20.0 + 0.003 * 50.0, -30.0 + 0.001 * 50.0, 3.0 - 0.01 * 25.0))
    assert state.force == (0.0, 0.0, 0.0), "the proxy begins anew at the hand"


def test_a_device_serves_one_session() -> None:
    device = SimulatedDevice()
    first = touch(flat(), device)
    with pytest.raises(SessionError, match="another one"):
        touch(flat(), device)
    first.step(1)
    del first
    with pytest.raises(SessionError, match="another one"):
        touch(flat(), device)


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ([], "at least one point"),
        ([(0.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0)], "point 1 .* after 0 s"),
        ([(0.0, 0.0, 0.0, 0.0), (2.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)], "point 2 .* at 1 s"),
        ([(0.0, math.nan, 0.0, 0.0)], "point 0 .* not finite"),
        ([(0.0, 0.0, 0.0, 0.0), (math.nan, 0.0, 0.0, 0.0)], "point 1 .* not finite"),
        ([(0.0, 0.0, 0.0, math.inf)], "point 0 .* not finite"),
    ],
)
def test_a_path_that_cannot_be_played(path: list[tuple[float, float, float, float]], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ScriptedDevice(path)


@pytest.mark.parametrize("field", ["mass", "muscle_stiffness", "damping", "max_force"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_hand_that_cannot_be(field: str, value: float) -> None:
    with pytest.raises(ValueError, match=field):
        SimulatedDevice(**{field: value})  # type: ignore[arg-type]


@pytest.mark.parametrize("workspace", [(0.0, 0.1, 0.1), (0.1, -0.1, 0.1), (0.1, 0.1, math.nan)])
def test_a_workspace_without_size(workspace: tuple[float, float, float]) -> None:
    with pytest.raises(ValueError, match="workspace"):
        ScriptedDevice([(0.0, 0.0, 0.0, 0.0)], workspace=workspace)
    with pytest.raises(ValueError, match="workspace"):
        SimulatedDevice(workspace=workspace)


@pytest.mark.parametrize(
    ("place", "size", "words"),
    [
        ((math.nan, 0.0, 0.0), {"width": 1.0}, "east"),
        ((0.0, math.inf, 0.0), {"width": 1.0}, "north"),
        ((0.0, 0.0, math.nan), {"width": 1.0}, "up"),
        ((0.0, 0.0, 0.0), {"width": 0.0}, "width"),
        ((0.0, 0.0, 0.0), {"width": -5.0}, "width"),
        ((0.0, 0.0, 0.0), {"width": 1.0, "exaggeration": 0.0}, "exaggeration"),
    ],
)
def test_a_window_that_cannot_be(
    place: tuple[float, float, float], size: dict[str, float], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        Window(*place, **size)


@pytest.mark.parametrize(
    ("field", "value"),
    [("stiffness", -1.0), ("stiffness", math.nan), ("max_force", -1.0), ("max_force", math.inf)]
    + [("ring_seconds", value) for value in (0.0, -1.0, math.nan, 1e9)],
)
def test_a_setting_that_cannot_be(field: str, value: float) -> None:
    with pytest.raises(ValueError, match=field):
        touch(flat(), pressing(), **{field: value})


def test_a_device_of_another_kind_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="device"):
        Session(flat(), "falcon", over_the_middle())  # type: ignore[arg-type]


def test_a_refused_session_leaves_the_device_to_the_next() -> None:
    device = SimulatedDevice()
    for refused in ({"stiffness": -1.0}, {"ring_seconds": 0.0}, {"step_budget": 0}):
        with pytest.raises(ValueError, match=next(iter(refused))):
            Session(flat(), device, over_the_middle(), **refused)
    with pytest.raises(ValueError, match="workspace metres"):
        Session(flat(), device, Window(0.0, 0.0, 0.0, width=1e-320))
    Session(flat(), device, over_the_middle()).step(1)


def test_counts_and_quantiles_out_of_range_are_named() -> None:
    session = touch(flat(), pressing())
    for count in (-1, 2**70):
        with pytest.raises(ValueError, match="count"):
            session.step(count)
    for quantile in (-0.1, 1.1, math.nan):
        with pytest.raises(ValueError, match="quantile"):
            session.statistics().update_us(quantile)
        with pytest.raises(ValueError, match="quantile"):
            session.statistics().late_us(quantile)


@pytest.mark.parametrize("target", [(math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, -math.inf)])
def test_a_target_that_is_nowhere_is_refused(target: tuple[float, float, float]) -> None:
    with pytest.raises(ValueError, match=r"target [xyz]"):
        touch(flat(), SimulatedDevice()).set_target(*target)


def test_something_that_is_no_device_is_named() -> None:
    with pytest.raises(
        TypeError, match=r"device is a str; expected a ScriptedDevice, a SimulatedDevice or a PlaybackDevice"
    ):
        touch(flat(), "Falcon")  # type: ignore[arg-type]
