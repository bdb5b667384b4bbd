"""Marking two places, and what lies between them."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any

import bpy
import pytest

from tests.addon.hands import sweep
from tests.addon.scene import contents, import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    """A plane that rises 100 m a cell eastward, on the equator."""
    heights = [[100 * column for column in range(60)] for _ in range(40)]
    return import_grid(MegdrPair(heights, west=200.0, north=20.0).write(tmp_path))


def mark(name: str, longitude: float, latitude: float) -> None:
    bpy.ops.haptic_terrain.go_to(longitude=longitude, latitude=latitude)
    assert bpy.ops.haptic_terrain.mark(which=name) == {"FINISHED"}


def marks_of(terrain: bpy.types.Object) -> Any:
    return module("terrain.marks").marks_of(terrain)


def test_two_marks_have_a_distance_a_rise_and_a_slope(terrain: bpy.types.Object) -> None:
    mark("A", 210.5, 0.5)
    assert marks_of(terrain).between is None
    mark("B", 220.5, 0.5)
    between = marks_of(terrain).between
    metres = 10.0 * math.radians(3_396_000.0) * math.cos(math.radians(0.5))
    assert between.length == pytest.approx(metres, rel=1e-4)
    assert between.difference == pytest.approx(1000.0, abs=0.5)
    assert between.slope == pytest.approx(math.degrees(math.atan(1000.0 / metres)), rel=1e-3)
    assert (between.rise, between.fall) == pytest.approx((1000.0, 0.0), abs=0.5)


def test_the_touched_place_is_marked_while_touching(terrain: bpy.types.Object) -> None:
    touch = module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    touch.session.step(900)
    east, north, _up = touch.session.state().proxy
    bpy.ops.haptic_terrain.mark(which="A")
    layout = touch.grid.layout
    assert marks_of(terrain).a == pytest.approx((east / layout.cell_width, -north / layout.cell_height))


def test_a_new_mark_forgets_what_was_between_and_measures_anew(terrain: bpy.types.Object) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 0.5)
    first = marks_of(terrain).between.length
    mark("A", 200.5, 0.5)
    assert marks_of(terrain).between.length == pytest.approx(2.0 * first, rel=1e-3)


def test_a_cursor_beside_the_map_marks_nothing(terrain: bpy.types.Object) -> None:
    bpy.context.scene.cursor.location = (50.0, 0.0, 0.0)
    with pytest.raises(RuntimeError, match="beside the map"):
        bpy.ops.haptic_terrain.mark(which="A")
    assert marks_of(terrain).a is None


def test_profiles_need_both_marks(terrain: bpy.types.Object) -> None:
    mark("A", 210.5, 0.5)
    assert not bpy.ops.haptic_terrain.add_profile.poll()
    assert not bpy.ops.haptic_terrain.export_profile.poll()
    mark("B", 220.5, 0.5)
    assert bpy.ops.haptic_terrain.add_profile.poll()


def test_the_curve_lies_on_the_terrain(terrain: bpy.types.Object) -> None:
    terrain.location = (3.0, 1.0, 0.5)
    bpy.context.view_layer.update()
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 5.5)
    assert bpy.ops.haptic_terrain.add_profile() == {"FINISHED"}
    curve = bpy.data.objects["Profile"]
    frame = module("terrain.kept").recall(terrain).frame
    assert curve.matrix_world.translation[:] == pytest.approx((3.0, 1.0, 0.5))
    points = [point.co[:3] for point in curve.data.splines[0].points]
    for x, y, z in points:
        east, _north, up = frame.to_terrain(x, y, z)
        assert up == pytest.approx(
            100.0 * east / module("terrain.kept").recall(terrain).grid.layout.cell_width, abs=2.0
        )
    assert len(points) > 10


def test_the_curve_bends_with_the_map(terrain: bpy.types.Object) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 5.5)
    bpy.ops.haptic_terrain.show_curvature(curved=True)
    bpy.ops.haptic_terrain.add_profile()
    frame = module("terrain.kept").recall(terrain).frame
    first = bpy.data.objects["Profile"].data.splines[0].points[0].co[:3]
    layout = module("terrain.kept").recall(terrain).grid.layout
    assert first == pytest.approx(
        frame.to_object(10.0 * layout.cell_width, -19.0 * layout.cell_height, 1000.0), abs=1e-3
    )


def test_a_hole_is_a_gap(tmp_path: Path) -> None:
    heights = [[100] * 60 for _ in range(40)]
    for row in heights:
        row[15] = row[16] = -32768
    terrain = import_grid(
        MegdrPair(heights, west=200.0, north=20.0, image={"MISSING_CONSTANT": -32768}).write(tmp_path)
    )
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 0.5)
    bpy.ops.haptic_terrain.add_profile()
    assert len(bpy.data.objects["Profile"].data.splines) == 2
    assert marks_of(terrain).between.void_length > 0.0


def test_the_shorter_way_around_a_planet_is_measured(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    mark("A", 355.5, 0.5)
    mark("B", 4.5, 0.5)
    degree = math.radians(3_396_000.0)
    assert marks_of(terrain).between.length == pytest.approx(9.0 * degree, rel=1e-3)
    bpy.ops.haptic_terrain.add_profile()
    widths = []
    for spline in bpy.data.objects["Profile"].data.splines:
        across = [point.co[0] for point in spline.points]
        widths.append(max(across) - min(across))
    assert len(widths) == 2
    assert max(widths) < 1.0


def test_the_table_has_a_line_for_each_point(terrain: bpy.types.Object, tmp_path: Path) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 0.5)
    path = tmp_path / "a profile.csv"
    assert bpy.ops.haptic_terrain.export_profile(filepath=str(path)) == {"FINISHED"}
    with path.open(encoding="utf-8", newline="") as file:
        lines = list(csv.DictReader(file))
    assert float(lines[0]["longitude_deg_east"]) == pytest.approx(210.5, abs=1e-4)
    assert float(lines[-1]["longitude_deg_east"]) == pytest.approx(220.5, abs=1e-4)
    assert float(lines[0]["distance_m"]) == 0.0
    assert float(lines[-1]["elevation_m"]) == pytest.approx(2000.0, abs=0.5)
    assert float(lines[-1]["distance_m"]) == pytest.approx(marks_of(terrain).between.length)
    assert lines[0]["slope_deg"] == ""


def test_a_table_that_cannot_be_written_is_told(terrain: bpy.types.Object, tmp_path: Path) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 0.5)
    with pytest.raises(RuntimeError, match="cannot be written"):
        bpy.ops.haptic_terrain.export_profile(filepath=str(tmp_path / "none" / "x.csv"), check_existing=False)


def test_marks_survive_a_file(terrain: bpy.types.Object, tmp_path: Path) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 0.5)
    name, before = terrain.name, marks_of(terrain)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "kept.blend"))
    assert marks_of(bpy.data.objects[name]) == before


@pytest.mark.parametrize("spoilt", [{"A": "x"}, {"A": [math.nan, 1.0]}, {"A": [1.0]}, 5])
def test_marks_that_were_changed_by_hand_are_none(terrain: bpy.types.Object, spoilt: Any) -> None:
    terrain["haptic_terrain_marks"] = spoilt
    assert marks_of(terrain) == module("terrain.marks").Marks()


def test_a_profile_that_fails_leaves_nothing(terrain: bpy.types.Object) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 220.5, 0.5)
    module("terrain.kept").recall(terrain).grid.data_path.unlink()
    before = contents()
    with pytest.raises(RuntimeError, match=r"grid\.img"):
        bpy.ops.haptic_terrain.add_profile()
    assert contents() == before


def test_marks_in_one_place_have_no_profile_and_say_so(terrain: bpy.types.Object) -> None:
    mark("A", 210.5, 0.5)
    mark("B", 210.5, 0.5)
    with pytest.raises(RuntimeError, match="A and B are the same place"):
        bpy.ops.haptic_terrain.add_profile()
