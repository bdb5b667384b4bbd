"""Dropping samples to keep the frame rate, in stepped time."""

from __future__ import annotations

from collections.abc import Callable

from addon.terrain.levels.steering import FEWEST, FIRST_WAIT, LOOK, PAUSE, QUICK, REST, SLOW, Steering

MOST = 256_000


def run(steering: Steering, frame: Callable[[int], float], seconds: float) -> list[int]:
    """Let frames come whose length depends on the vertices; gives each budget that was held."""
    held, passed = [steering.budget], 0.0
    while passed < seconds:
        length = frame(steering.budget)
        steering.frame(length)
        passed += length
        if steering.budget != held[-1]:
            held.append(steering.budget)
    return held


def test_quick_frames_keep_all_vertices() -> None:
    assert run(Steering(MOST), lambda _budget: 1.0 / 60.0, 60.0) == [MOST]


def test_slow_frames_halve_the_vertices_until_they_are_quick_enough() -> None:
    steering = Steering(MOST)
    held = run(steering, lambda budget: 0.2 * budget / MOST, 20.0)
    assert held[:4] == [MOST, MOST // 2, MOST // 4, MOST // 8]
    assert 0.2 * steering.budget / MOST <= SLOW


def test_very_slow_frames_are_not_borne_for_long() -> None:
    steering = Steering(MOST)
    for _ in range(7):
        steering.frame(1.5)
    assert steering.budget == MOST // 2


def test_a_few_slow_frames_change_nothing() -> None:
    steering = Steering(MOST)
    for number in range(20 * LOOK):
        steering.frame(0.2 if number % 4 == 0 else 1.0 / 60.0)
    assert steering.budget == MOST


def test_pauses_are_no_frames() -> None:
    steering = Steering(MOST)
    for _ in range(10 * LOOK):
        steering.frame(PAUSE)
    assert steering.budget == MOST


def test_vertices_come_back_when_frames_are_quick_again() -> None:
    steering = Steering(MOST)
    run(steering, lambda budget: 0.2 * budget / MOST, 10.0)
    assert steering.budget < MOST
    held = run(steering, lambda _budget: 1.0 / 60.0, 10.0 * FIRST_WAIT)
    assert held[-1] == MOST


def test_they_come_back_ever_more_rarely_where_that_makes_frames_slow() -> None:
    steering = Steering(MOST)
    changes = len(run(steering, lambda budget: 0.05 if budget == MOST else QUICK * 0.9, 60.0))
    later = len(run(steering, lambda budget: 0.05 if budget == MOST else QUICK * 0.9, 240.0))
    assert changes > 2
    assert later / 240.0 < changes / 60.0 / 2.0


def test_between_slow_and_quick_nothing_changes() -> None:
    steering = Steering(MOST)
    steering.halvings = 1
    assert run(steering, lambda _budget: (SLOW + QUICK) / 2.0, 60.0) == [MOST // 2]


def test_what_something_else_makes_slow_costs_no_vertices() -> None:
    steering = Steering(MOST)
    held = run(steering, lambda _budget: 0.1, REST / 2.0)
    assert held == [MOST, MOST // 2, MOST]


def test_there_are_never_too_few() -> None:
    steering = Steering(MOST)
    run(steering, lambda budget: 10.0 * budget / MOST, 300.0)
    assert steering.budget >= FEWEST
    few = Steering(100)
    run(few, lambda _budget: 0.5, 60.0)
    assert few.budget == 100


def test_refreshes_that_hold_blender_up_halve_the_vertices() -> None:
    steering = Steering(MOST)
    for _ in range(100):
        steering.refresh(0.03 * steering.budget / MOST)
    assert steering.budget == MOST // 4
    run(steering, lambda _budget: 1.0 / 60.0, 30.0)
    assert steering.budget == MOST // 4
