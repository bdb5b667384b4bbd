"""The fewest keys within a bound, without Blender's help."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.addon.scene import module

Numbers = npt.NDArray[np.float64]

Clear = Callable[[Numbers], npt.NDArray[np.bool_]]

coordinate = st.floats(-1.0, 1.0, width=32)


def chosen(places: Numbers, tolerance: Numbers, clear: Clear | None = None) -> list[int]:
    """Reduce; the keys are where the point was felt."""
    found: list[int] = module("record.reduce").fewest_keys(places, tolerance, clear).tolist()
    return found


def between(places: Numbers, frames: list[int]) -> Numbers:
    """Place at every frame by the keys at some, told apart from the code under test."""
    every = np.arange(len(places))
    return np.stack([np.interp(every, frames, axis[frames]) for axis in places.T], axis=1)


def holds(places: Numbers, frames: list[int], tolerance: Numbers, clear: Clear | None = None) -> bool:
    """Whether keys at these frames keep the bound; a frame with a key always does."""
    got = between(places, frames)
    near = np.linalg.norm(got - places, axis=1) <= tolerance + 1e-12
    free = np.ones(len(places), dtype=bool) if clear is None else clear(got)
    free[frames] = True
    return bool(near.all() and free.all())


def fewest_by_trying_all(places: Numbers, tolerance: Numbers, clear: Clear | None = None) -> int:
    """Count the keys of the best choice of all."""
    last = len(places) - 1
    for count in range(last):
        for inner in combinations(range(1, last), count):
            if holds(places, [0, *inner, last], tolerance, clear):
                return count + 2
    return last + 1


paths = st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=2, max_size=9).map(
    lambda places: np.cumsum(np.array(places), axis=0)
)


@given(paths, st.floats(0.01, 2.0))
@settings(max_examples=150, deadline=None)
def test_no_choice_of_keys_is_smaller(places: Numbers, bound: float) -> None:
    tolerance = np.full(len(places), bound)
    frames = chosen(places, tolerance)
    assert frames[0] == 0
    assert frames[-1] == len(places) - 1
    assert holds(places, frames, tolerance)
    assert len(frames) == fewest_by_trying_all(places, tolerance)


@given(paths, st.floats(0.05, 2.0))
@settings(max_examples=150, deadline=None)
def test_no_choice_is_smaller_over_a_ground_that_buries(places: Numbers, bound: float) -> None:
    def hill(points: Numbers) -> Numbers:
        return np.sin(3.0 * points[:, 0]) * np.cos(2.0 * points[:, 1])

    places[:, 2] = hill(places) + np.abs(places[:, 2])

    def clear(points: Numbers) -> npt.NDArray[np.bool_]:
        return np.asarray(points[:, 2] >= hill(points) - 1e-9)

    tolerance = np.full(len(places), bound)
    frames = chosen(places, tolerance, clear)
    assert holds(places, frames, tolerance, clear)
    assert len(frames) == fewest_by_trying_all(places, tolerance, clear)


@given(st.integers(0, 2**32 - 1), st.integers(3, 400), st.floats(1e-3, 1.0))
@settings(max_examples=60, deadline=None)
def test_a_long_way_stays_within_its_bound_at_every_frame(seed: int, count: int, bound: float) -> None:
    random = np.random.default_rng(seed)
    places = np.cumsum(
        random.normal(size=(count, 3)) * random.choice([0.0, 0.01, 0.3], size=(count, 1)), axis=0
    )
    tolerance = bound * random.uniform(0.5, 2.0, size=count)
    frames = chosen(places, tolerance)
    assert frames == sorted(set(frames))
    assert holds(places, frames, tolerance)


@pytest.mark.parametrize("count", [1, 2, 3, 5000])
def test_a_hand_that_rests_or_goes_straight_needs_its_ends_only(count: int) -> None:
    rest = np.ones((count, 3))
    straight = np.linspace((0.0, 1.0, 2.0), (5.0, -3.0, 7.0), count)
    for places in (rest, straight):
        assert chosen(places, np.full(count, 1e-6)) == sorted({0, count - 1})


def test_without_room_every_frame_of_a_bent_way_has_its_key() -> None:
    angle = np.linspace(0.0, 6.0, 50)
    places = np.stack((np.cos(angle), np.sin(angle), angle), axis=1)
    assert chosen(places, np.zeros(50)) == list(range(50))


def test_keys_say_at_every_frame_what_straight_lines_say_and_stay_where_they_are_held() -> None:
    at = module("record.reduce").at_every_frame
    frames, values = np.array([10, 14, 15, 17]), np.array([[0.0], [8.0], [100.0], [104.0]])
    held = np.array([False, True, False, False])
    assert at(frames, values, held)[:, 0].tolist() == [0.0, 2.0, 4.0, 6.0, 8.0, 100.0, 102.0, 104.0]
    assert at(frames[:2], values[:2], np.array([True, False]))[:, 0].tolist() == [0.0] * 4 + [8.0]
    assert at(frames[:1], values[:1], held[:1])[:, 0].tolist() == [0.0]
