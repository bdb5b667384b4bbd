"""Ticks to keys, without Blender's help."""

from __future__ import annotations

import numpy as np
import pytest

from tests.addon.scene import module


def test_a_key_for_each_frame_from_the_first_tick_to_the_last_frame_within() -> None:
    times = np.arange(1, 1001) / 1000.0
    felt = module("record.resample").ticks_at_frames(times, 24.0).tolist()
    assert len(felt) == 24
    assert felt[0] == 0
    assert felt == sorted(set(felt))
    for frame, tick in enumerate(felt):
        assert times[tick] - times[0] == pytest.approx(frame / 24.0, abs=0.0005001)


def test_a_frame_that_ends_with_the_ticks_has_its_key() -> None:
    times = np.arange(1001) / 1000.0
    assert len(module("record.resample").ticks_at_frames(times, 25.0)) == 26


@pytest.mark.parametrize("frames", [24.0, 25.0, 30.0, 60.0])
def test_rounding_takes_no_frame_away(frames: float) -> None:
    chosen = module("record.resample").ticks_at_frames
    for first in range(1, 200):
        seconds = 3
        times = np.arange(first, first + seconds * 1000 + 1) / 1000.0
        assert len(chosen(times, frames)) == seconds * int(frames) + 1


def test_missed_ticks_hold_the_nearest_one() -> None:
    times = np.array([0.0, 0.001, 0.002, 0.500, 0.501])
    assert module("record.resample").ticks_at_frames(times, 10.0).tolist() == [0, 2, 2, 3, 3, 3]


@pytest.mark.parametrize("times", [[], [7.0]])
def test_no_tick_has_no_key_and_one_has_one(times: list[float]) -> None:
    felt = module("record.resample").ticks_at_frames(np.array(times), 24.0)
    assert felt.tolist() == list(range(len(times)))


def test_keys_are_held_before_the_seam_and_before_a_pause_only() -> None:
    held = module("record.resample").keys_before_jumps
    near = np.arange(5) / 24.0
    assert held(np.array([0, 0, 1, 1, 0]), near).tolist() == [False, True, False, True, False]
    assert held(np.zeros(3), np.array([0.0, 0.1, 2.0])).tolist() == [False, True, False]
    assert held(np.zeros(0), np.zeros(0)).tolist() == []
