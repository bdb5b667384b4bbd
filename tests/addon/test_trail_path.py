"""The line of a touch, and the tube around it, without Blender's help."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from tests.addon.scene import module

Numbers = npt.NDArray[np.float64]


def frame(turn: float | None = None) -> Any:
    """Lay one unit a metre, from terrain metres 0."""
    return module("terrain.frame").TerrainFrame(0.0, 0.0, 0.0, 1.0, 1.0, turn)


def recorder(east: Numbers, north: Numbers, feature: Numbers | None = None) -> Any:
    """Make a take of a line on the ground with a force of 2 N."""
    count = len(east)
    columns = {
        "time": np.arange(count) / 1000.0,
        "proxy_east": east,
        "proxy_north": north,
        "force_z": np.full(count, 2.0),
        "feature": np.ones(count) if feature is None else feature,
    }
    still = dict.fromkeys(("proxy_up", "force_x", "force_y"), np.zeros(count))
    return SimpleNamespace(columns={**still, **columns})


def nothing(east: Numbers, _north: Numbers) -> Numbers:
    return np.full(len(east), math.nan)


def trails(taken: Any, spacing: float = 1.0, **options: Any) -> list[Any]:
    """Find the trails of a take."""
    found: list[Any] = module("record.trail_path").contact_trails(
        taken, options.pop("frame", frame()), options.pop("ground", nothing), spacing=spacing, **options
    )
    return found


def test_a_trembling_hand_leaves_a_point_only_where_it_gets_on() -> None:
    tick = np.arange(20_000)
    (trail,) = trails(recorder(tick * 1e-3 + 0.3 * np.sin(tick), 0.3 * np.cos(tick * 0.7)))
    assert len(trail.places) < 100
    assert trail.force == pytest.approx(np.full(len(trail.force), 2.0))


def test_points_are_never_farther_apart_than_the_spacing_and_follow_the_ground() -> None:
    line = np.linspace(0.0, 1000.0, 20)

    def hills(east: Numbers, _north: Numbers) -> Numbers:
        return np.abs(np.sin(east))

    (trail,) = trails(recorder(line, 0.5 * line), ground=hills)
    away = np.hypot(*np.diff(trail.places[:, :2], axis=0).T)
    assert away.max() <= 1.0 + 1e-9
    assert trail.places[:, 2] == pytest.approx(np.abs(np.sin(trail.places[:, 0])))


@pytest.mark.parametrize("most", [50, 5000])
def test_a_wild_take_keeps_its_bound_and_its_shape(most: int) -> None:
    angle = np.linspace(0.0, 400.0 * math.pi, 100_000)
    (trail,) = trails(recorder(100.0 * np.cos(angle), 100.0 * np.sin(angle)), most=most)
    assert 0.9 * most < len(trail.places) <= most
    if most == 5000:
        assert trail.places[:, :2].max(axis=0) == pytest.approx((100.0, 100.0), rel=0.1)
        assert np.hypot(*trail.places[:, :2].T) == pytest.approx(np.full(len(trail.places), 100.0), rel=0.1)


def test_a_take_in_pieces_has_a_trail_for_each_touch() -> None:
    line = np.arange(30.0)
    feature = np.ones(30)
    feature[10:15] = 0.0
    first, second = trails(recorder(line, 0.0 * line, feature))
    assert (first.places[0, 0], first.places[-1, 0]) == (0.0, 9.0)
    assert (second.places[0, 0], second.places[-1, 0]) == (15.0, 29.0)


def test_a_seam_parts_a_trail() -> None:
    line = np.arange(80.0, 121.0)
    found = trails(recorder(line, 0.0 * line), frame=frame(turn=100.0))
    assert [(trail.places[0, 0], trail.places[-1, 0]) for trail in found] == [(80.0, 99.0), (100.0, 120.0)]
    shape = module("record.tube").tube(found, frame(turn=100.0), 0.1)
    assert -1.0 < shape.positions[:, 0].min() < shape.positions[:, 0].max() < 100.0


def test_a_touch_that_does_not_move_has_no_trail() -> None:
    assert trails(recorder(np.zeros(100), np.zeros(100))) == []


@pytest.mark.parametrize("size", [1e-15, 1.0, 1e12])
def test_a_tube_is_round_at_any_scale_also_upright_and_where_the_hand_turns_back(size: float) -> None:
    places = size * np.array(
        [(0, 0, 0), (1, 0, 0), (2, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 1, 2), (1, 1, 3)], dtype=float
    )
    path, tubes = module("record.trail_path"), module("record.tube")
    shape = tubes.tube([path.Trail(places, np.ones(8))], frame(), 0.1 * size)
    rings = shape.positions.reshape(8, tubes.SIDES, 3) - places[:, None, :]
    assert np.linalg.norm(rings, axis=2) == pytest.approx(np.full((8, tubes.SIDES), 0.1 * size))
    for ring in rings / size:
        assert np.linalg.matrix_rank(ring, tol=1e-6) == 2
    assert shape.triangles.max() == len(shape.positions) - 1
