"""The ground shown finely around the hand, in Blender."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from proxygraph import Window

from tests.addon.hands import sweep
from tests.addon.scene import contents, import_grid, module, positions, triangles
from tests.formats.megdr_pair import MegdrPair, rough

BUDGET = 4000
"""Vertices, of a grid of 150 x 300."""


def look(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let someone look at the terrain, who sees each of its samples."""
    monkeypatch.setattr(module("touch.show_detail"), "someone_looks", lambda: True)
    monkeypatch.setattr(module("touch.show_detail"), "pixels_per_unit", lambda *_arguments: 200.0)


@pytest.fixture
def terrain(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> bpy.types.Object:
    look(monkeypatch)
    return import_grid(MegdrPair(rough(150, 300), north=75.0, west=0.0).write(tmp_path), vertex_budget=BUDGET)


@pytest.fixture
def touch(terrain: bpy.types.Object) -> Any:
    """Touch, as if someone looked, with the levels shown."""
    window = Window(5e6, -4e6, 0.0, width=3e6, exaggeration=10.0)
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), window=window, on_the_clock=False)
    shown(touch)
    return touch


def shown(touch: Any) -> Any:
    """The mesh of the levels when all that is wanted is shown."""
    tick = module("touch.tick").tick
    for _ in range(3):
        tick()
        touch.detail.wait()
    tick()
    return levels(touch.terrain.find())


def levels(terrain: bpy.types.Object) -> Any:
    return module("terrain.levels_object").shown_levels(terrain)


def evaluated(terrain: bpy.types.Object) -> Any:
    bpy.context.view_layer.update()
    return terrain.evaluated_get(bpy.context.evaluated_depsgraph_get())


def leftovers() -> list[str]:
    """What is in Blender's data that only levels have."""
    mark = module("terrain.levels_object").MARK
    things = [*bpy.data.objects, *bpy.data.meshes, *bpy.data.node_groups]
    modified = [thing.name for thing in bpy.data.objects if thing.modifiers]
    return [thing.name for thing in things if thing.get(mark)] + modified


def test_the_terrain_shows_the_levels_and_keeps_its_mesh(touch: Any) -> None:
    terrain = touch.terrain.find()
    before = positions(terrain.data)
    assert len(evaluated(terrain).data.vertices) == len(levels(terrain).vertices) <= BUDGET
    assert (positions(terrain.data) == before).all()
    assert len(terrain.data.vertices) == len(before) <= BUDGET
    assert terrain.data is not levels(terrain)


def test_what_is_shown_is_finer_at_the_hand_than_the_terrains_mesh(touch: Any) -> None:
    terrain = touch.terrain.find()
    east, north, _up = touch.session.state().proxy
    place = np.array(touch.frame.to_object(east, north, 0.0)[:2])

    def near(mesh: Any) -> int:
        apart = np.linalg.norm(positions(mesh)[:, :2] - place, axis=1)
        return int(np.count_nonzero(apart < 0.5))

    assert near(levels(terrain)) > 4 * near(terrain.data)


def test_renders_do_not_know_the_levels(touch: Any) -> None:
    terrain = touch.terrain.find()
    [modifier] = terrain.modifiers
    assert modifier.show_viewport
    assert not modifier.show_render
    assert not modifier.show_in_editmode


def test_a_picture_rendered_in_mid_touch_is_the_same_without_levels(touch: Any) -> None:
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.render.resolution_x, scene.render.resolution_y = 64, 32
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = (0.0, 0.0, 14.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("world")
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.film_transparent = True

    def picture(name: str) -> Any:
        scene.render.filepath = str(Path(bpy.app.tempdir) / name)
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(bpy.path.ensure_ext(scene.render.filepath, ".exr"))
        pixels = np.empty(64 * 32 * 4, dtype=np.float32)
        image.pixels.foreach_get(pixels)
        return pixels

    with_levels = picture("with")
    assert leftovers() != []
    scene.haptic_terrain.detail = False
    module("touch.tick").tick()
    assert leftovers() == []
    without = picture("without")
    assert np.ptp(without) > 0.0
    assert (with_levels == without).all()


def test_shading_is_that_of_a_new_mesh_after_every_refresh(touch: Any) -> None:
    terrain = touch.terrain.find()
    normals(evaluated(terrain).data)
    for east in (1e6, 4e6, 9e6):
        touch.session.set_window(Window(east, -2e6, 0.0, width=3e6, exaggeration=10.0))
        touch.session.step(50)
        mesh = shown(touch)
        fresh = module("terrain.mesh").triangle_mesh("fresh", positions(mesh), triangles(mesh))
        assert normals(evaluated(terrain).data) == pytest.approx(normals(fresh), abs=1e-4)


def normals(mesh: Any) -> Any:
    values = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertex_normals.foreach_get("vector", values)
    return values


def test_colours_are_those_of_the_terrain(touch: Any) -> None:
    terrain = touch.terrain.find()
    mesh = levels(terrain)
    assert list(mesh.materials) == list(terrain.data.materials)
    own, near = sampled(terrain.data), sampled(mesh)
    shared = own.keys() & near.keys()
    assert len(shared) > 100
    assert all(own[place] == pytest.approx(near[place], abs=1e-3) for place in shared)
    terrain.data.materials[0] = bpy.data.materials.new("another")
    module("touch.tick").tick()
    assert [material.name for material in mesh.materials] == ["another"]


def sampled(mesh: Any) -> dict[tuple[float, ...], tuple[float, float]]:
    """Elevation and slope by place, of what is seen: it comes before what is folded."""
    values = np.empty((2, len(mesh.vertices)), dtype=np.float32)
    mesh.attributes["elevation"].data.foreach_get("value", values[0])
    mesh.attributes["slope"].data.foreach_get("value", values[1])
    places = np.round(positions(mesh), 4).tolist()
    of_place: dict[tuple[float, ...], tuple[float, float]] = {}
    for place, (elevation, slope) in zip(places, values.T, strict=True):
        of_place.setdefault(tuple(place), (float(elevation), float(slope)))
    return of_place


def test_stopping_leaves_nothing(touch: Any) -> None:
    module("touch.stop").stop_touch()
    assert leftovers() == []


def test_a_choice_takes_them_away_and_back(touch: Any) -> None:
    bpy.context.scene.haptic_terrain.detail = False
    module("touch.tick").tick()
    assert leftovers() == []
    assert touch.detail.surface is None
    bpy.context.scene.haptic_terrain.detail = True
    assert shown(touch) is not None


def test_nobody_pays_where_nobody_looks(terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module("touch.show_detail"), "someone_looks", lambda: False)
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    module("touch.tick").tick()
    assert touch.detail is None
    assert leftovers() == []


def test_a_mesh_that_has_every_sample_is_shown_itself(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    look(monkeypatch)
    import_grid(MegdrPair(rough(40, 60)).write(tmp_path))
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    assert touch.detail is None


@pytest.mark.parametrize("kind", ["modifier", "object", "mesh", "nodes"])
def test_what_a_person_deletes_comes_back(touch: Any, kind: str) -> None:
    terrain = touch.terrain.find()
    name = module("terrain.levels_object").NAME
    if kind == "modifier":
        terrain.modifiers.clear()
    elif kind == "object":
        bpy.data.objects.remove(bpy.data.objects[name])
    elif kind == "mesh":
        bpy.data.meshes.remove(levels(terrain))
    else:
        bpy.data.node_groups.remove(bpy.data.node_groups[name])
    assert len(shown(touch).vertices) > 1000
    module("touch.stop").stop_touch()
    assert leftovers() == []


def test_a_mesh_that_a_person_changed_is_made_anew(touch: Any) -> None:
    terrain = touch.terrain.find()
    levels(terrain).clear_geometry()
    touch.session.set_window(Window(9e6, -2e6, 0.0, width=3e6, exaggeration=10.0))
    touch.session.step(50)
    assert len(shown(touch).polygons) > 1000


def test_undo_in_mid_touch_changes_nothing_for_long(touch: Any) -> None:
    bpy.ops.ed.undo_push(message="with levels")
    bpy.data.objects.new("thing", None)
    bpy.ops.ed.undo_push(message="later")
    touch.session.set_window(Window(9e6, -2e6, 0.0, width=3e6, exaggeration=10.0))
    touch.session.step(50)
    before = positions(shown(touch))
    bpy.ops.ed.undo()
    after = positions(shown(touch))
    assert (before[: BUDGET // 2] == after[: BUDGET // 2]).all()
    module("touch.stop").stop_touch()
    assert leftovers() == []


def test_undo_after_touch_brings_no_levels_back(touch: Any) -> None:
    bpy.ops.ed.undo_push(message="with levels")
    module("touch.stop").stop_touch()
    bpy.ops.ed.undo_push(message="stopped")
    bpy.ops.ed.undo()
    assert leftovers() == []


def test_a_file_saved_in_mid_touch_has_the_terrain_alone(touch: Any, tmp_path: Path) -> None:
    name = touch.terrain.find().name
    path = tmp_path / "touched.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)
    assert len(shown(touch).vertices) > 1000  # touch goes on
    with bpy.data.libraries.load(str(path)) as (inside, _wanted):
        assert not [kept for kept in (*inside.meshes, *inside.objects, *inside.node_groups) if "Near" in kept]
    bpy.ops.wm.open_mainfile(filepath=str(path))
    assert leftovers() == []
    terrain = bpy.data.objects[name]
    assert not terrain.hide_get()
    assert not terrain.hide_render


def test_a_file_written_past_the_handlers_is_mended_when_it_is_opened(touch: Any, tmp_path: Path) -> None:
    path = tmp_path / "recovered.blend"
    bpy.data.libraries.write(str(path), {bpy.data.scenes[0]})
    module("touch.stop").stop_touch()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    module_of_addon()
    with bpy.data.libraries.load(str(path)) as (inside, wanted):
        wanted.scenes = inside.scenes
    assert leftovers() != []
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "again.blend"))
    assert leftovers() == []


def module_of_addon() -> None:
    from enable_addon import enable

    enable()


def test_nothing_changes_while_a_picture_is_rendered(touch: Any) -> None:
    before = contents(), leftovers()
    timer = module("touch.timer")
    timer._render_begins()
    touch.session.set_window(Window(9e6, -2e6, 0.0, width=3e6, exaggeration=10.0))
    touch.session.step(50)
    module("touch.tick").tick()
    module("touch.stop").stop_touch()
    assert (contents(), leftovers()) == before
    timer._render_ends()
    assert leftovers() == []


def test_the_cursor_is_never_buried_in_what_is_shown(touch: Any) -> None:
    terrain = touch.terrain.find()
    for _ in range(10):
        touch.session.step(150)
        shown(touch)
        east, north, up = touch.session.state().proxy
        height = touch.detail.surface.height_at(east, north)
        assert height is not None
        cursor = bpy.data.objects["Haptic Cursor"].matrix_world.translation
        local = terrain.matrix_world.inverted() @ cursor
        lowest = touch.frame.to_object(east, north, max(height, up))[2]
        assert local.z == pytest.approx(lowest, abs=1e-4)


def test_levels_go_with_a_terrain_that_is_moved_turned_and_scaled(touch: Any) -> None:
    terrain = touch.terrain.find()
    parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    terrain.parent = parent
    parent.matrix_world = Matrix.LocRotScale((3.0, 4.0, 5.0), None, (2.0, 2.0, 2.0))
    bpy.context.view_layer.update()
    shown(touch)
    assert evaluated(terrain).matrix_world.translation == Vector((3.0, 4.0, 5.0))
    assert len(evaluated(terrain).data.vertices) == len(levels(terrain).vertices)


def test_levels_follow_the_sphere(touch: Any) -> None:
    flat = positions(shown(touch))
    assert bpy.ops.haptic_terrain.show_curvature() == {"FINISHED"}
    bent = positions(shown(touch))
    assert bent[:, 2].min() < flat[:, 2].min() - 1.0


def test_a_take_is_not_disturbed(touch: Any) -> None:
    terrain = touch.terrain.find()
    matrix = terrain.matrix_world.copy()
    for east in (1e6, 4e6):
        touch.session.set_window(Window(east, -2e6, 0.0, width=3e6, exaggeration=10.0))
        touch.session.step(50)
        shown(touch)
    assert terrain.matrix_world == matrix
    assert not terrain.hide_get()


def test_a_refresh_makes_no_new_things(touch: Any) -> None:
    before = contents()
    for number in range(20):
        touch.session.set_window(Window(1e6 + 3e5 * number, -2e6, 0.0, width=3e6, exaggeration=10.0))
        touch.session.step(20)
        shown(touch)
    assert contents() == before


def test_vertices_stay_in_the_budget_however_often_it_is_refreshed(touch: Any) -> None:
    room = module("terrain.levels.standing").Room(BUDGET)
    for number in range(room.refreshes + 10):
        touch.session.set_window(Window(2e6 * (number % 5), -2e6, 0.0, width=3e6, exaggeration=10.0))
        touch.session.step(20)
        module("touch.tick").tick()
        touch.detail.wait()
        assert len(levels(touch.terrain.find()).vertices) <= BUDGET


def test_pixels_of_a_unit() -> None:
    pixels = module("touch.sight").scale_on_screen
    flat = Matrix.Diagonal((0.2, 0.4, -0.01, 1.0))  # orthographic, 10 units across
    assert pixels(flat, Matrix.Identity(4), 1000, Vector((3.0, 0.0, -5.0))) == pytest.approx(100.0)
    deep = Matrix(
        ((2.0, 0, 0, 0), (0, 3.0, 0, 0), (0, 0, -1.0, -0.1), (0, 0, -1.0, 0))
    )  # 1 unit at distance 1
    assert pixels(deep, Matrix.Identity(4), 1000, Vector((0.0, 0.0, -4.0))) == pytest.approx(250.0)
    assert pixels(deep, Matrix.Identity(4), 1000, Vector((0.0, 0.0, 4.0))) == 0.0
