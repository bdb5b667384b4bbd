"""Goals between samples of an animation; without Blender's data."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.addon.scene import module


def goals_at(times: Any, places: Any, rate: float) -> Any:
    return module("record.bake_goals").goals_at(np.array(times), np.array(places, dtype=float), rate)


def column(values: list[float]) -> list[tuple[float, float, float]]:
    return [(value, -value, 2.0 * value) for value in values]


def test_samples_are_met_and_a_straight_way_stays_straight() -> None:
    times = np.arange(0.0, 3.01, 0.05)
    found = goals_at(times, column([0.0, 10.0, 20.0, 30.0]), 1.0)
    assert found[:, 0] == pytest.approx(10.0 * np.minimum(times, 3.0), abs=1e-12)
    assert found[:, 1] == pytest.approx(-found[:, 0], abs=1e-12)


def test_the_goal_never_leaves_the_box_of_its_two_samples() -> None:
    samples = [0.0, 0.0, 0.0, 7.0, 7.5, 7.5, -3.0, -2.9, 4.0, 4.0]
    times = np.arange(0.0, 9.0, 0.001)
    found = goals_at(times, column(samples), 1.0)
    for time, place in zip(times.tolist(), found[:, 0].tolist(), strict=True):
        before, after = samples[int(time)], samples[min(int(time) + 1, 9)]
        assert min(before, after) <= place <= max(before, after)


def test_the_goal_does_not_jerk_at_a_sample() -> None:
    samples = np.sin(np.arange(20) * 0.5)
    times = np.arange(1.0, 18.0, 0.001)
    speed = np.diff(goals_at(times, column(samples.tolist()), 1.0)[:, 0])
    assert np.abs(np.diff(speed)).max() < 5e-6


def test_two_samples_are_a_line_and_after_the_last_the_goal_stays() -> None:
    found = goals_at([0.0, 0.25, 0.5, 9.0], column([0.0, 1.0]), 2.0)
    assert found[:, 0].tolist() == [0.0, 0.5, 1.0, 1.0]


@pytest.mark.parametrize(
    ("frames", "rate", "ticks"), [(24, 24.0, 1001), (24, 24.0 / 1.001, 1002), (1, 1000.0, 2), (3, 120.0, 26)]
)
def test_ticks_reach_the_last_frame_and_no_further(frames: int, rate: float, ticks: int) -> None:
    times = module("record.bake_goals").tick_times(frames, rate)
    assert len(times) == ticks
    assert times[-2] < frames / rate <= times[-1] + 1e-6


def test_east_runs_on_where_an_object_went_on_at_the_other_end() -> None:
    unwrapped = module("record.bake_goals").unwrapped
    east = np.array([80.0, 95.0, 5.0, 30.0, 98.0, 60.0])
    assert unwrapped(east, 100.0).tolist() == [80.0, 95.0, 105.0, 130.0, 98.0, 60.0]
    assert unwrapped(east, None) is east


def test_an_affine_is_undone_by_its_inverse() -> None:
    affine = module("record.affine").Affine
    there = affine(((2.0, 1.0, 0.0), (0.0, 3.0, -1.0), (0.5, 0.0, 1.0)), (7.0, -8.0, 9.0))
    place = there.inverse().point(there.point((1.25, -2.5, 3.75)))
    assert place == pytest.approx((1.25, -2.5, 3.75), abs=1e-14)
    with pytest.raises(ZeroDivisionError):
        affine(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)), (0.0, 0.0, 0.0)).inverse()
