"""Pan and zoom by a hand on a terrain: the window moves, the terrain never does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import bpy
import pytest
from proxygraph import SessionError, Window

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module, positions
from tests.formats.megdr_pair import MegdrPair, planet, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def start(**options: Any) -> Any:
    return module("touch.start").start_touch(bpy.context, **{"on_the_clock": False, **options})


def step(touch: Any, ticks: int) -> None:
    """Let the servo run, and Blender's timer look 60 times a second."""
    tick = module("touch.tick").tick
    for _ in range(ticks // 20):
        touch.session.step(20)
        tick()


def target() -> bpy.types.Object:
    return bpy.data.objects["Touch Target"]


def drag(touch: Any, x: float, y: float, z: float) -> None:
    """Move the Empty by so much, Blender units, and let the hand arrive."""
    target().location.x += x
    target().location.y += y
    target().location.z += z
    bpy.context.view_layer.update()
    module("touch.tick").tick()
    step(touch, 3000)


def narrow(touch: Any, width: float = 1e6) -> Any:
    """Lay a window over the middle of the map: metres of terrain across."""
    whole = touch.session.window
    window = Window(whole.east, whole.north, whole.up, width=width, exaggeration=whole.exaggeration)
    module("touch.follow").lay_window(touch, window)
    return window


def test_a_hand_that_a_person_moves_has_modes_and_a_script_has_none(terrain: bpy.types.Object) -> None:
    touch = start()
    step(touch, 20)
    touch.session.press()
    step(touch, 20)
    assert touch.readout.mode == "zoom"
    module("touch.stop").stop_touch()
    touch = start(device=sweep(), terrain=terrain)
    with pytest.raises(SessionError, match="without modes"):
        touch.session.press()
    module("touch.stop").stop_touch()
    assert start(device=sweep(), terrain=terrain, modes=True).has_modes


def test_walls_stand_around_the_whole_map(terrain: bpy.types.Object) -> None:
    layout = module("terrain.kept").recall(terrain).grid.layout
    width = module("terrain.frame").map_size(layout)[0]
    scripted = start(device=sweep()).session.window.width
    module("touch.stop").stop_touch()
    touch = start(terrain=terrain)
    assert touch.session.window.width == pytest.approx(scripted / 0.9)
    drag(touch, 5.0, 0.0, 0.5)
    assert touch.session.state().goal[0] == pytest.approx(width, rel=1e-3)
    narrow(touch)
    drag(touch, 0.0, 0.0, 0.0)
    assert 0.072 < touch.session.state().hand[0] < 0.08


def test_a_pan_moves_the_window_and_brings_the_empty_to_the_hand(terrain: bpy.types.Object) -> None:
    touch = start()
    before = terrain.matrix_world.copy()
    drag(touch, 0.0, 0.0, -0.5)
    window, held = touch.session.window, touch.session.state().proxy
    touch.session.press()
    step(touch, 100)
    assert touch.readout.mode == "pan"
    where = target().location.copy()
    drag(touch, 0.5, 0.0, 0.0)
    panned = touch.session.window
    moved = 0.5 / touch.frame.units_per_metre
    assert window.east - panned.east == pytest.approx(moved, rel=0.2)
    assert touch.readout.window.east == pytest.approx(panned.east)
    assert touch.session.state().proxy[:2] == pytest.approx(held[:2], rel=1e-3)
    assert target().location.x == pytest.approx(where.x + 0.5)
    hand = touch.session.state().hand
    touch.session.release()
    step(touch, 2000)
    assert touch.readout.mode == "normal"
    shift = (touch.session.window.east - window.east) * touch.frame.units_per_metre
    assert shift < -0.5
    assert target().location.x == pytest.approx(where.x + 0.5 + shift, abs=1e-4)
    assert touch.session.state().hand == pytest.approx(hand, abs=2e-3)
    assert terrain.matrix_world == before


def test_a_zoom_narrows_the_window_and_leaves_the_hand_where_it_is(terrain: bpy.types.Object) -> None:
    touch = start()
    before = terrain.matrix_world.copy()
    step(touch, 500)
    wide = touch.session.window.width
    touch.session.press()
    step(touch, 100)
    drag(touch, 0.0, 0.0, 1.0)
    touch.session.release()
    hand = touch.session.state().hand
    step(touch, 1000)
    assert touch.session.window.width < 0.8 * wide
    assert touch.readout.window.width == pytest.approx(touch.session.window.width)
    assert touch.session.state().hand == pytest.approx(hand, abs=2e-3)
    assert terrain.matrix_world == before


def test_stretching_the_terrain_waits_for_the_end_of_a_mode(terrain: bpy.types.Object) -> None:
    touch = start()
    step(touch, 100)
    exaggeration = touch.session.window.exaggeration
    touch.session.press()
    step(touch, 20)
    terrain.scale.z = 2.0
    bpy.context.view_layer.update()
    step(touch, 100)
    assert touch.readout.mode == "zoom"
    assert touch.session.window.exaggeration == pytest.approx(exaggeration)
    touch.session.release()
    step(touch, 100)
    assert touch.session.window.exaggeration == pytest.approx(2.0 * exaggeration)


def test_a_pan_across_the_seam_of_a_planet_does_not_tear_the_hand_away(tmp_path: Path) -> None:
    import_grid(planet().write(tmp_path))
    touch = start()
    width = touch.frame.turn
    window = touch.session.window
    seam = Window(10.0, window.north, window.up, width=width / 8.0, exaggeration=window.exaggeration)
    module("touch.follow").lay_window(touch, seam)
    target().location = (4.9, 0.0, 0.5)  # west of the window's middle, at the other edge of what is seen
    drag(touch, 0.0, 0.0, 0.0)
    assert touch.session.state().hand[0] == pytest.approx(-0.1 / (10.0 / 8.0) * 0.16, abs=2e-3)
    touch.session.set_mode("pan")
    step(touch, 100)
    drag(touch, -0.3, 0.0, 0.0)
    assert touch.session.window.east > 0.01 * width
    hand = touch.session.state().hand
    touch.session.set_mode("normal")
    step(touch, 2000)
    assert touch.session.state().hand == pytest.approx(hand, abs=2e-3)


def test_going_elsewhere_ends_a_mode_and_keeps_the_turn(terrain: bpy.types.Object) -> None:
    touch = start()
    window = narrow(touch)
    module("touch.follow").lay_window(
        touch,
        Window(
            window.east,
            window.north,
            window.up,
            width=window.width,
            exaggeration=window.exaggeration,
            turn=0.5,
        ),
    )
    touch.session.press()
    step(touch, 40)
    assert bpy.ops.haptic_terrain.go_to(longitude=30.5, latitude=-5.5) == {"FINISHED"}
    there = target().location.copy()
    step(touch, 40)
    assert touch.readout.mode == "normal"
    assert touch.session.window.turn == 0.5
    assert target().location == there


def test_workspace_and_terrain_agree_in_a_turned_window() -> None:
    workspace = module("touch.workspace")
    window = Window(1000.0, -2000.0, 30.0, width=500.0, exaggeration=4.0, turn=0.7)
    place = (1100.0, -1950.0, 45.0)
    there = workspace.to_workspace(place, window, 0.16)
    assert workspace.from_workspace(there, window, 0.16) == pytest.approx(place)
    assert workspace.nearest_turn(900.0, 50.0, 1000.0) == pytest.approx(-100.0)
    assert workspace.nearest_turn(550.0, 50.0, 1000.0) == 550.0
    assert workspace.nearest_turn(900.0, 50.0, None) == 900.0


def cursor() -> bpy.types.Object:
    return bpy.data.objects["Haptic Cursor"]


def extent(name: str) -> tuple[float, float, float]:
    """Width, height, and lowest place of a cursor's mesh, of that name."""
    places = positions(bpy.data.meshes[name])
    size = places.max(axis=0) - places.min(axis=0)
    return float(size[0]), float(size[2]), float(places[:, 2].min())


def test_the_cursor_shows_each_mode_by_shape_and_colour(terrain: bpy.types.Object) -> None:
    touch = start()
    seen = {}
    for height, mode, name in (
        (0.0, "normal", "Free"),
        (0.0, "zoom", "Zoom"),
        (-0.5, "normal", "Contact"),
        (0.0, "pan", "Pan"),
    ):
        touch.session.set_mode("normal")
        step(touch, 20)
        drag(touch, 0.0, 0.0, height)
        touch.session.set_mode(mode)
        step(touch, 100)
        assert cursor().data.name == f"Haptic Cursor {name}"
        colour: Any = cursor().data.materials[0].diffuse_color
        seen[name] = tuple(colour)
    assert len(set(seen.values())) == 4
    width, height, _lowest = extent("Haptic Cursor Free")
    assert width == pytest.approx(height)
    width, height, _lowest = extent("Haptic Cursor Zoom")
    assert height > 2.0 * width
    width, height, lowest = extent("Haptic Cursor Pan")
    assert width > 2.0 * height
    assert lowest == pytest.approx(0.0, abs=1e-6), "it lies on the ground"


def test_the_cursor_is_at_the_hand_while_it_zooms(terrain: bpy.types.Object) -> None:
    touch = start()
    step(touch, 500)
    touch.session.press()
    step(touch, 100)
    drag(touch, 0.0, 0.0, 0.5)
    state = touch.session.state()
    assert state.mode == "zoom"
    expected = touch.frame.to_object(*state.goal)
    assert cursor().matrix_world.translation[:] == pytest.approx(expected, abs=2e-3)


def test_the_panel_has_words_for_each_mode_and_the_reach_of_the_hand(terrain: bpy.types.Object) -> None:
    panel = module("ui.panel")
    touch = start()
    for mode, words in (("normal", "Normal"), ("pan", "Pan: ground held"), ("zoom", "Zoom: air held")):
        touch.session.set_mode(mode)
        step(touch, 20)
        lines = dict(panel.readout_lines(touch.readout, 50.0, in_degrees=True))
        assert lines["Mode"] == words
    window = Window(0.0, 0.0, 0.0, width=1_234_000.0, turn=-0.5)
    assert panel.reach(replace(touch.readout, window=window)) == "1,234 km, turned 331\N{DEGREE SIGN}"
    window = Window(0.0, 0.0, 0.0, width=1_234.0)
    assert panel.reach(replace(touch.readout, window=window)) == "1,234 m"
