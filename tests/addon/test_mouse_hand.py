"""The hand that a mouse moves: how it follows the pointer, and how far it lets itself be pulled."""

from __future__ import annotations

import math
from typing import Any

import pytest
from mathutils import Vector

from tests.addon.scene import module
from tests.addon.test_pointer_map import FROM_ABOVE, FROM_THE_SOUTH, WORKSPACE, map_of, pixel

REST = (0.0, 0.0, 0.01)

OBLIQUE = Vector((3.0, -6.0, 5.0))


def hand(goal: tuple[float, float, float] = REST) -> Any:
    """Give one that has met the pointer before."""
    return module("touch.mouse_hand").MouseHand(goal=goal, pulled=goal, pulled_at=0.0, has_met=True)


def test_where_the_pointer_first_comes_to_a_view_the_hand_goes() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    moved.has_met = False
    place = (0.05, 0.01, 0.01)
    moved.move(pixel(seen, place), seen, catches_up=True)
    assert moved.goal == pytest.approx(place, abs=1e-6)
    assert moved.pulled == REST, "as fast as a hand does"


def test_a_hand_under_the_pointer_stays_under_it() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    moved.go_under(pixel(seen, REST), seen)
    assert moved.goal == pytest.approx(REST, abs=1e-6)
    for place in ((0.02, 0.0, 0.01), (0.02, 0.03, 0.01), (-0.05, -0.04, 0.01)):
        moved.move(pixel(seen, place), seen, catches_up=True)
        assert moved.goal == pytest.approx(place, abs=1e-6)


def test_a_hand_elsewhere_moves_as_the_pointer_does_and_comes_nearer() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    begin = (0.05, 0.0, 0.01)
    moved.move(pixel(seen, begin), seen, catches_up=True)
    assert moved.goal == REST, "where the pointer begins is no motion"
    moved.move(pixel(seen, (0.051, 0.0, 0.01)), seen, catches_up=True)
    assert 0.001 < moved.goal[0] < 0.002
    for step in range(1000):
        swing = (0.05 + 0.005 * math.sin(0.5 * step), 0.0, 0.01)
        moved.move(pixel(seen, swing), seen, catches_up=True)
    assert moved.goal == pytest.approx(swing, abs=2e-4)


def test_what_moves_under_the_pointer_is_not_run_after() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    moved.move(pixel(seen, (0.05, 0.0, 0.01)), seen, catches_up=False)
    for x in (0.06, 0.05, 0.06, 0.05):
        moved.move(pixel(seen, (x, 0.0, 0.01)), seen, catches_up=False)
    assert moved.goal == pytest.approx(REST, abs=1e-6)


def test_a_pointer_that_was_elsewhere_makes_no_jump() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    moved.go_under(pixel(seen, REST), seen)
    moved.stay()
    moved.move(pixel(seen, (-0.07, 0.05, 0.01)), seen, catches_up=True)
    assert moved.goal == pytest.approx(REST, abs=1e-6)


def test_a_pointer_out_of_reach_and_back_brings_the_hand_back() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    moved.go_under(pixel(seen, REST), seen)
    for pointer in ((1e5, -1e5), (-1e5, 3e4)):
        moved.move(pointer, seen, catches_up=True)
    moved.move(pixel(seen, REST), seen, catches_up=True)
    assert moved.goal == pytest.approx(REST, abs=1e-6)


def test_the_wheel_and_a_modifier_go_where_the_pointer_cannot() -> None:
    seen, moved = map_of(FROM_ABOVE), hand()
    moved.pointer = (400.0, 300.0)
    moved.lift_with((430.0, 310.0), seen, upright=False)
    assert moved.goal == pytest.approx((0.0, 0.0, 0.01 + 10.0 * seen.metres_per_pixel(REST)), rel=1e-2)
    along, aside = map_of(FROM_THE_SOUTH), hand()
    pointer = pixel(along, REST)
    aside.go_out(pointer, along, 0.02, upright=False)
    assert along.under(pointer, aside.goal) == pytest.approx(aside.goal, abs=1e-6)
    assert math.hypot(*aside.goal[:2]) == pytest.approx(0.02, rel=1e-2)
    height = aside.goal[2]
    aside.go_out(pointer, along, 0.02, upright=True)
    assert aside.goal[2] == pytest.approx(height + 0.02)


def test_lowered_by_the_wheel_the_hand_comes_down_where_the_pointer_is_and_presses_there() -> None:
    seen, moved = map_of(OBLIQUE), hand((0.0, 0.0, 0.02))
    spot = (0.01, -0.02, 0.0)
    pointer = pixel(seen, spot)
    moved.keep_within(WORKSPACE, 0.0)
    moved.go_under(pointer, seen)
    for _ in range(15):
        moved.go_out(pointer, seen, -0.002, upright=False)
        moved.keep_within(WORKSPACE, 0.0)
        shown = (*moved.goal[:2], max(moved.goal[2], 0.0))
        assert pixel(seen, shown) == pytest.approx(pointer, abs=0.01)
    assert moved.goal == pytest.approx((0.01, -0.02, -0.01), abs=1e-5)
    other = (0.03, 0.01, 0.0)
    moved.move(pixel(seen, other), seen, catches_up=True)
    assert moved.goal == pytest.approx((0.03, 0.01, -0.01), abs=1e-5), (
        "it goes on over the ground that is seen"
    )


def test_a_hand_cannot_jump() -> None:
    moved = hand((0.0, 0.0, 0.0))
    moved.goal = (0.03, 0.04, 0.0)
    moved.come(0.02)
    assert moved.pulled == pytest.approx((0.006, 0.008, 0.0)), "0.5 m/s"
    moved.come(0.03)
    assert math.hypot(*moved.pulled) == pytest.approx(0.015)
    moved.come(0.5)
    assert moved.pulled == pytest.approx(moved.goal)
    moved.goal = (0.08, 0.0, 0.06)
    moved.pulled = (-0.08, 0.0, 0.0)
    moved.come(100.0)
    assert math.dist(moved.pulled, (-0.08, 0.0, 0.0)) == pytest.approx(0.05), "Blender stood still"
    moved.come(90.0)
    assert math.dist(moved.pulled, (-0.08, 0.0, 0.0)) == pytest.approx(0.05), "no clock goes back"


def test_the_handle_turns_at_a_speed_and_as_far_as_it_was_told() -> None:
    moved = hand()
    moved.turn_left = -math.radians(20.0)
    turned = [moved.come(0.05 * step) for step in range(1, 5)]
    assert turned[0] == pytest.approx(-math.radians(9.0))
    assert sum(turned) == pytest.approx(-math.radians(20.0))
    assert turned[-1] == 0.0


@pytest.mark.parametrize(
    ("goal", "ground", "expected"),
    [
        ((0.5, -0.5, 0.0), 0.0, (0.08, -0.06, 0.0)),
        ((0.0, 0.0, -0.2), 0.0, (0.0, 0.0, -0.03)),
        ((0.0, 0.0, 0.2), 0.0, (0.0, 0.0, 0.06)),
        ((0.0, 0.0, 0.0), 0.25, (0.0, 0.0, 0.22)),
        ((0.0, 0.0, 0.4), 0.25, (0.0, 0.0, 0.31)),
        ((0.0, 0.0, -0.3), -0.2, (0.0, 0.0, -0.23)),
        ((0.0, 0.0, -0.2), None, (0.0, 0.0, -0.06)),
    ],
)
def test_the_hand_is_pulled_no_deeper_than_it_can_push_and_ground_lifts_it(
    goal: tuple[float, float, float], ground: float | None, expected: tuple[float, float, float]
) -> None:
    kept = hand(goal)
    kept.keep_within(WORKSPACE, ground)
    assert kept.goal == pytest.approx(expected)


def test_beside_the_map_the_hand_dives_no_deeper_than_on_it() -> None:
    kept = hand((0.0, 0.0, 0.0))
    kept.keep_within(WORKSPACE, 0.01)
    kept.goal = (0.0, 0.06, -0.05)
    kept.keep_within(WORKSPACE, None)
    assert kept.goal == pytest.approx((0.0, 0.06, -0.02))
