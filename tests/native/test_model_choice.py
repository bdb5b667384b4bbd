"""Choosing contact models: names, knobs, what is refused, and switching in touch."""

from __future__ import annotations

import math
from itertools import pairwise, permutations

import pytest
from proxygraph import (
    MODELS,
    ContactModel,
    Session,
    SimulatedDevice,
    Ticks,
    Window,
    model_descriptions,
)

from tests.native.grounds import SIDE, flat, ground, hills
from tests.native.touching import over_the_middle, pressing, rows, touch, wait_until, wandering

SLEW = 8.0 / 0.05 * 0.001
"""Newtons that the force may change in a tick after a switch: 8 N in 50 ms."""

REFUSED = [
    ({"model": "walk"}, r"model is 'walk'; expected one of surface_walk, proxy_graph, god_object"),
    ({"model": ""}, "model is ''; expected one of"),
    ({"step_budget": 0}, "step_budget is 0; expected a whole number from 64"),
    ({"step_budget": 63}, "step_budget is 63; expected a whole number from 64"),
    ({"model": "virtual_proxy", "step_budget": 63}, "step_budget is 63; expected a whole number from 64"),
    ({"step_budget": -3}, "step_budget is -3"),
    ({"step_budget": 2**200}, "step_budget is a number above"),
    ({"sub_step": 0.0}, "sub_step is 0; expected a finite number of cells above zero"),
    ({"sub_step": -1.0}, "sub_step is -1"),
    ({"sub_step": 0.0099}, "sub_step is 0.0099; expected at least 0.01 cells"),
    ({"sub_step": 1e-300}, "sub_step is .*; expected at least 0.01 cells"),
    ({"sub_step": math.nan}, "sub_step is NaN"),
    ({"sub_step": math.inf}, "sub_step is inf"),
    ({"model": "proxy_graph", "sub_step": 1.0}, "sub_step is 1 with model 'proxy_graph'.*only surface_walk"),
    ({"model": "virtual_proxy", "radius": 0.0}, "radius is 0; expected a finite number of workspace metres"),
    ({"model": "virtual_proxy", "radius": -0.001}, "radius is -0.001"),
    ({"model": "virtual_proxy", "radius": math.nan}, "radius is NaN"),
    ({"radius": 0.001}, "radius is 0.001 with model 'surface_walk'.*only virtual_proxy"),
]


def test_every_model_has_a_line_for_those_who_choose() -> None:
    assert MODELS == ("surface_walk", "proxy_graph", "god_object", "god_object_release", "virtual_proxy")
    assert tuple(model_descriptions()) == MODELS
    for line in model_descriptions().values():
        assert len(line) > 20
        assert not line.endswith("."), "Blender ends its tooltips itself"


@pytest.mark.parametrize("name", MODELS)
def test_a_model_and_a_session_tell_their_names(name: str) -> None:
    assert ContactModel(flat(), name).name == name
    session = touch(flat(), pressing(), model=name)
    assert session.model == name
    session.step(1)
    assert session.state().model == name


def test_the_walk_is_the_default() -> None:
    assert ContactModel(flat()).name == touch(flat(), pressing()).model == MODELS[0] == "surface_walk"


def test_a_budget_that_is_left_out_is_the_models_own() -> None:
    assert ContactModel(flat(), step_budget=77).step_budget == 77
    assert ContactModel(flat()).step_budget == ContactModel(flat(), step_budget=None).step_budget >= 100


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("asked", [64, 99, 100, 3000])
def test_the_budget_that_is_told_is_the_one_in_force(name: str, asked: int) -> None:
    model = ContactModel(hills(), name, step_budget=asked, sub_step=None)
    assert model.step_budget == max(asked, 100 if name == "virtual_proxy" else 64)
    model.place(5.0, -5.0, 100.0)
    for goal in [(5.0, -5.0, -5.0), (50.0, -50.0, -5.0), (5.0, -50.0, -5.0)]:
        contact = model.update(*goal)
        assert contact.vertices + contact.faces + contact.cells <= model.step_budget


def test_a_sphere_tells_the_radius_that_its_budget_can_look_at() -> None:
    assert ContactModel(flat(), "surface_walk").radius is None
    assert ContactModel(flat(), "virtual_proxy", radius=0.25).radius == pytest.approx(0.25)
    assert ContactModel(flat(), "virtual_proxy", scale=0.1).radius == pytest.approx(0.05)
    cut = ContactModel(flat(), "virtual_proxy", scale=0.1, radius=5.0, step_budget=1024).radius
    smaller = ContactModel(flat(), "virtual_proxy", scale=0.1, radius=5.0, step_budget=100).radius
    assert cut is not None
    assert smaller is not None
    assert 0.0 < smaller < cut < 1.0

    model = ContactModel(flat(), "virtual_proxy", scale=0.1, radius=5.0, step_budget=1024)
    model.place(30.0, -30.0, 20.0)
    # A cell is 1 m of terrain, and 0.1 m of workspace.
    assert model.update(30.0, -30.0, -1.0).proxy[2] == pytest.approx(cut / 0.1)


@pytest.mark.parametrize(("choice", "words"), REFUSED)
def test_a_choice_that_cannot_be_is_refused_by_name(choice: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ContactModel(flat(), **choice)  # type: ignore[arg-type]
    device = SimulatedDevice()
    with pytest.raises(ValueError, match=words):
        Session(flat(), device, over_the_middle(), **choice)  # type: ignore[arg-type]
    session = Session(flat(), device, over_the_middle(), model="proxy_graph")
    with pytest.raises(ValueError, match=words):
        session.set_model(**{"model": "surface_walk", **choice})  # type: ignore[arg-type]
    assert session.model == "proxy_graph", "a refused call changes nothing"


def test_a_sphere_stays_its_radius_above_flat_ground() -> None:
    def height(**knobs: float) -> float:
        model = ContactModel(flat(), "virtual_proxy", scale=0.1, **knobs)  # type: ignore[arg-type]
        model.place(30.0, -30.0, 5.0)
        return model.update(30.0, -30.0, -1.0).proxy[2]

    # A cell is 1 m of terrain, and 0.1 m of workspace.
    assert height(radius=0.02) == pytest.approx(0.2)
    assert height() == pytest.approx(0.5), "half a cell"


def test_a_sessions_sphere_has_a_radius_of_a_millimetre() -> None:
    session = touch(flat(), pressing(0.005), model="virtual_proxy")
    session.step(50)
    # 1 m of terrain is 1 cm of workspace.
    assert session.state().proxy[2] == pytest.approx(0.1)


def test_sub_steps_follow_a_fast_hand_more_faithfully() -> None:
    sines = [math.sin(1.7 * number * number) for number in range(SIDE)]
    rough = ground(
        [[3.0 * sines[(row * 37 + column * 11) % SIDE] for column in range(SIDE)] for row in range(SIDE)]
    )

    def ends(sub_step: float | None) -> list[tuple[float, float, float]]:
        found = []
        for number in range(1, 40):
            model = ContactModel(rough, sub_step=sub_step)
            model.place(20.3, -20.4, 10.0)
            model.update(20.3, -20.4, -4.0)
            around = 0.16 * number
            found.append(
                model.update(20.3 + 13.4 * math.cos(around), -20.4 + 13.4 * math.sin(around), -4.0).proxy
            )
        return found

    faithful = ends(0.1)

    def error(sub_step: float | None) -> float:
        return sum(math.dist(end, best) for end, best in zip(ends(sub_step), faithful, strict=True))

    assert error(0.25) < error(1.0) < error(None)


@pytest.mark.parametrize(("one", "other"), list(permutations(MODELS, 2)))
def test_a_switch_in_touch_keeps_contact_and_makes_no_jolt(one: str, other: str) -> None:
    session = touch(hills(), SimulatedDevice(), model=one)
    session.set_target(0.02, 0.01, -0.04)
    session.step(1000)
    assert session.state().in_contact
    before = session.state().force
    session.drain()
    session.set_model(other)
    assert session.model == other
    session.step(100)
    ticks = session.drain()
    assert min(ticks.column("feature")) > 0.0
    forces = [before, *(row[11:14] for row in rows(ticks))]
    assert Ticks.columns[11:14] == ("force_x", "force_y", "force_z")
    # The hand stood still before; the ground under it is smooth.
    assert max(math.dist(a, b) for a, b in pairwise(forces)) <= SLEW * (1.0 + 1e-9)


def test_a_switch_in_touch_makes_the_new_model_answer() -> None:
    session = touch(hills(), wandering(), model="proxy_graph")
    session.step(300)
    assert sum(session.drain().column("faces")) == 0
    session.set_model("surface_walk", sub_step=0.25)
    assert session.model == "surface_walk"
    session.step(600)
    ticks = session.drain()
    assert session.state().model == "surface_walk"
    assert sum(ticks.column("faces")) > 0
    assert session.statistics().faces == sum(ticks.column("faces"))


def test_a_live_session_switches() -> None:
    session = touch(flat(), pressing(), model="proxy_graph")
    session.start()
    wait_until(lambda: session.state().force[2] > 0.0)
    for name in ("god_object_release", "virtual_proxy", "surface_walk"):
        session.set_model(name)
        wait_until(lambda name=name: session.state().model == name)  # type: ignore[misc]
        assert session.state().in_contact
    session.stop()
    assert session.fault is None


def test_a_switch_works_on_a_window_off_the_map() -> None:
    session = Session(ground([[0.0] * 2] * 2), pressing(), Window(50.0, -50.0, 0.0, width=16.0))
    for name in MODELS:
        session.set_model(name)
        session.step(10)
    assert session.state().force == (0.0, 0.0, 0.0)
