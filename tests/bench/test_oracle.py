"""The benches' judge sees what is wrong."""

from __future__ import annotations

import math
import random
from itertools import pairwise

import pytest

from tests.bench.hand import Field, wander
from tests.bench.oracle import Oracle, Vector, closest_on_triangle


def hills(column: int, row: int) -> float:
    return math.sin(0.7 * column) + math.cos(0.9 * row)


def lowered(point: Vector, depth: float) -> Vector:
    return point[0], point[1], point[2] - depth


def test_the_surface_lies_on_the_diagonal_that_touch_uses() -> None:
    oracle = Oracle(lambda column, row: 8.0 if (column, row) == (0, 1) else 0.0)
    assert oracle.height(0.75, 0.25) == 0.0
    assert oracle.height(0.25, 0.75) == 4.0
    assert oracle.depth((0.25, 0.75, 3.0)) == 1.0


def test_on_flat_ground_only_the_point_above_the_goal_is_a_minimum() -> None:
    oracle = Oracle(lambda _column, _row: 0.0)
    goal = (5.3, 5.4, -1.0)
    assert oracle.is_minimum((5.3, 5.4, 0.0), goal)
    assert not oracle.is_minimum((5.3, 5.41, 0.0), goal)
    assert not oracle.is_minimum((5.0, 5.0, 0.0), goal)
    assert not oracle.is_minimum((7.0, 5.4, 0.0), goal)


def test_a_goal_above_the_surface_is_free() -> None:
    oracle = Oracle(hills)
    proxy = (5.3, 5.4, oracle.height(5.3, 5.4))
    assert not oracle.is_minimum(proxy, lowered(proxy, -0.5))


def test_cells_that_are_not_square_change_what_is_nearest() -> None:
    def slope(_column: int, row: int) -> float:
        return float(row)

    # A rise of one in a length of one, and of one in a length of a half.
    assert Oracle(slope).is_minimum((5.3, 5.0, 5.0), (5.3, 6.0, 4.0))
    assert not Oracle(slope, 0.5).is_minimum((5.3, 5.0, 5.0), (5.3, 6.0, 4.0))
    assert Oracle(slope, 0.5).is_minimum((5.3, 5.0, 5.0), (5.3, 9.0, 4.0))


def test_no_point_of_a_triangle_is_closer_than_the_closest() -> None:
    chance = random.Random(5)

    def somewhere() -> Vector:
        return chance.gauss(0.0, 1.0), chance.gauss(0.0, 1.0), chance.gauss(0.0, 1.0)

    for _ in range(300):
        a, b, c, point = (somewhere() for _ in range(4))
        closest = math.dist(closest_on_triangle(point, (a, b, c)), point)
        nearest_of_many = math.inf
        for i in range(21):
            for j in range(21 - i):
                s, t = i / 20, j / 20
                inside = [p + s * (q - p) + t * (r - p) for p, q, r in zip(a, b, c, strict=True)]
                nearest_of_many = min(nearest_of_many, math.dist(inside, point))
        assert closest <= nearest_of_many + 1e-12
        assert closest >= nearest_of_many - 0.5, "it lies on the triangle"


@pytest.mark.parametrize("speed", [0.3, 13.4, 50.0])
def test_the_hand_keeps_its_speed_and_its_field(speed: float) -> None:
    field = Field(10.0, 200.0, 20.0, 120.0)
    height = Oracle(hills).height
    places = list(wander(field, height, speed, 20_000, seed=1))
    assert all(10.0 <= columns <= 200.0 and 20.0 <= rows <= 120.0 for columns, rows, _ in places)
    ways = [math.dist(one[:2], other[:2]) for one, other in pairwise(places)]
    assert max(ways) <= speed + 1e-9
    assert sorted(ways)[len(ways) // 2] == pytest.approx(speed)
    depths = [height(columns, rows) - z for columns, rows, z in places]
    assert min(depths) < 0.5 < 2.0 < max(depths)
    assert places == list(wander(field, height, speed, 20_000, seed=1))
