"""Importing a part of a grid: only its samples are ever read."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests.addon.scene import contents, import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough

ROWS, COLUMNS = 20, 40
"""Of a grid of a degree a cell: 20 to 60 E, 10 N to 10 S."""


@pytest.fixture
def pair() -> MegdrPair:
    return MegdrPair(rough(ROWS, COLUMNS))


def kept_of(terrain: bpy.types.Object) -> Any:
    return module("terrain.kept").recall(terrain)


def shown(terrain: bpy.types.Object) -> list[float]:
    return [value.value for value in terrain.data.attributes["elevation"].data]


def part(pair: MegdrPair, rows: range, columns: range) -> list[float]:
    return [float(pair.heights[row][column]) for row in rows for column in columns]


def test_rows_and_columns(pair: MegdrPair, tmp_path: Path) -> None:
    choice = {"first_column": 5, "first_row": 3, "columns": 7, "rows": 4}
    terrain = import_grid(pair.write(tmp_path), region="SAMPLES", **choice)
    assert shown(terrain) == part(pair, range(3, 7), range(5, 12))


def test_no_number_of_rows_or_columns_is_the_rest(pair: MegdrPair, tmp_path: Path) -> None:
    terrain = import_grid(pair.write(tmp_path), region="SAMPLES", first_column=30, first_row=15)
    assert shown(terrain) == part(pair, range(15, 20), range(30, 40))


def test_degrees_take_the_samples_within(pair: MegdrPair, tmp_path: Path) -> None:
    box = {"west": 24.0, "east": 30.5, "south": -2.0, "north": 3.0}
    terrain = import_grid(pair.write(tmp_path), region="DEGREES", **box)
    # Cell centres lie at 20.5, 21.5 ... and 9.5, 8.5 ...
    assert shown(terrain) == part(pair, range(7, 12), range(4, 11))
    place = kept_of(terrain).grid.georeference
    assert (place.x(0), place.y(0)) == (24.5, 2.5)


@pytest.mark.parametrize("turn", [-360.0, 0.0])
def test_longitudes_may_count_from_either_side(pair: MegdrPair, tmp_path: Path, turn: float) -> None:
    label = replace(pair, west=200.0).write(tmp_path)
    box = {"west": 204.0 + turn, "east": 210.5 + turn, "south": -2.0, "north": 3.0}
    assert shown(import_grid(label, region="DEGREES", **box)) == part(pair, range(7, 12), range(4, 11))


def test_a_box_beyond_the_map_is_cut_at_its_edges(pair: MegdrPair, tmp_path: Path) -> None:
    box = {"west": 10.0, "east": 22.0, "south": 7.0, "north": 80.0}
    assert shown(import_grid(pair.write(tmp_path), region="DEGREES", **box)) == part(pair, range(3), range(2))


def test_a_map_that_spans_longitude_0_takes_boxes_across_it(tmp_path: Path) -> None:
    pair = MegdrPair(rough(ROWS, COLUMNS), west=340.0)
    box = {"west": -5.0, "east": 5.0, "south": 0.0, "north": 10.0}
    terrain = import_grid(pair.write(tmp_path), region="DEGREES", **box)
    assert shown(terrain) == part(pair, range(10), range(15, 25))


@pytest.mark.parametrize("west", [-123.0, 236.99])
def test_limits_of_32_bits_reach_the_samples_of_a_fine_grid(
    pair: MegdrPair, tmp_path: Path, west: float
) -> None:
    """1/3 arc-second at 123 W, where 32 bits hold a twelfth of a cell."""
    cut = module("terrain.chosen_region")
    grid, step = module("formats").read_grid(pair.write(tmp_path)), 1.0 / 10_800.0
    place = replace(grid.georeference, first_x=west, first_y=38.3, step_x=step, step_y=step)
    fine = replace(grid, georeference=place)
    for first in range(COLUMNS - 2):
        limits = [place.x(first), place.x(first + 2), place.y(first % 18 + 2), place.y(first % 18)]
        box = cut.LongitudeLatitudeBox(*(float(np.float32(limit)) for limit in limits))
        region = cut.cut_grid(fine, box)
        assert (region.layout.columns, region.layout.rows) == (3, 3)
        assert region.georeference.x(0) == pytest.approx(limits[0], abs=step / 10.0)


def test_all_around_a_planet_is_the_planet(tmp_path: Path) -> None:
    box = {"west": 0.0, "east": 360.0, "south": -90.0, "north": 90.0}
    layout = kept_of(import_grid(planet().write(tmp_path), region="DEGREES", **box)).grid.layout
    assert (layout.columns, layout.rows, layout.wraps, layout.offset) == (360, 180, True, 0)


def test_a_box_across_the_seam_of_a_planet_is_one_region(tmp_path: Path) -> None:
    cut = module("terrain.chosen_region")
    grid = module("formats").read_grid(planet().write(tmp_path))
    region = cut.cut_grid(grid, cut.LongitudeLatitudeBox(350.0, 10.0, 0.0, 20.0))
    assert (region.layout.columns, region.layout.rows, region.layout.wraps) == (20, 20, False)
    assert region.decoding.first_column == 350
    assert region.georeference.x(0) == 350.5


def test_nothing_outside_the_region_is_mapped_or_measured(pair: MegdrPair, tmp_path: Path) -> None:
    heights = [list(row) for row in pair.heights]
    heights[0][0], heights[19][39] = 30_000, -30_000
    label = replace(pair, heights=heights).write(tmp_path)
    terrain = import_grid(label, region="SAMPLES", first_column=5, first_row=3, columns=7, rows=4)
    kept = kept_of(terrain)
    assert kept.grid.layout.offset == 2 * (3 * COLUMNS + 5)
    assert kept.grid.layout.byte_length == 2 * (6 * COLUMNS + 12)
    assert -2000 <= kept.minimum < kept.maximum <= 2001
    # What lies before and after may go, and touch still has all of it.
    data = label.with_suffix(".img")
    raw = data.read_bytes()
    data.write_bytes(b"\xff" * (2 * (3 * COLUMNS + 5)) + raw[2 * (3 * COLUMNS + 5) : 2 * (6 * COLUMNS + 12)])
    assert kept.grid.open().range().maximum == kept.maximum


@pytest.mark.parametrize(
    "choice",
    [
        {"region": "SAMPLES", "first_column": 39},
        {"region": "SAMPLES", "first_column": 50},
        {"region": "SAMPLES", "columns": 41},
        {"region": "SAMPLES", "rows": 1},
        {"region": "DEGREES", "west": 100.0, "east": 120.0},
        {"region": "DEGREES", "west": 30.0, "east": 40.0, "south": 5.0, "north": 5.0},
        {"region": "DEGREES", "west": 30.0, "east": 40.0, "south": 6.0, "north": -6.0},
        {"region": "DEGREES", "west": 30.1, "east": 30.2, "south": 0.0, "north": 5.0},
    ],
)
def test_a_region_that_is_not_there_is_explained(
    pair: MegdrPair, tmp_path: Path, choice: dict[str, Any]
) -> None:
    label, before = pair.write(tmp_path), contents()
    with pytest.raises(RuntimeError, match=r"grid\.lbl: region: found .*expected .*20\.5 to 59\.5 E"):
        import_grid(label, **choice)
    assert contents() == before


def test_a_region_is_for_one_call_only(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    import_grid(label, region="SAMPLES", columns=7, rows=4)
    assert len(import_grid(label).data.vertices) == ROWS * COLUMNS


def test_a_box_on_a_projected_map_is_the_rectangle_around_it(pair: MegdrPair, tmp_path: Path) -> None:
    """A polar map: the box around the pole is round, so what is cut is its square."""
    cut, formats = module("terrain.chosen_region"), module("formats")
    grid = formats.read_grid(pair.write(tmp_path))

    class Polar:
        """Equidistant from the pole, 1 km a degree."""

        name, in_degrees = "polar", False

        def forward(self, longitude: float, latitude: float, _ellipsoid: object) -> tuple[float, float]:
            from math import cos, radians, sin

            away = 1000.0 * (90.0 - latitude)
            return away * sin(radians(longitude)), -away * cos(radians(longitude))

        def inverse(self, _x: float, _y: float, _ellipsoid: object) -> None:
            return None  # its scale is not asked for here

        def turn(self, _ellipsoid: object) -> None:
            return None

    place = replace(
        grid.georeference,
        projection=Polar(),
        first_x=-20_000.0,
        first_y=10_000.0,
        step_x=1000.0,
        step_y=1000.0,
    )
    whole = replace(grid, georeference=place)
    region = cut.cut_grid(whole, cut.LongitudeLatitudeBox(0.0, 360.0, 86.0, 90.0))
    assert (region.georeference.x(0), region.georeference.y(0)) == (-4000.0, 4000.0)
    assert (region.layout.columns, region.layout.rows) == (9, 9)
