"""Holes that are filled from what surrounds them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from struct import pack
from typing import Literal

import pytest
from proxygraph import CancelledError, Grid, GridLayout, Progress

CODES = {"i16": "h", "u16": "H", "i32": "i", "f32": "f", "f64": "d"}

Sample = Literal["i16", "u16", "i32", "f32", "f64"]
Rows = Sequence[Sequence[float]]

VOID = 9999


def grid_of(
    rows: Rows,
    sample: Sample = "f64",
    *,
    byte_order: Literal["big", "little"] = "little",
    void: float | None = VOID,
    wraps: bool = False,
    scale: float = 1.0,
    value_offset: float = 0.0,
) -> Grid:
    """A grid in memory, with a gap after every row."""
    order = "<" if byte_order == "little" else ">"
    numbers = [[number if sample.startswith("f") else int(number) for number in row] for row in rows]
    data = b"".join(pack(f"{order}{len(row)}{CODES[sample]}", *row) + b"gap!" for row in numbers)
    size = len(data) // len(rows)
    layout = GridLayout(
        len(rows),
        len(rows[0]),
        cell_width=30.0,
        cell_height=30.0,
        sample=sample,
        byte_order=byte_order,
        row_stride=size,
        void=void,
        wraps=wraps,
        scale=scale,
        value_offset=value_offset,
    )
    return Grid.from_buffer(data, layout)


def heights(grid: Grid) -> list[list[float | None]]:
    """Every sample."""
    layout = grid.layout
    return [[grid.elevation(column, row) for column in range(layout.columns)] for row in range(layout.rows)]


def hill(rows: int, columns: int, hole: tuple[int, int, int, int]) -> list[list[float]]:
    """A smooth hill with a hole: first column, first row, columns, rows."""
    first_column, first_row, width, height = hole
    return [
        [
            VOID
            if first_column <= column < first_column + width and first_row <= row < first_row + height
            else round(500.0 * math.exp(-(((column - 20) / 15) ** 2) - ((row - 15) / 12) ** 2))
            for column in range(columns)
        ]
        for row in range(rows)
    ]


@pytest.mark.parametrize("sample", list(CODES))
@pytest.mark.parametrize("byte_order", ["big", "little"])
def test_what_is_known_stays_and_holes_lie_between_their_rims(
    sample: Sample, byte_order: Literal["big", "little"]
) -> None:
    rows = hill(30, 40, (10, 8, 9, 11))
    grid = grid_of(rows, sample, byte_order=byte_order)
    filled = grid.filled()
    assert filled.layout.sample == sample
    assert filled.layout.byte_order == byte_order
    assert filled.layout.void == VOID
    rim = [rows[row][column] for row in range(7, 20) for column in range(9, 20) if rows[row][column] != VOID]
    for row, (before, after) in enumerate(zip(heights(grid), heights(filled), strict=True)):
        for column, (known, made) in enumerate(zip(before, after, strict=True)):
            assert made is not None
            if known is not None:
                assert made == known
            else:
                assert min(rim) <= made <= max(rim), (column, row)


def test_a_plane_is_completed() -> None:
    plane = [[10.0 * column + 3.0 * row for column in range(24)] for row in range(24)]
    holed = [
        [VOID if 8 <= row < 14 and 7 <= column < 15 else height for column, height in enumerate(line)]
        for row, line in enumerate(plane)
    ]
    for row, line in enumerate(heights(grid_of(holed).filled())):
        for column, height in enumerate(line):
            assert height is not None
            # A tenth of the hole's relief.
            assert abs(height - plane[row][column]) < 8.0


def test_a_large_hole_is_smooth() -> None:
    size = 200
    rows = [
        [VOID if 10 <= row < 190 and 10 <= column < 190 else float(column) for column in range(size)]
        for row in range(size)
    ]
    filled = heights(grid_of(rows).filled())
    for row in range(10, 190):
        for column in range(9, 190):
            here, east = filled[row][column], filled[row][column + 1]
            assert here is not None
            assert east is not None
            assert abs(east - here) < 8.0


def test_each_hole_has_its_own_rim() -> None:
    low = [1.0, 2.0, 1.0, 2.0, 1.0, 2.0]
    rows = [low, [1.0, VOID, 2.0, 900.0, VOID, 901.0], low, low]
    rows[0] = [1.0, 2.0, 1.0, 900.0, 901.0, 902.0]
    rows[2] = [1.0, 2.0, 1.0, 903.0, 904.0, 905.0]
    filled = grid_of(rows).filled()
    west, east = filled.elevation(1, 1), filled.elevation(4, 1)
    assert west is not None
    assert east is not None
    assert 1.0 <= west <= 2.0
    assert 900.0 <= east <= 905.0


def test_voids_that_touch_at_a_corner_are_one_hole() -> None:
    rows = [[1.0, 1.0, 1.0, 1.0], [1.0, VOID, 5.0, 1.0], [1.0, 5.0, VOID, 9.0], [1.0, 1.0, 9.0, 9.0]]
    filled = grid_of(rows).filled()
    for cell in ((1, 1), (2, 2)):
        height = filled.elevation(*cell)
        assert height is not None
        assert 1.0 <= height <= 9.0


def test_holes_at_the_edges_and_corners() -> None:
    rows = [[VOID] * 5 + [7.0] for _ in range(5)] + [[VOID] * 6]
    assert all(height == 7.0 for line in heights(grid_of(rows).filled()) for height in line)


def test_a_hole_across_the_seam_of_a_planet_is_one() -> None:
    rows = [[10.0] * 8, [VOID, VOID, 20.0, 20.0, 20.0, 20.0, VOID, VOID], [10.0] * 8]
    filled = grid_of(rows, wraps=True).filled()
    assert filled.layout.wraps
    made = [filled.elevation(column, 1) for column in (6, 7, 0, 1)]
    assert made == pytest.approx(made[::-1], abs=2.0)
    assert all(height is not None and 10.0 <= height <= 20.0 for height in made)
    # Without the seam the eastern hole would know nothing of the western one's rim.
    rows[1][2] = 15.0
    rows[0][0:3] = [0.0, 0.0, 0.0]
    eastern = grid_of(rows, wraps=True).filled().elevation(7, 1)
    alone = grid_of(rows, wraps=False).filled().elevation(7, 1)
    assert eastern is not None
    assert alone is not None
    assert eastern < alone


def test_a_made_up_height_is_never_the_void_value() -> None:
    rows = [[8.0, 8.0, 8.0], [8.0, 9.0, 10.0], [10.0, 10.0, 10.0]]
    grid = grid_of(rows, "i16", void=9)
    filled = grid.filled()
    assert filled.elevation(1, 1) in {8.0, 10.0}


def test_scale_and_offset_are_heeded() -> None:
    rows = [[100, 100, 104], [100, VOID, 104], [100, 104, 104]]
    filled = grid_of(rows, "i16", scale=-0.25, value_offset=1000.0).filled()
    height = filled.elevation(1, 1)
    assert height is not None
    assert 1000.0 - 26.0 <= height <= 1000.0 - 25.0
    assert filled.elevation(2, 0) == 1000.0 - 26.0


def test_nan_without_a_void_value() -> None:
    rows = [[1.0, 2.0], [3.0, math.nan], [5.0, 6.0]]
    filled = grid_of(rows, "f32", void=None).filled()
    height = filled.elevation(1, 1)
    assert height is not None
    assert 1.0 <= height <= 6.0


def test_a_grid_of_voids_and_a_grid_without_any() -> None:
    assert grid_of([[VOID, VOID], [VOID, VOID]]).filled().range() is None
    whole = [[1.0, 2.0], [3.0, 4.0]]
    assert heights(grid_of(whole).filled()) == whole


def test_a_checkered_grid() -> None:
    rows = [[VOID if (row + column) % 2 else 5.0 for column in range(101)] for row in range(77)]
    assert all(height == 5.0 for line in heights(grid_of(rows).filled()) for height in line)


def test_the_same_grid_gives_the_same_heights() -> None:
    grid = grid_of(hill(30, 40, (5, 5, 20, 20)))
    assert heights(grid.filled()) == heights(grid.filled())


def test_filling_can_be_watched_and_cancelled() -> None:
    grid = grid_of(hill(30, 40, (5, 5, 20, 20)))
    progress = Progress()
    grid.filled(progress)
    assert progress.share == 1.0
    progress.cancel()
    with pytest.raises(CancelledError):
        grid.filled(progress=progress)
