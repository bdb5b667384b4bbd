"""Passivity control as a person chooses it, before touch and during it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import pytest
from proxygraph import SessionError

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.addon.stand_in import StandIn
from tests.addon.test_panels import drawn
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture(autouse=True)
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


class Noting:
    """Takes the place of a session's ``set_passivity_control``."""

    def __init__(self) -> None:
        self.asked: list[bool] = []
        self.refusal: Exception | None = None

    def __call__(self, controls: bool) -> None:
        """Note what was asked."""
        self.asked.append(controls)
        if self.refusal is not None:
            raise self.refusal


def start() -> tuple[Any, Noting]:
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    noting = Noting()
    touch.session = StandIn(touch.session, set_passivity_control=noting)
    return touch, noting


def test_nothing_is_asked_of_a_session_that_does_as_is_chosen() -> None:
    _touch, noting = start()
    module("touch.tick").tick()
    assert noting.asked == []


def test_what_was_chosen_before_and_during_touch_is_told_once() -> None:
    settings = bpy.context.scene.haptic_terrain
    settings.passivity_control = True
    touch, noting = start()
    assert touch.passivity_control
    module("touch.tick").tick()
    settings.passivity_control = False
    module("touch.tick").tick()
    assert noting.asked == [False]


def test_what_was_refused_is_asked_again() -> None:
    _touch, noting = start()
    noting.refusal = SessionError("256 commands wait")
    bpy.context.scene.haptic_terrain.passivity_control = True
    noting.refusal = None
    module("touch.tick").tick()
    module("touch.tick").tick()
    assert noting.asked == [True, True]


def test_a_session_takes_it_in_mid_touch() -> None:
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    touch.session.step(100)
    bpy.context.scene.haptic_terrain.passivity_control = True
    touch.session.step(100)
    assert touch.passivity_control
    assert touch.session.fault is None


def test_the_panel_offers_it_and_counts_what_was_active() -> None:
    assert "passivity_control" in drawn("HAPTIC_TERRAIN_PT_touch").properties
    start()
    module("touch.tick").tick()
    assert "passivity_control" in drawn("HAPTIC_TERRAIN_PT_safety").properties
    assert "Active ticks" in drawn("HAPTIC_TERRAIN_PT_touch").labels
