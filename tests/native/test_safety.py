"""The safety chain as Python sees it: limits, reasons, words."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from proxygraph import STALE_AFTER, ScriptedDevice, SimulatedDevice, Ticks

from tests.native.grounds import flat
from tests.native.touching import pressing, rows, touch, wait_until

FORCE = slice(Ticks.columns.index("force_x"), Ticks.columns.index("force_z") + 1)


def into_the_ground_at_once(depth: float = 0.01) -> ScriptedDevice:
    """In the air for a tenth of a second, and a millisecond later in the ground."""
    return ScriptedDevice([(0.1, 0.0, 0.0, 0.01), (0.101, 0.0, 0.0, -depth)])


def test_limits_are_the_lower_of_the_persons_and_the_devices() -> None:
    session = touch(flat(), SimulatedDevice(max_force=4.0, damping=0.3), stiffness=1000.0)
    assert (session.max_force, session.max_slew, session.max_speed) == (4.0, 800.0, math.inf)
    assert session.stiffness == 300.0
    assert session.warnings() == [
        "The stiffness was cut from 1000 to 300 N/m: the device would tremble with more."
    ]
    lower = touch(flat(), SimulatedDevice(), max_force=2.0, max_slew=100.0, max_speed=1.5)
    assert (lower.max_force, lower.max_slew, lower.max_speed) == (2.0, 100.0, 1.5)


@pytest.mark.parametrize("max_slew", [None, 50.0])
def test_the_force_changes_only_so_fast(max_slew: float | None) -> None:
    session = touch(flat(), into_the_ground_at_once(), max_slew=max_slew)
    session.step(300)
    forces = [row[FORCE] for row in rows(session.drain())]
    steps = [math.dist(one, other) for one, other in pairwise(forces)]
    assert max(steps) == pytest.approx((max_slew or 8.0 / 0.005) / 1000.0)
    assert forces[-1][2] == pytest.approx(5.0)
    assert session.statistics().slew_limited > 0
    told = [warning for warning in session.warnings() if "its change is limited to 50 N/s" in warning]
    assert len(told) == (max_slew is not None), "a few milliseconds are not worth a word"


def test_the_force_is_ramped_in_when_touch_begins() -> None:
    device = ScriptedDevice([(0.001, 0.0, 0.0, 0.01), (0.002, 0.0, 0.0, -0.01)])
    session = touch(flat(), device)
    session.step(60)
    forces = [row[FORCE][2] for row in rows(session.drain())]
    assert all(force <= 5.0 * (tick + 1) / 50 + 1e-9 for tick, force in enumerate(forces))
    assert forces[-1] == pytest.approx(5.0)
    assert session.statistics().ramped > 0


def test_a_hand_that_is_too_fast_feels_nothing_and_the_state_says_why() -> None:
    session = touch(flat(), into_the_ground_at_once(), max_speed=3.0)
    session.step(101)
    assert (session.state().held, session.state().force) == ("speed", (0.0, 0.0, 0.0))
    session.step(300)
    assert session.state().held == "below"
    assert session.statistics().speed_cuts == 1
    assert session.statistics().engaged == 2, "at the start, and where the hand was found again"
    assert session.state().force == (0.0, 0.0, 0.0), "it is in the ground and is not kicked out"
    below, speed = session.warnings()
    assert "under the ground, and touch begins only from above: lift it out" in below
    assert "faster than 3.0 m/s: hold it" in speed


def test_a_hand_under_the_ground_is_told_to_come_out_until_it_does() -> None:
    session = touch(flat(), SimulatedDevice(target=(0.0, 0.0, -0.01)))
    session.step(200)
    assert (session.state().held, session.state().in_contact) == ("below", False)
    session.set_target(0.0, 0.0, 0.02)
    session.step(1000)
    assert session.state().held is None
    assert session.warnings() == []
    session.set_target(0.0, 0.0, -0.01)
    session.step(1000)
    assert (session.state().held, session.state().in_contact) == (None, True)


def test_a_model_that_cannot_keep_up_is_told() -> None:
    to_and_fro = [(0.1 + 0.01 * turn, 0.07 * (-1) ** turn, 0.0, -0.01) for turn in range(20)]
    session = touch(
        flat(), ScriptedDevice([(0.0, 0.07, 0.0, 0.01), *to_and_fro]), step_budget=64, sub_step=0.01
    )
    session.step(350)
    assert session.statistics().unfinished >= 50
    assert any("had not come to the hand's place" in warning for warning in session.warnings())


def test_a_live_session_that_nobody_looks_at_gives_no_force() -> None:
    session = touch(flat(), pressing(), stale_after=STALE_AFTER)
    session.start()
    wait_until(lambda: session.statistics().host_cuts > 0)
    wait_until(lambda: session.state().force[2] > 0.0)
    wait_until(lambda: session.statistics().host_cuts > 1)

    def is_back() -> bool:
        session.heartbeat()
        return any(force > 1.0 for force in session.drain().column("force_z").tolist()[-1:])

    wait_until(is_back)
    session.stop()
    assert any("did not answer for a while" in line for line in session.warnings())


def test_a_session_is_not_waited_for_unless_it_is_asked_to() -> None:
    session = touch(flat(), pressing())
    session.start()
    wait_until(lambda: session.statistics().ticks > 300)
    session.stop()
    assert session.statistics().host_cuts == 0


@pytest.mark.parametrize(
    ("field", "value"),
    [("max_slew", -1.0), ("max_slew", math.nan), ("max_speed", 0.0), ("max_speed", math.nan)]
    + [("stale_after", value) for value in (0.0, -1.0, math.nan, math.inf)],
)
def test_a_limit_that_cannot_be(field: str, value: float) -> None:
    with pytest.raises(ValueError, match=field):
        touch(flat(), pressing(), **{field: value})
