"""Many goals in one call."""

from __future__ import annotations

import math
from array import array

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from proxygraph import MODELS, Contact, ContactModel, Contacts

from tests.native.grounds import hills

FEATURES = ("free", "face", "edge", "vertex")

GOALS = st.lists(
    st.tuples(st.floats(0.0, 10.0), st.floats(-10.0, 0.0), st.floats(-400.0, 400.0)), min_size=1, max_size=12
)


def followed(name: str, goals: list[tuple[float, float, float]]) -> Contacts:
    model = ContactModel(hills(), name)
    model.place(3.0, -2.0, 1000.0)
    return model.follow(array("d", [number for goal in goals for number in goal]))


def updated(name: str, goals: list[tuple[float, float, float]]) -> list[Contact]:
    model = ContactModel(hills(), name)
    model.place(3.0, -2.0, 1000.0)
    return [model.update(*goal) for goal in goals]


@settings(deadline=None, max_examples=60)
@given(st.sampled_from(MODELS), GOALS)
def test_following_is_updating_again_and_again(name: str, goals: list[tuple[float, float, float]]) -> None:
    contacts, one_by_one = followed(name, goals), updated(name, goals)
    assert len(contacts) == len(goals)
    for number, axis in enumerate(("east", "north", "up")):
        expected = [contact.proxy[number] for contact in one_by_one]
        assert contacts.column(f"proxy_{axis}").tolist() == expected
    features = [FEATURES[round(feature)] for feature in contacts.column("feature").tolist()]
    assert features == [contact.feature for contact in one_by_one]
    for name in ("vertices", "faces", "collision_tests", "cells", "far_edge_crossings", "steps_left"):
        expected = [float(getattr(contact, name)) for contact in one_by_one]
        assert contacts.column(name).tolist() == expected


@settings(deadline=None, max_examples=60)
@given(GOALS)
def test_the_spring_leads_from_the_goal_to_the_proxy(goals: list[tuple[float, float, float]]) -> None:
    contacts, one_by_one = followed("surface_walk", goals), updated("surface_walk", goals)
    springs = zip(*(contacts.column(f"spring_{axis}").tolist() for axis in "xyz"), strict=True)
    for spring, contact in zip(springs, one_by_one, strict=True):
        assert math.hypot(*spring) == pytest.approx(contact.distance, rel=1e-12, abs=1e-12)


def test_no_goals_are_no_contacts() -> None:
    assert len(followed("surface_walk", [])) == 0


def test_a_goal_that_is_no_number_leaves_the_proxy() -> None:
    contacts = followed("surface_walk", [(3.0, -3.0, -50.0), (math.nan, 0.0, 0.0)])
    up = contacts.column("proxy_up").tolist()
    assert up[0] == up[1]


@pytest.mark.parametrize(
    ("goals", "words"),
    [
        (array("d", [1.0, 2.0, 3.0, 4.0]), "goals has 4 numbers; expected three for each"),
        (array("f", [1.0, 2.0, 3.0]), "a C-contiguous buffer of doubles"),
        (memoryview(array("d", range(12)))[::2], "a C-contiguous buffer of doubles"),
    ],
)
def test_what_is_no_goals_is_told(goals: array[float], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ContactModel(hills()).follow(goals)


def test_an_unknown_column_is_told() -> None:
    with pytest.raises(KeyError, match=r"is not one of Contacts\.columns"):
        followed("surface_walk", [(3.0, -3.0, 0.0)]).column("force")
