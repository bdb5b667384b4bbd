"""The contact model as a person chooses it: in the panel, in a script, before touch and during it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import bpy
import pytest
from proxygraph import MODELS, SessionError

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.addon.stand_in import StandIn
from tests.addon.test_panels import drawn
from tests.formats.megdr_pair import MegdrPair, rough

TOUCHING = 1000
"""Ticks after which the sweeping hand is in the ground."""


@pytest.fixture(autouse=True)
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start() -> Any:
    return module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)


def settings() -> Any:
    return bpy.context.scene.haptic_terrain


def live() -> Any:
    return module("touch.live").live


class Noting:
    """Takes the place of a session's ``set_model``."""

    def __init__(self, touch: Any, refusal: Exception | None = None) -> None:
        self.asked: list[tuple[str, float | None, float | None]] = []
        self.refusal = refusal
        touch.session = StandIn(touch.session, set_model=self)

    def __call__(self, model: str, *, sub_step: float | None, radius: float | None) -> None:
        """Note what was asked."""
        self.asked.append((model, sub_step, radius))
        if self.refusal is not None:
            raise self.refusal


def test_every_model_is_offered_with_a_name_and_a_tooltip() -> None:
    items = settings().bl_rna.properties["contact_model"].enum_items
    assert tuple(item.identifier for item in items) == MODELS
    assert items["god_object_release"].name == "God Object Release"
    assert all(len(item.description) > 20 for item in items)
    assert settings().contact_model == MODELS[0]


def test_touch_starts_with_the_model_that_is_chosen() -> None:
    settings().contact_model = "proxy_graph"
    assert start().session.model == "proxy_graph"


def test_choosing_while_touching_switches_without_a_jolt() -> None:
    touch = start()
    touch.session.step(TOUCHING)
    assert touch.session.state().in_contact
    for name in (*MODELS[1:], MODELS[0]):
        before = touch.session.state().force
        settings().contact_model = name
        assert touch.session.model == name
        touch.session.step(1)
        state = touch.session.state()
        assert state.in_contact
        # 8 N in 50 ms.
        assert math.dist(before, state.force) <= 0.16 * (1.0 + 1e-9)


def test_knobs_go_to_the_model_that_has_them() -> None:
    touch = start()
    noting = Noting(touch)
    settings().sub_step = "QUARTER"
    settings().radius = 3.0
    settings().contact_model = "virtual_proxy"
    settings().radius = 2.0
    settings().contact_model = "proxy_graph"
    settings().sub_step = "CELL"
    settings().contact_model = "surface_walk"
    assert noting.asked == [
        ("surface_walk", 0.25, None),
        ("virtual_proxy", None, pytest.approx(0.003)),
        ("virtual_proxy", None, pytest.approx(0.002)),
        ("proxy_graph", None, None),
        ("surface_walk", 1.0, None),
    ]


@pytest.mark.parametrize("sub_step", ["OFF", "CELL", "QUARTER"])
def test_sessions_take_every_sub_step(sub_step: str) -> None:
    settings().sub_step = sub_step
    touch = start()
    touch.session.step(TOUCHING)
    assert touch.session.state().in_contact


@pytest.mark.parametrize("radius", [0.0, 1.0, 1e9])
def test_sessions_take_every_radius_that_can_be_set(radius: float) -> None:
    settings().contact_model = "virtual_proxy"
    settings().radius = radius
    start().session.step(TOUCHING)


def test_the_choice_in_another_scene_changes_nothing() -> None:
    noting = Noting(start())
    bpy.data.scenes.new("Elsewhere").haptic_terrain.contact_model = "proxy_graph"
    assert noting.asked == []


def test_a_switch_that_is_refused_is_told_in_the_panel_and_tried_again() -> None:
    touch = start()
    session, noting = touch.session, Noting(touch, SessionError("256 commands wait"))
    settings().contact_model = "proxy_graph"
    assert "The contact model cannot be changed: 256 commands wait" in " ".join(
        drawn("HAPTIC_TERRAIN_PT_touch").labels
    )
    noting.refusal = None
    module("touch.tick").tick()
    assert noting.asked == [("proxy_graph", None, None)] * 2
    assert live().message == ""
    module("touch.tick").tick()
    assert len(noting.asked) == 2, "what is done is not done again"
    assert live().touch is touch
    session.stop()


def test_undo_takes_the_hand_along() -> None:
    bpy.context.preferences.edit.use_global_undo = True
    touch = start()
    bpy.ops.ed.undo_push(message="touching")
    settings().contact_model = "proxy_graph"
    bpy.ops.ed.undo_push(message="chosen")
    assert touch.session.model == "proxy_graph"
    bpy.ops.ed.undo()
    assert settings().contact_model == MODELS[0]
    module("touch.tick").tick()
    assert touch.session.model == MODELS[0]


@pytest.mark.parametrize("touching", [False, True])
@pytest.mark.parametrize(
    ("model", "knobs"),
    [("surface_walk", ["sub_step"]), ("virtual_proxy", ["radius"]), ("proxy_graph", []), ("god_object", [])],
)
def test_the_panel_shows_the_knob_of_the_chosen_model(model: str, knobs: list[str], touching: bool) -> None:
    if touching:
        start()
    settings().contact_model = model
    shown = drawn("HAPTIC_TERRAIN_PT_touch").properties
    others = ("device", "window_width", "max_force", "passivity_control")
    assert [name for name in shown if name not in others] == ["contact_model", *knobs]


def test_a_take_notes_the_models_that_answered() -> None:
    touch = start()
    bpy.ops.haptic_terrain.record_start()
    for name in ("surface_walk", "proxy_graph"):
        settings().contact_model = name
        touch.session.step(TOUCHING // 2)
        module("touch.tick").tick()
    assert bpy.ops.haptic_terrain.record_stop() == {"FINISHED"}
    assert bpy.data.objects["Touch Take"]["haptic_terrain_models"] == "surface_walk, proxy_graph"
