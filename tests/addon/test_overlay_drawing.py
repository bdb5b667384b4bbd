"""What the overlay draws, read back from a view off the screen; and that it comes and goes with touch."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests.addon.scene import import_grid, module
from tests.addon.stage import Pixels, Stage, wait_for_map, why_not
from tests.formats.megdr_pair import MegdrPair, planet, rough

REASON = why_not()

drawing = pytest.mark.skipif(REASON is not None, reason=REASON or "it can draw")

BACKGROUND = 64
"""Of 255: grey, where nothing is drawn."""


@pytest.fixture
def touch(tmp_path: Path) -> Any:
    """A hand that presses on a planet."""
    import_grid(planet().write(tmp_path))
    touch = module("touch.start").start_touch(bpy.context, on_the_clock=False)
    step(touch, 1000)
    target = bpy.data.objects["Touch Target"]
    target.location.z -= 1.5
    bpy.context.view_layer.update()
    module("touch.tick").tick()
    step(touch, 2000)
    assert touch.readout.in_contact
    wait_for_map(overlay())
    return touch


@pytest.fixture
def handlers(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """When Blender would call what is added, of those that are there."""
    there: list[str] = []

    def add(_draw: Any, _arguments: Any, _region: str, when: str) -> str:
        there.append(when)
        return when

    def remove(when: str, _region: str) -> None:
        there.remove(when)

    stand_in = type("Space", (), {"draw_handler_add": add, "draw_handler_remove": remove})
    types = type("Types", (), {"SpaceView3D": stand_in})
    blender = type("Blender", (), {"types": types, "context": bpy.context})
    monkeypatch.setattr(module("overlay.handlers"), "bpy", blender)
    yield there
    module("touch.stop").stop_touch()


def step(touch: Any, ticks: int) -> None:
    for _ in range(ticks // 20):
        touch.session.step(20)
        module("touch.tick").tick()


def overlay() -> Any:
    return module("overlay.handlers").handlers.overlay


def wanted(*parts: str) -> Any:
    """Those parts of the overlay, and no others."""
    names = ("overview", "readout", "legend", "force", "ghost")
    return module("overlay.overlay").Wanted(**{name: name in parts for name in names})


def is_near(pixel: Any, colour: Any, *, by: float = 0.12) -> bool:
    return bool(np.all(np.abs(np.asarray(pixel[:3]) / 255.0 - np.asarray(colour[:3])) < by))


def drawn(pixels: Pixels) -> Any:
    """Where something was drawn."""
    return np.abs(pixels[..., :3].astype(int) - BACKGROUND).max(axis=2) > 2


def cut(pixels: Pixels, rect: Any) -> Pixels:
    return pixels[int(rect.bottom) : int(rect.top), int(rect.left) : int(rect.right)]


@drawing
def test_nothing_is_drawn_where_nothing_is_wanted(touch: Any) -> None:
    assert not drawn(Stage().draw(overlay(), wanted())).any()


@drawing
def test_the_map_shows_the_cursor_in_its_place_and_colour(touch: Any) -> None:
    stage = Stage()
    pixels = stage.draw(overlay(), wanted("overview"))
    chart = module("overlay.overview").placed_map(stage.view, touch.grid.layout)
    x, y = chart.at(*touch.readout.proxy[:2])
    symbols = module("overlay.symbols")
    assert is_near(pixels[round(y), round(x)], symbols.SYMBOLS[touch.shown.shape].colour)
    seen = drawn(pixels)
    rect = chart.rect
    assert cut(seen, rect).mean() > 0.98
    seen[int(rect.bottom) - 3 : int(rect.top) + 3, int(rect.left) - 3 : int(rect.right) + 3] = False
    assert not seen.any(), "nothing is drawn beside the map"


@drawing
def test_the_map_has_the_picture_the_right_way_up(touch: Any) -> None:
    stage = Stage()
    pixels = stage.draw(overlay(), wanted("overview"))
    painted = overlay().overview.painting.finished()
    chart = module("overlay.overview").placed_map(stage.view, touch.grid.layout)
    shown = cut(pixels, chart.rect)[::2, ::2, :3] / 255.0
    rows = np.linspace(0, painted.shape[0] - 1, shown.shape[0]).astype(int)
    columns = np.linspace(0, painted.shape[1] - 1, shown.shape[1]).astype(int)

    def likeness(other: Any) -> float:
        return float(np.corrcoef(shown.ravel(), other[rows][:, columns, :3].ravel())[0, 1])

    assert likeness(painted) > 0.7
    assert likeness(painted) > likeness(painted[::-1]) + 0.05
    assert likeness(painted) > likeness(painted[:, ::-1]) + 0.05


@drawing
def test_readout_and_legend_are_in_the_lower_corners(touch: Any) -> None:
    seen = drawn(Stage().draw(overlay(), wanted("readout")))
    rows, columns = np.nonzero(seen)
    assert columns.min() >= 14
    assert columns.max() < 400
    assert rows.max() < 300
    seen = drawn(Stage().draw(overlay(), wanted("legend")))
    rows, columns = np.nonzero(seen)
    assert columns.max() <= 1280 - 14
    assert columns.min() > 900
    assert rows.max() < 200


@drawing
def test_the_first_picture_is_as_good_as_the_next(touch: Any) -> None:
    """Letters and batches are made in the middle of the first one."""
    everything = wanted("overview", "readout", "legend", "force", "ghost")
    stage = Stage(at=touch.shown.place)
    first = stage.draw(overlay(), everything)
    assert np.array_equal(first, stage.draw(overlay(), everything))


@drawing
@pytest.mark.parametrize("background", [0.0, 1.0])
def test_text_can_be_read_on_light_and_on_dark(touch: Any, background: float) -> None:
    colour = (background, background, background, 1.0)
    pixels = Stage().draw(overlay(), wanted("readout"), colour=colour)
    plate = pixels[26:160, 26:240, :3].mean(axis=2)
    assert plate.max() - np.median(plate) > 90


@drawing
def test_a_small_view_shows_what_it_has_room_for(touch: Any) -> None:
    everything = wanted("overview", "readout", "legend")
    assert not drawn(Stage(size=(120, 90)).draw(overlay(), everything)).any()
    narrow = Stage(size=(300, 500))
    chart = module("overlay.overview").placed_map(narrow.view, touch.grid.layout)
    seen = drawn(narrow.draw(overlay(), everything))
    assert cut(seen, chart.rect).mean() > 0.98
    assert seen[20:60, 20:200].any(), "the readout"
    assert not seen[20:60, 285:].any(), "no legend"


@drawing
def test_an_interface_twice_as_large_has_a_map_twice_as_large(touch: Any) -> None:
    stage = Stage(size=(2560, 1600), scale=2.0)
    chart = module("overlay.overview").placed_map(stage.view, touch.grid.layout)
    assert chart.rect.width == pytest.approx(480.0)
    assert drawn(stage.draw(overlay(), wanted("readout"))).any()


def around(pixels: Pixels, place: tuple[float, float], *, radius: int = 4) -> Pixels:
    x, y = round(place[0]), round(place[1])
    return pixels[y - radius : y + radius + 1, x - radius : x + radius + 1]


def brightest(pixels: Pixels) -> int:
    return int(pixels[..., :3].min(axis=2).max())


@drawing
def test_the_ghost_is_where_the_hand_is_and_a_line_leads_there(touch: Any) -> None:
    stage = Stage(at=touch.shown.place, distance=3.0, tilt=1.2)
    pixels = stage.draw(overlay(), wanted("ghost"))
    hand = touch.shown.place + touch.shown.hand
    assert brightest(around(pixels, stage.pixel(hand), radius=30)) > 180
    halfway = touch.shown.place + 0.4 * touch.shown.hand
    assert brightest(around(pixels, stage.pixel(halfway))) > 180


@drawing
def test_the_ghost_is_dimmed_below_the_ground(touch: Any) -> None:
    stage = Stage(at=touch.shown.place, distance=3.0, tilt=0.6)
    terrain = touch.terrain.find()
    plain = stage.draw(overlay(), wanted(), ground=terrain).astype(int)
    below = stage.draw(overlay(), wanted("ghost"), ground=terrain).astype(int)
    seen = stage.draw(overlay(), wanted("ghost")).astype(int)
    at = stage.pixel(touch.shown.place + touch.shown.hand)
    added = np.abs(around(below - plain, at, radius=20)).max()
    alone = np.abs(around(seen - BACKGROUND, at, radius=20)[..., :3]).max()
    assert 10 < added < 0.8 * alone


@drawing
def test_the_arrow_points_along_the_force_and_can_be_hidden(touch: Any) -> None:
    stage = Stage(at=touch.shown.place, distance=3.0, tilt=1.2)
    yellow = np.array(module("overlay.colours").FORCE[:3])
    pixels = stage.draw(overlay(), wanted("force"))
    rows, columns = np.nonzero(np.abs(pixels[..., :3] / 255.0 - yellow).max(axis=2) < 0.12)
    assert len(rows) > 50
    tip = touch.shown.place + touch.shown.force.normalized()
    start, end = (np.array(stage.pixel(place)) for place in (touch.shown.place, tip))
    way = (np.array((columns.mean(), rows.mean())) - start) @ (end - start)
    assert way > 0.0
    assert not drawn(stage.draw(overlay(), wanted("ghost"), colour=(0.25, 0.25, 0.25, 1.0)))[0, 0]


@drawing
def test_a_hand_at_the_cursor_has_no_ghost_and_no_arrow(touch: Any) -> None:
    bpy.data.objects["Touch Target"].location.z += 2.5
    bpy.context.view_layer.update()
    module("touch.tick").tick()
    step(touch, 2000)
    stage = Stage(at=touch.shown.place, distance=3.0)
    assert not drawn(stage.draw(overlay(), wanted("ghost", "force"))).any()


@drawing
@pytest.mark.parametrize("orthographic", [False, True])
def test_every_projection_has_a_scale_bar(touch: Any, orthographic: bool) -> None:
    stage = Stage(at=touch.shown.place, orthographic=orthographic)
    bar = module("overlay.readout")._bar(touch.shown, stage.view)
    assert 60.0 < bar.pixels <= 160.0
    start = touch.shown.place
    end = start + stage.view.to_right * (bar.metres * touch.shown.units_per_metre)
    assert stage.pixel(end)[0] - stage.pixel(start)[0] == pytest.approx(bar.pixels, rel=1e-3)


@drawing
def test_drawing_leaves_blenders_state_as_it_was(touch: Any) -> None:
    import gpu

    gpu.state.depth_test_set("EQUAL")
    gpu.state.blend_set("MULTIPLY")
    try:
        Stage().draw_overlay(overlay(), wanted("overview", "readout", "legend", "force", "ghost"))
        assert (gpu.state.depth_test_get(), gpu.state.blend_get()) == ("EQUAL", "MULTIPLY")
    finally:
        gpu.state.depth_test_set("NONE")
        gpu.state.blend_set("NONE")


def start(tmp_path: Path) -> Any:
    import_grid(MegdrPair(rough(20, 30)).write(tmp_path))
    return module("touch.start").start_touch(bpy.context, on_the_clock=False)


def test_handlers_are_there_only_while_touch_runs(handlers: list[str], tmp_path: Path) -> None:
    assert handlers == []
    start(tmp_path)
    assert sorted(handlers) == ["POST_PIXEL", "POST_VIEW"]
    module("touch.stop").stop_touch()
    assert handlers == []
    assert overlay() is None


def test_handlers_go_with_the_file_and_with_the_extension(handlers: list[str], tmp_path: Path) -> None:
    start(tmp_path)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    assert handlers == []


def test_what_fails_while_drawing_is_told_once_and_touch_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    touch = start(tmp_path)
    drawing = module("overlay.handlers")

    def fail(_context: Any) -> None:
        raise RuntimeError("no such thing")

    monkeypatch.setattr(drawing, "view_of", fail)
    for _ in range(3):
        drawing.handlers._draw_flat()
        drawing.handlers._draw_in_scene()
    assert len(caplog.records) == 1
    live = module("touch.live").live
    assert "overlay failed" in live.message
    assert live.touch is touch


def test_a_touch_starts_although_its_overlay_cannot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_arguments: Any) -> None:
        raise RuntimeError("no such thing")

    monkeypatch.setattr(module("overlay.overlay"), "Painting", fail)
    start(tmp_path)
    assert overlay() is None
    assert module("touch.live").live.touch is not None


def test_another_scene_is_not_drawn_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    start(tmp_path)
    looked: list[Any] = []
    monkeypatch.setattr(module("overlay.handlers"), "view_of", looked.append)
    other = bpy.data.scenes.new("Other")
    with bpy.context.temp_override(scene=other):
        module("overlay.handlers").handlers._draw_flat()
    assert looked == []
    module("overlay.handlers").handlers._draw_flat()
    assert len(looked) == 1


def test_a_click_on_the_map_brings_hand_and_target_there(tmp_path: Path) -> None:
    import_grid(planet().write(tmp_path))
    touch = module("touch.start").start_touch(bpy.context, on_the_clock=False)
    turn = touch.frame.turn
    east, north = 0.25 * turn, -0.1 * turn
    assert bpy.ops.haptic_terrain.overview_go(east=east, north=north) == {"FINISHED"}
    expected = touch.frame.to_object(east, north, 0.0)
    assert bpy.data.objects["Touch Target"].location[:2] == pytest.approx(expected[:2], abs=1e-4)
    assert bpy.context.scene.cursor.location[:2] == pytest.approx(expected[:2], abs=1e-4)


def test_there_is_nothing_to_click_without_touch() -> None:
    assert not bpy.ops.haptic_terrain.overview_go.poll()


def test_at_rest_nothing_is_asked_to_be_drawn_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    touch = start(tmp_path)
    step(touch, 2000)
    asked: list[int] = []
    refresh = module("touch.refresh")
    monkeypatch.setattr(refresh, "views", lambda _context: asked.append(1) or [])
    monkeypatch.setattr(refresh, "REST", 1e9)
    step(touch, 100)
    assert asked == []
    bpy.data.objects["Touch Target"].location.x += 0.5
    bpy.context.view_layer.update()
    module("touch.tick").tick()
    step(touch, 100)
    assert asked
    monkeypatch.setattr(refresh, "REST", 0.0)
    step(touch, 3000)
    asked.clear()
    step(touch, 20)
    assert asked == [1], "counts go on"
