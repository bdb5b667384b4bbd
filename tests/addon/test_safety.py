"""Limits and watchdogs as the add-on sets them."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from proxygraph import STALE_AFTER

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture(autouse=True)
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(**options: Any) -> Any:
    return module("touch.start").start_touch(bpy.context, **options)


def wait_until(happened: Callable[[], bool]) -> None:
    """Give a live session all the time that a busy machine may need."""
    end = time.monotonic() + 60.0
    while not happened():
        assert time.monotonic() < end, "it did not happen within a minute"
        time.sleep(0.001)


def test_a_person_may_lower_the_force() -> None:
    bpy.context.scene.haptic_terrain.max_force = 2.5
    assert start(on_the_clock=False).session.max_force == pytest.approx(2.5)


def test_scripts_in_the_background_are_not_waited_for() -> None:
    assert bpy.app.background
    assert module("touch.start").stale_after() is None


def test_in_a_window_the_timer_must_look(monkeypatch: pytest.MonkeyPatch) -> None:
    window = SimpleNamespace(app=SimpleNamespace(background=False))
    monkeypatch.setattr(module("touch.start"), "bpy", window)
    assert module("touch.start").stale_after() == STALE_AFTER


def test_a_blender_that_stalls_takes_the_force_away_until_its_timer_comes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(module("touch.start"), "stale_after", lambda: STALE_AFTER)
    touch = start(device=sweep(60.0))
    wait_until(lambda: touch.session.statistics().host_cuts > 0)
    tick = module("touch.tick").tick

    def is_back() -> bool:
        tick()
        return bool(touch.readout.held is None)

    wait_until(is_back)
    assert any("did not answer for a while" in line for line in touch.readout.warnings)
