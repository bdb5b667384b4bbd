"""Scenes in which touch cannot begin or go on: each is told in words, and no hand is left on the terrain."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import pytest
from proxygraph import SessionError

from tests.addon.scene import contents, import_grid, module
from tests.addon.stand_in import StandIn
from tests.addon.test_panels import drawn
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def live() -> Any:
    return module("touch.live").live


def start() -> Any:
    """Start touch with the simulated hand, stepped."""
    return module("touch.start").start_touch(bpy.context, on_the_clock=False)


def tick() -> None:
    bpy.context.view_layer.update()
    module("touch.tick").tick()


def target() -> bpy.types.Object:
    return bpy.data.objects["Touch Target"]


def test_a_target_that_cannot_be_selected_does_not_hinder_touch(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    bpy.ops.haptic_terrain.touch_stop()
    collection = bpy.data.collections.new("Away")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(target())
    bpy.context.scene.collection.objects.unlink(target())
    bpy.context.view_layer.layer_collection.children["Away"].exclude = True
    bpy.context.view_layer.objects.active = terrain
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}
    assert live().touch.session.running
    assert live().touch.target.find() == target()


def test_a_start_that_fails_late_leaves_no_hand_on_the_terrain(
    terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    sessions = []

    def fail() -> None:
        sessions.append(live().touch.session)
        raise ZeroDivisionError

    monkeypatch.setattr(module("touch.start"), "tick", fail)
    before = contents()
    with pytest.raises(RuntimeError, match="ZeroDivisionError"):
        bpy.ops.haptic_terrain.touch_start()
    assert not sessions[0].running
    assert live().touch is None
    assert contents() == before


def test_a_fault_in_the_first_moment_is_not_called_touching(
    terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    stop = module("touch.stop").stop_touch
    monkeypatch.setattr(module("touch.start"), "tick", lambda: stop("Touch stopped: cut"))
    with pytest.raises(RuntimeError, match="cut"):
        bpy.ops.haptic_terrain.touch_start()


@pytest.mark.parametrize("width", [0.0, 100.0])
def test_a_target_that_is_nowhere_is_told_at_the_start(terrain: bpy.types.Object, width: float) -> None:
    start()
    bpy.ops.haptic_terrain.touch_stop()
    target().location.x = math.nan
    bpy.context.view_layer.objects.active = terrain
    bpy.context.scene.haptic_terrain.window_width = width
    with pytest.raises(RuntimeError, match="location of Touch Target is not a number"):
        bpy.ops.haptic_terrain.touch_start()
    assert live().touch is None


def test_a_target_that_gets_lost_leaves_the_hand_where_it_is(
    terrain: bpy.types.Object,
) -> None:
    touch = start()
    touch.session.step(500)
    before = touch.session.state().hand
    target().location.y = math.nan
    tick()
    touch.session.step(500)
    tick()
    assert live().touch is touch
    assert touch.session.state().hand == pytest.approx(before, abs=1e-4)


def test_a_servo_that_is_told_too_much_is_told_again(terrain: bpy.types.Object) -> None:
    def full(*_place: float) -> None:
        raise SessionError("256 commands wait")

    touch = start()
    session = touch.session
    touch.session = StandIn(session, set_target=full, set_window=full)
    terrain.scale.z = 3.0
    tick()
    assert live().touch is touch
    assert touch.readout is not None
    touch.session = session
    tick()
    assert touch.session.window.exaggeration == pytest.approx(3.0 * touch.frame.exaggeration)


@pytest.mark.parametrize("scale", [0.0, math.nan, math.inf])
@pytest.mark.parametrize("axis", [0, 2])
def test_a_terrain_without_size_cannot_be_touched(terrain: bpy.types.Object, axis: int, scale: float) -> None:
    terrain.scale[axis] = scale
    before = contents()
    with pytest.raises(module("touch.error").TouchError, match="scale"):
        start()
    assert contents() == before


@pytest.mark.parametrize("scale", [0.0, math.nan])
def test_a_terrain_that_loses_its_size_stops_touch_in_words(terrain: bpy.types.Object, scale: float) -> None:
    touch = start()
    terrain.scale.x = scale
    tick()
    assert live().touch is None
    assert not touch.session.running
    assert "scale" in live().message


def spoil_all(terrain: bpy.types.Object) -> None:
    terrain["haptic_terrain_grid"] = "spoilt"


def lose_layout(terrain: bpy.types.Object) -> None:
    del terrain["haptic_terrain_grid"]["layout"]


def strange_rows(terrain: bpy.types.Object) -> None:
    terrain["haptic_terrain_grid"]["layout"]["rows"] = "many"


def huge_rows(terrain: bpy.types.Object) -> None:
    terrain["haptic_terrain_grid"]["layout"]["rows"] = "1" + 60 * "0"


def radius_in_words(terrain: bpy.types.Object) -> None:
    terrain["haptic_terrain_grid"]["georeference"]["ellipsoid"]["semi_major"] = "large"


def no_scale(terrain: bpy.types.Object) -> None:
    terrain["haptic_terrain_grid"]["frame"]["units_per_metre"] = 0.0


def no_number(terrain: bpy.types.Object) -> None:
    terrain["haptic_terrain_grid"]["frame"]["east"] = math.nan


def lose_source(terrain: bpy.types.Object) -> None:
    del terrain["haptic_terrain_grid"]["source"]


@pytest.mark.parametrize(
    "spoil",
    [spoil_all, lose_layout, strange_rows, huge_rows, radius_in_words, no_scale, no_number, lose_source],
)
def test_a_terrain_that_forgot_its_grid_says_so(
    terrain: bpy.types.Object, tmp_path: Path, spoil: Callable[[bpy.types.Object], None]
) -> None:
    spoil(terrain)
    with pytest.raises(RuntimeError, match="Import the grid again"):
        bpy.ops.haptic_terrain.touch_start()
    assert "Import the grid again" in " ".join(drawn("HAPTIC_TERRAIN_PT_terrain").labels)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "spoilt.blend"))


def test_nothing_is_begun_or_written_while_a_picture_is_rendered(terrain: bpy.types.Object) -> None:
    live().rendering = True
    with pytest.raises(RuntimeError, match="being rendered"):
        bpy.ops.haptic_terrain.touch_start()
    live().rendering = False
    start()
    bpy.ops.haptic_terrain.record_start()
    live().rendering = True
    before = contents()
    with pytest.raises(RuntimeError, match="being rendered"):
        bpy.ops.haptic_terrain.record_stop()
    assert contents() == before
    assert live().recording is not None


def test_disabling_in_mid_render_does_not_hold_the_scene_for_ever() -> None:
    import addon_utils
    from enable_addon import MODULE

    live_before = live()
    live_before.rendering = True
    addon_utils.disable(MODULE)
    assert not live_before.rendering
