"""Contact models through Python, on random small grounds."""

from __future__ import annotations

import math
from array import array

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from proxygraph import MODELS, Contact, ContactModel, Grid, GridLayout

from tests.native.grounds import flat, ground, hills

COLUMNS, ROWS = 7, 5
HEIGHTS = st.lists(st.integers(-300, 300), min_size=COLUMNS * ROWS, max_size=COLUMNS * ROWS)
GOALS = st.lists(
    st.tuples(st.floats(0.0, COLUMNS - 1.0), st.floats(1.0 - ROWS, 0.0), st.floats(-400.0, 400.0)),
    min_size=1,
    max_size=12,
)
SLOPES = st.sampled_from([1e-4, 1e-2, 1.0, 20.0])
"""Exaggerations: from a plain to needles of 6000 cells."""
ON_THE_SURFACE = ("surface_walk", "proxy_graph")
"""Models whose proxy is a point of the surface while it is in contact."""
POINTS = st.sampled_from(ON_THE_SURFACE)

on_the_surface = pytest.mark.parametrize("name", ON_THE_SURFACE)

unhurried = settings(deadline=None, max_examples=150)


def rough(heights: list[int]) -> Grid:
    return ground([[float(height) for height in heights[row * COLUMNS :][:COLUMNS]] for row in range(ROWS)])


def slide(
    name: str,
    grid: Grid,
    goals: list[tuple[float, float, float]],
    exaggeration: float,
    budget: int | None = None,
) -> list[Contact]:
    model = ContactModel(grid, name, exaggeration=exaggeration, step_budget=budget)
    model.place(3.0, -2.0, 1000.0)
    return [model.update(*goal) for goal in goals]


def everything(contact: Contact) -> tuple[object, ...]:
    return tuple(getattr(contact, name) for name in dir(Contact) if not name.startswith("_"))


@unhurried
@given(POINTS, HEIGHTS, GOALS, SLOPES)
def test_the_proxy_is_never_under_the_surface(
    name: str, heights: list[int], goals: list[tuple[float, float, float]], exaggeration: float
) -> None:
    grid = rough(heights)
    for contact in slide(name, grid, goals, exaggeration):
        east, north, up = contact.proxy
        surface = grid.elevation_at(min(max(east, 0.0), COLUMNS - 1.0), min(max(north, 1.0 - ROWS), 0.0))
        assert surface is not None
        assert up >= surface - 1e-9 * 600.0
        if contact.in_contact:
            assert up <= surface + 1e-9 * 600.0, "it rests on the surface"


@unhurried
@given(POINTS, HEIGHTS, GOALS, SLOPES, st.integers(64, 80))
def test_every_update_ends_within_its_budget(
    name: str, heights: list[int], goals: list[tuple[float, float, float]], exaggeration: float, budget: int
) -> None:
    for contact in slide(name, rough(heights), goals, exaggeration, budget):
        assert contact.vertices + contact.faces + contact.cells <= budget
        assert all(math.isfinite(metres) for metres in contact.proxy)
    for contact in slide(name, rough(heights), goals, exaggeration):
        assert contact.steps_left == 0


@unhurried
@given(POINTS, HEIGHTS, GOALS, SLOPES)
def test_the_same_goals_give_the_same_contacts(
    name: str, heights: list[int], goals: list[tuple[float, float, float]], exaggeration: float
) -> None:
    one, other = (slide(name, rough(heights), goals, exaggeration) for _ in range(2))
    assert [everything(contact) for contact in one] == [everything(contact) for contact in other]


@unhurried
@given(POINTS, HEIGHTS, GOALS, SLOPES)
def test_distance_and_normal_lead_from_goal_to_proxy(
    name: str, heights: list[int], goals: list[tuple[float, float, float]], exaggeration: float
) -> None:
    for goal, contact in zip(goals, slide(name, rough(heights), goals, exaggeration), strict=True):
        to_proxy = [
            stretch * (proxy - hand)
            for stretch, proxy, hand in zip((1.0, 1.0, exaggeration), contact.proxy, goal, strict=True)
        ]
        assert contact.distance == pytest.approx(math.hypot(*to_proxy), rel=1e-9, abs=1e-9)
        assert [contact.distance * part for part in contact.normal] == pytest.approx(
            to_proxy if contact.distance else [0.0, 0.0, 0.0], rel=1e-9, abs=1e-9
        )


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("broken", [math.nan, math.inf, -math.inf])
def test_goals_that_are_not_finite_leave_the_proxy_where_it_is(name: str, axis: int, broken: float) -> None:
    model = ContactModel(hills(), name)
    model.place(30.3, -30.4, 10.0)
    before = model.update(30.3, -30.4, -5.0)
    goal = [31.0, -31.0, -5.0]
    goal[axis] = broken
    after = model.update(*goal)
    assert (after.proxy, after.feature) == (before.proxy, before.feature)
    assert model.update(31.0, -31.0, 20.0).proxy != before.proxy


@pytest.mark.parametrize("name", MODELS)
def test_a_goal_in_the_air_is_where_the_proxy_is(name: str) -> None:
    model = ContactModel(flat(), name)
    model.place(30.0, -30.0, 5.0)
    contact = model.update(31.5, -30.0, 4.0)
    assert (contact.proxy, contact.feature, contact.in_contact) == ((31.5, -30.0, 4.0), "free", False)
    assert (contact.distance, contact.normal) == (0.0, (0.0, 0.0, 1.0))


@on_the_surface
@pytest.mark.parametrize("goal", [(30.3, -30.4, -1.0), (30.0, -30.0, -1.0), (31.5, -30.0, -1.0)])
def test_under_flat_ground_the_proxy_is_straight_above(name: str, goal: tuple[float, float, float]) -> None:
    model = ContactModel(flat(), name)
    model.place(30.3, -30.4, 5.0)
    contact = model.update(*goal)
    assert contact.proxy == pytest.approx((goal[0], goal[1], 0.0))
    assert contact.in_contact
    assert contact.distance == pytest.approx(1.0)
    assert contact.normal == pytest.approx((0.0, 0.0, 1.0))


@on_the_surface
def test_at_the_bottom_of_a_valley_the_proxy_rests_on_an_edge(name: str) -> None:
    model = ContactModel(ground([[float(abs(column - 3)) for column in range(7)] for _ in range(7)]), name)
    model.place(3.2, -3.4, 2.0)
    contact = model.update(3.1, -3.4, -0.5)
    assert contact.feature == "edge"
    assert contact.proxy == pytest.approx((3.0, -3.4, 0.0))


@on_the_surface
def test_exaggeration_changes_what_is_nearest_and_scale_does_not(name: str) -> None:
    slope = ground([[float(column) for column in range(20)] for _ in range(20)])

    def east(scale: float, exaggeration: float) -> float:
        model = ContactModel(slope, name, scale=scale, exaggeration=exaggeration)
        model.place(10.3, -10.4, 30.0)
        return model.update(10.3, -10.4, 8.3).proxy[0]

    assert east(1.0, 1.0) == pytest.approx(10.3 - 1.0)
    assert east(0.001, 1.0) == pytest.approx(east(1.0, 1.0))
    # The foot of the perpendicular on a slope of 3, two metres (exaggerated: six) below it.
    assert east(1.0, 3.0) == pytest.approx(10.3 - 6.0 * 3.0 / 10.0)


@on_the_surface
def test_cells_need_not_be_square(name: str) -> None:
    layout = GridLayout(8, 8, cell_width=3.0, cell_height=0.5, sample="f64", byte_order="little")
    tilted = Grid.from_buffer(array("d", [float(row) for row in range(8) for _ in range(8)]), layout)
    model = ContactModel(tilted, name)
    model.place(10.0, -1.8, 20.0)
    # The ground falls 2 m a metre to the north; from a metre under it, the foot of the perpendicular.
    east, north, up = model.update(10.0, -1.8, 2.6).proxy
    assert (east, north, up) == pytest.approx((10.0, -1.8 + 0.4, 2.6 + 0.2))


@pytest.mark.parametrize(
    "bad", [{"scale": 0.0}, {"scale": -1.0}, {"exaggeration": math.nan}, {"scale": math.inf}]
)
def test_a_scale_without_size_is_refused(bad: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=next(iter(bad))):
        ContactModel(flat(), **bad)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("budget", [64, 65, 100, 4096])
def test_heights_at_the_end_of_what_a_double_holds_stay_finite(name: str, budget: int) -> None:
    model = ContactModel(ground([[0.0] * 3] * 3), name, step_budget=budget)
    model.place(0.5, -0.5, 1.7e308)
    for goal in [(1.6, -0.6, -1.7e308), (1.5, -1.5, -1.0), (0.6, -0.6, 1.7e308), (1e308, -1e308, -1e308)]:
        for _ in range(5):
            contact = model.update(*goal)
            assert all(map(math.isfinite, (*contact.proxy, *contact.normal, contact.distance)))
            if name in ON_THE_SURFACE:  # others need some steps to get anywhere at all
                assert contact.vertices + contact.faces + contact.cells <= budget
