"""What a grid says of its heights."""

from __future__ import annotations

import math
import struct
from pathlib import Path

import pytest
from proxygraph import Grid, GridLayout

from tests.native.grounds import ground

MOLA = Path(__file__).resolve().parents[3] / "shared" / "data" / "mola" / "megt90n000cb.img"
VOID = -9999


def four_by_three(*, wraps: bool = False) -> Grid:
    layout = GridLayout(3, 4, cell_width=1.0, cell_height=1.0, void=VOID, wraps=wraps)
    return Grid.from_buffer(struct.pack(">12h", 1, 2, 3, 4, 5, VOID, 7, 8, 9, 10, 11, 12), layout)


@pytest.mark.parametrize(
    ("sample", "letter", "heights"),
    [
        ("i16", "h", [-32768, 32767, 0, 1]),
        ("u16", "H", [0, 65535, 32768, 1]),
        ("i32", "i", [-(2**31), 2**31 - 1, 0, 1]),
        ("f32", "f", [-0.5, 0.25, 2.0**100, 0.0]),
        ("f64", "d", [-0.1, 1e99, 5e-324, 0.0]),
    ],
)
@pytest.mark.parametrize(("byte_order", "mark"), [("big", ">"), ("little", "<")])
def test_every_sample_type_in_either_byte_order(
    sample: str, letter: str, heights: list[float], byte_order: str, mark: str
) -> None:
    layout = GridLayout(2, 2, cell_width=1.0, cell_height=1.0, sample=sample, byte_order=byte_order)  # type: ignore[arg-type]
    grid = Grid.from_buffer(struct.pack(f"{mark}4{letter}", *heights), layout)
    assert grid.elevations([0, 1], [0, 1]).tolist() == heights


def test_elevations_are_row_major_doubles_in_the_order_asked_for() -> None:
    view = four_by_three().elevations([3, 0], [2, 0])
    assert (view.format, view.tolist()) == ("d", [12.0, 9.0, 4.0, 1.0])
    assert four_by_three().elevations([], [0]).tolist() == []


def test_void_and_what_is_off_the_map_are_nan_in_rows_and_none_alone() -> None:
    grid = four_by_three()
    inside, void, east, north = grid.elevations([0, 1], [1]).tolist() + grid.elevations([4, 0], [-1]).tolist()
    assert inside == 5.0
    assert all(math.isnan(height) for height in (void, east, north))
    assert [grid.elevation(*cell) for cell in [(1, 1), (4, 0), (-1, 0), (0, 3)]] == [None] * 4


def test_columns_run_on_around_a_planet() -> None:
    grid = four_by_three(wraps=True)
    assert grid.elevations([-1, 3, 4, 4_000_000_001], [0]).tolist() == [4.0, 4.0, 1.0, 2.0]
    assert grid.elevation(-4, 2) == 9.0
    assert grid.elevation(0, 3) is None, "rows do not wrap"


def test_each_half_of_a_cell_is_its_own_plane() -> None:
    # Only the south-west sample is high; the diagonal runs from north-west to south-east.
    grid = ground([[0.0, 0.0], [8.0, 0.0]], cell=10.0)
    assert grid.elevation_at(7.5, -2.5) == 0.0
    assert grid.elevation_at(2.5, -7.5) == 4.0
    assert grid.elevation_at(5.0, -5.0) == 0.0
    assert grid.elevation_at(0.0, -10.0) == 8.0


def test_there_is_no_surface_in_a_hole_nor_off_the_map() -> None:
    grid = four_by_three()
    assert grid.elevation_at(0.8, -0.3) is None, "a corner is void"
    assert grid.elevation_at(2.8, -0.3) is not None
    for east, north in [(-0.1, 0.0), (3.1, 0.0), (0.0, 0.1), (0.0, -2.1), (math.nan, 0.0), (math.inf, 0.0)]:
        assert grid.elevation_at(east, north) is None


def test_a_planet_has_a_surface_across_its_seam() -> None:
    grid = four_by_three(wraps=True)
    assert grid.elevation_at(3.5, 0.0) == 2.5
    assert grid.elevation_at(7.5, 0.0) == 2.5
    assert grid.elevation_at(-0.5, 0.0) == 2.5


def test_range_finds_the_first_extremes_and_counts_voids() -> None:
    layout = GridLayout(3, 2, cell_width=1.0, cell_height=1.0, void=VOID, scale=-2.0, value_offset=1.0)
    found = Grid.from_buffer(struct.pack(">6h", 3, VOID, 5, 3, 5, 3), layout).range()
    assert found is not None
    assert (found.minimum, found.minimum_cell) == (-9.0, (0, 1))
    assert (found.maximum, found.maximum_cell) == (-5.0, (0, 0))
    assert found.voids == 1


def test_there_is_no_range_where_all_is_void() -> None:
    assert ground([[math.nan, math.inf], [-math.inf, math.nan]]).range() is None


@pytest.mark.skipif(not MOLA.is_file(), reason="the real MOLA grid is not beside the checkout")
def test_the_real_planet_in_its_raw_bytes() -> None:
    layout = GridLayout(720, 1440, cell_width=14818.0, cell_height=14818.0, wraps=True)
    grid = Grid.open(MOLA, layout)
    assert (layout.samples, layout.triangles) == (1_036_800, 2_070_720)
    found = grid.range()
    assert found is not None
    assert (found.maximum, found.maximum_cell) == (21134.0, (907, 290))
    assert (found.minimum, found.minimum_cell) == (-8068.0, (248, 491))
    assert found.voids == 0
    assert grid.elevation(907 - 1440, 290) == 21134.0


def test_columns_beyond_every_type_are_off_the_map() -> None:
    grid = ground([[1.0, 2.0], [3.0, 4.0]])
    assert grid.elevation(2**70, 0) is None
    assert grid.elevation(0, -(2**200)) is None
