"""The 3D views follow the window that pan and zoom move."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import bpy
import pytest
from mathutils import Quaternion, Vector
from proxygraph import Window

from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def touch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Touch, as if someone looked."""
    import_grid(MegdrPair(rough(40, 60)).write(tmp_path))
    monkeypatch.setattr(module("touch.follow_view"), "someone_looks", lambda: True)
    touch = module("touch.start").start_touch(bpy.context, on_the_clock=False)
    step(touch, 500)
    return touch


def step(touch: Any, ticks: int) -> None:
    for _ in range(ticks // 20):
        touch.session.step(20)
        module("touch.tick").tick()


def zoom(touch: Any, rise: float = 0.5) -> None:
    """Grab the air and go up, Blender units."""
    touch.session.press()
    step(touch, 40)
    bpy.data.objects["Touch Target"].location.z += rise
    bpy.context.view_layer.update()
    step(touch, 2000)


def view() -> bpy.types.RegionView3D:
    """The one view of the factory settings."""
    areas = (area for window in bpy.context.window_manager.windows for area in window.screen.areas)
    space: Any = next(area for area in areas if area.type == "VIEW_3D").spaces.active
    shown: bpy.types.RegionView3D = space.region_3d
    return shown


def size_of_cursor() -> float:
    return float(bpy.data.objects["Haptic Cursor"].scale.x)


def placement(touch: Any) -> Any:
    return module("touch.placement").Placement.of(touch.terrain.find(), touch.frame)


def in_view(place: Any) -> Vector:
    """A place in the scene as the view has it, in its own distances."""
    shown = view()
    return shown.view_rotation.inverted() @ (Vector(place) - shown.view_location) / shown.view_distance


def test_a_zoom_brings_the_view_nearer_and_keeps_the_size_of_the_cursor(touch: Any) -> None:
    distance, size = view().view_distance, size_of_cursor()
    width = touch.session.window.width
    zoom(touch)
    share = touch.session.window.width / width
    assert share < 0.9
    assert view().view_distance == pytest.approx(share * distance, rel=1e-4)
    assert size_of_cursor() == pytest.approx(share * size, rel=1e-4)


def test_the_hand_stays_where_it_is_in_the_view(touch: Any) -> None:
    touch.session.press()
    step(touch, 40)
    before = in_view(placement(touch).to_scene(*touch.session.state().goal))
    touch.session.set_twist(0.7)
    step(touch, 40)
    assert touch.session.window.turn == pytest.approx(-0.7)
    after = in_view(placement(touch).to_scene(*touch.session.state().goal))
    assert (after - before).length < 1e-3


def test_a_pan_takes_the_view_along(touch: Any) -> None:
    location, distance = view().view_location.copy(), view().view_distance
    east = touch.session.window.east
    touch.session.set_mode("pan")
    step(touch, 40)
    bpy.data.objects["Touch Target"].location.x += 0.5
    bpy.context.view_layer.update()
    step(touch, 2000)
    shift = (touch.session.window.east - east) * touch.frame.units_per_metre
    assert shift < -0.3
    assert view().view_location.x - location.x == pytest.approx(shift, abs=1e-4)
    assert view().view_location.z == pytest.approx(location.z, abs=1e-4)
    assert view().view_distance == pytest.approx(distance)


def test_by_choice_the_view_stays(touch: Any) -> None:
    distance, size = view().view_distance, size_of_cursor()
    bpy.context.scene.haptic_terrain.follow_view = False
    zoom(touch)
    assert (view().view_distance, size_of_cursor()) == (distance, size)
    bpy.context.scene.haptic_terrain.follow_view = True
    step(touch, 100)
    assert view().view_distance == pytest.approx(distance, rel=0.01), "it goes on from here"


def test_in_the_background_the_view_stays(touch: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    distance = view().view_distance
    zoom(touch)
    assert view().view_distance == distance


def test_a_camera_stays(touch: Any) -> None:
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(scene.camera)
    view().view_perspective = "CAMERA"
    distance, matrix = view().view_distance, scene.camera.matrix_world.copy()
    zoom(touch)
    assert view().view_distance == distance
    assert scene.camera.matrix_world == matrix


def test_a_window_that_is_laid_elsewhere_leaves_views_to_whoever_laid_it(touch: Any) -> None:
    location = view().view_location.copy()
    window = touch.session.window
    there = Window(
        window.east + 1e6, window.north, window.up, width=window.width / 4.0, exaggeration=window.exaggeration
    )
    module("touch.follow").lay_window(touch, there)
    step(touch, 100)
    assert view().view_location == location
    assert touch.view_scale == 1.0


def test_a_turned_terrain_turns_the_view_about_its_own_upright(touch: Any) -> None:
    follow_view = module("touch.follow_view")
    terrain = touch.terrain.find()
    terrain.rotation_euler = (math.pi / 2, 0.0, 0.0)
    terrain.scale = (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    here = placement(touch)
    window = Window(1e6, -1e6, 0.0, width=1e6)
    turned = Window(1e6, -1e6, 0.0, width=1e6, turn=0.3)
    view().view_rotation = (1.0, 0.0, 0.0, 0.0)
    view().view_location = here.to_scene(1e6, -1e6, 0.0)
    location = view().view_location.copy()
    follow_view.move_view(view(), follow_view.in_scene(window, here), follow_view.in_scene(turned, here))
    assert (view().view_location - location).length < 1e-5
    expected = Quaternion((0.0, -1.0, 0.0), 0.3)
    assert view().view_rotation.rotation_difference(expected).angle == pytest.approx(0.0, abs=1e-3)


def test_nothing_near_is_cut_off_when_the_view_comes_near(touch: Any) -> None:
    view().view_distance = 0.5
    zoom(touch)
    areas = (area for window in bpy.context.window_manager.windows for area in window.screen.areas)
    space: Any = next(area for area in areas if area.type == "VIEW_3D").spaces.active
    assert space.clip_start <= 0.01 * view().view_distance * 1.001
