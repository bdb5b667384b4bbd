"""A terrain that is changed after its import: detail, region, heights; its file moved or changed."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import pytest

from tests.addon.hands import sweep
from tests.addon.scene import contents, import_grid, module, positions
from tests.addon.test_import_job import SHOWING, Window, run_until_done
from tests.addon.test_panels import Notes
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def label(tmp_path: Path) -> Path:
    return MegdrPair(rough(40, 60)).write(tmp_path)


@pytest.fixture
def terrain(label: Path) -> bpy.types.Object:
    return import_grid(label)


def mesh_of(terrain: bpy.types.Object) -> bpy.types.Mesh:
    assert isinstance(terrain.data, bpy.types.Mesh)
    return terrain.data


def rebuild(**options: Any) -> None:
    assert bpy.ops.haptic_terrain.rebuild(**options) == {"FINISHED"}


def kept(terrain: bpy.types.Object) -> Any:
    return module("terrain.kept").recall(terrain)


def test_undoing_a_rebuild_in_mid_touch_stops_it(terrain: bpy.types.Object) -> None:
    bpy.context.preferences.edit.use_global_undo = True
    name, start, live = terrain.name, module("touch.start").start_touch, module("touch.live").live
    start(bpy.context, device=sweep(), on_the_clock=False)
    module("touch.stop").stop_touch()
    bpy.ops.ed.undo_push(message="touched before, so that there is a cursor")
    rebuild(region="SAMPLES", first_column=10, first_row=10, columns=20, rows=20)
    bpy.ops.ed.undo_push(message="rebuilt")
    touch = start(bpy.context, device=sweep(), on_the_clock=False)
    bpy.ops.ed.undo_push(message="touching")
    bpy.ops.ed.undo()
    assert live.touch is touch, "the ground is still what is felt"
    bpy.ops.ed.undo()
    assert kept(bpy.data.objects[name]).grid.layout.columns == 60
    assert live.touch is None
    assert not touch.session.running
    assert "shows another ground" in live.message


def test_detail_is_changed_with_the_same_object_and_materials(terrain: bpy.types.Object) -> None:
    material = mesh_of(terrain).materials[0]
    terrain.location = (1.0, 2.0, 3.0)
    before, name = contents(), terrain.name
    rebuild(vertex_budget=100)
    mesh = mesh_of(bpy.data.objects[name])
    assert bpy.data.objects[name] == terrain
    assert 4 < len(mesh.vertices) <= 100
    assert list(mesh.materials) == [material]
    assert terrain.location[:] == (1.0, 2.0, 3.0)
    assert contents() == before, "the old mesh is gone"
    assert kept(terrain).vertex_budget == 100
    rebuild(vertex_budget=250_000)
    assert len(mesh_of(terrain).vertices) == 2400


def test_what_is_not_given_stays_as_it_is(terrain: bpy.types.Object) -> None:
    rebuild(region="SAMPLES", columns=20, rows=10, exaggeration=7.0)
    rebuild(vertex_budget=50)
    again = kept(terrain)
    assert (again.grid.layout.columns, again.grid.layout.rows) == (20, 10)
    assert again.frame.exaggeration == 7.0


def test_the_region_is_cut_anew_and_taken_back(terrain: bpy.types.Object) -> None:
    whole = positions(mesh_of(terrain)).copy()
    rebuild(region="SAMPLES", first_column=10, first_row=5, columns=8, rows=6)
    assert len(mesh_of(terrain).vertices) == 48
    assert str(kept(terrain).region) == "8 columns from 10, 6 rows from 5"
    rebuild(region="WHOLE")
    assert kept(terrain).region is None
    assert np.array_equal(positions(mesh_of(terrain)), whole)


def test_a_region_that_is_not_there_changes_nothing(terrain: bpy.types.Object) -> None:
    before, vertices = kept(terrain), len(mesh_of(terrain).vertices)
    with pytest.raises(RuntimeError, match="region"):
        bpy.ops.haptic_terrain.rebuild(region="DEGREES", west=100.0, east=110.0, south=0.0, north=5.0)
    assert kept(terrain) == before
    assert len(mesh_of(terrain).vertices) == vertices


def test_a_mesh_that_others_share_is_left_to_them(terrain: bpy.types.Object) -> None:
    other = terrain.copy()
    assert isinstance(other, bpy.types.Object)
    bpy.context.collection.objects.link(other)
    rebuild(vertex_budget=100)
    assert len(other.data.vertices) == 2400
    assert len(mesh_of(terrain).vertices) <= 100


def test_a_file_that_was_changed_is_read_again(terrain: bpy.types.Object, label: Path) -> None:
    MegdrPair([[2 * height for height in row] for row in rough(40, 60)]).write(label.parent)
    with pytest.raises(RuntimeError, match="changed"):
        bpy.ops.haptic_terrain.touch_start()
    lowest = kept(terrain).minimum
    rebuild()
    assert kept(terrain).minimum == 2 * lowest
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}


@pytest.mark.parametrize("curved", [False, True])
def test_heights_are_exaggerated_at_once_and_without_the_file(
    terrain: bpy.types.Object, label: Path, curved: bool
) -> None:
    bpy.ops.haptic_terrain.show_curvature(curved=curved)
    first = positions(mesh_of(terrain)).copy()
    before = kept(terrain).frame.exaggeration
    for file in label.parent.iterdir():
        file.rename(file.with_name(f"gone.{file.name}"))
    terrain.haptic_terrain.exaggeration = 3 * before
    assert terrain.haptic_terrain.exaggeration == pytest.approx(3 * before)
    changed = positions(mesh_of(terrain))
    if not curved:
        assert np.allclose(changed[:, 2], 3 * first[:, 2], atol=1e-5)
        assert np.array_equal(changed[:, :2], first[:, :2])
    assert not np.allclose(changed, first, atol=1e-3)
    for _time in range(20):
        terrain.haptic_terrain.exaggeration = 7.0
        terrain.haptic_terrain.exaggeration = before
    assert np.allclose(positions(mesh_of(terrain)), first, atol=1e-5), "no drift"


@pytest.mark.parametrize("curved", [False, True])
def test_exaggerating_shows_what_an_import_would_show(label: Path, curved: bool) -> None:
    terrain = import_grid(label, exaggeration=40.0)
    bpy.ops.haptic_terrain.show_curvature(curved=curved)
    terrain.haptic_terrain.exaggeration = 9.0
    found = positions(mesh_of(terrain)).copy()
    other = import_grid(label, exaggeration=9.0)
    bpy.ops.haptic_terrain.show_curvature(curved=curved)
    assert np.allclose(found, positions(mesh_of(other)), atol=2e-5)


def test_the_hand_feels_heights_as_they_are_shown(terrain: bpy.types.Object) -> None:
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    terrain.haptic_terrain.exaggeration = 5.0
    bpy.context.view_layer.update()
    module("touch.tick").tick()
    touch.session.step(1)
    assert touch.session.window.exaggeration == pytest.approx(5.0)


def test_linked_duplicates_are_exaggerated_together(terrain: bpy.types.Object) -> None:
    other = terrain.copy()
    assert isinstance(other, bpy.types.Object)
    bpy.context.collection.objects.link(other)
    terrain.haptic_terrain.exaggeration = 5.0
    assert kept(other).frame.exaggeration == pytest.approx(5.0)


def test_heights_stay_while_the_mesh_is_edited(terrain: bpy.types.Object) -> None:
    before = kept(terrain).frame.exaggeration
    bpy.context.view_layer.objects.active = terrain
    bpy.ops.object.mode_set(mode="EDIT")
    terrain.haptic_terrain.exaggeration = 5.0
    bpy.ops.object.mode_set(mode="OBJECT")
    assert kept(terrain).frame.exaggeration == before


def test_a_hand_that_came_meanwhile_is_not_disturbed(terrain: bpy.types.Object) -> None:
    window, reports = Window(), []
    cls = module("ui.terrain_operators").HAPTIC_TERRAIN_OT_rebuild
    operator = SimpleNamespace(_timer=None, report=lambda _kind, text: reports.append(text))
    for name in ("modal", "_clear", "end", *SHOWING):
        setattr(operator, name, getattr(cls, name).__get__(operator))
    options = replace(module("terrain.rebuild").options_of(kept(terrain)), vertex_budget=100)
    operator._job = module("terrain.rebuild").RebuildJob(terrain, options)
    operator._job.run()
    bpy.ops.haptic_terrain.touch_start()
    assert run_until_done(operator, window.context) == {"CANCELLED"}
    assert "stop it" in reports[0]
    assert len(mesh_of(terrain).vertices) == 2400


def test_other_objects_have_no_exaggeration_to_change() -> None:
    bpy.ops.mesh.primitive_cube_add()
    cube = bpy.context.view_layer.objects.active
    assert cube is not None
    before = positions(cube.data).copy()
    cube.haptic_terrain.exaggeration = 5.0
    assert np.array_equal(positions(cube.data), before)


def test_a_moved_file_is_linked_again(terrain: bpy.types.Object, label: Path, tmp_path: Path) -> None:
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    for file in (label, label.with_suffix(".img")):
        shutil.move(file, elsewhere)
    with pytest.raises(RuntimeError):
        bpy.ops.haptic_terrain.touch_start()
    assert bpy.ops.haptic_terrain.relink(filepath=str(elsewhere / label.name)) == {"FINISHED"}
    assert kept(terrain).grid.data_path == elsewhere / "grid.img"
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}


def test_another_grid_is_not_linked(terrain: bpy.types.Object, tmp_path: Path) -> None:
    folder = tmp_path / "other"
    folder.mkdir()
    other = MegdrPair([[height + 1 for height in row] for row in rough(40, 60)]).write(folder)
    before = kept(terrain)
    with pytest.raises(RuntimeError, match="content"):
        bpy.ops.haptic_terrain.relink(filepath=str(other))
    assert kept(terrain) == before


def test_a_touched_terrain_is_not_rebuilt(terrain: bpy.types.Object) -> None:
    bpy.ops.haptic_terrain.touch_start()
    for change in (bpy.ops.haptic_terrain.rebuild, bpy.ops.haptic_terrain.relink):
        with pytest.raises(RuntimeError, match="stop it first"):
            change()


def panel() -> Notes:
    notes = Notes()
    context = bpy.context.temp_override(object=bpy.context.view_layer.objects.active)
    with context:
        cls = module("ui.panels.terrain_data").HAPTIC_TERRAIN_PT_data
        assert cls.poll(bpy.context)
        stand_in = type("Panel", (), {"layout": notes})()
        cls.draw(stand_in, bpy.context)
    return notes


def test_the_object_data_panel_tells_and_offers_it_all(terrain: bpy.types.Object) -> None:
    notes = panel()
    assert notes.properties == ["exaggeration"]
    assert notes.operators == ["haptic_terrain.rebuild", "haptic_terrain.relink"]
    text = " | ".join(notes.labels)
    for words in ("grid.img", "the whole grid", "2,400 samples", "of at most 250,000 vertices", "kB"):
        assert words in text


def test_a_missing_file_is_a_clear_state_in_both_panels(terrain: bpy.types.Object, label: Path) -> None:
    label.with_suffix(".img").unlink()
    assert "use Relink" in " ".join(panel().labels)
    from tests.addon.test_panels import drawn

    notes = drawn("HAPTIC_TERRAIN_PT_terrain")
    assert "use Relink" in " ".join(notes.labels)
    assert "haptic_terrain.relink" in notes.operators
