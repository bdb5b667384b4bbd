"""Grids over files and buffers: in place, locked while in use, refused in words."""

from __future__ import annotations

import mmap
import os
import struct
import sys
from array import array
from pathlib import Path

import pytest
from proxygraph import ContactModel, Grid, GridError, GridLayout

from tests.native.touching import over_the_middle, pressing, touch

LAYOUT = GridLayout(2, 3, cell_width=1.0, cell_height=1.0)
HEIGHTS = [1, -2, 3, -4, 5, -6]
BYTES = struct.pack(">6h", *HEIGHTS)


def samples(grid: Grid) -> list[float]:
    return list(grid.elevations(range(3), range(2)))


def test_a_file_is_read_in_place(tmp_path: Path) -> None:
    path = tmp_path / "grid.img"
    path.write_bytes(BYTES)
    grid = Grid.open(path, LAYOUT)
    assert samples(grid) == HEIGHTS
    with path.open("r+b") as file:
        file.write(struct.pack(">h", 77))
    assert grid.elevation(0, 0) == 77
    assert not grid.damaged


def test_a_path_may_be_text(tmp_path: Path) -> None:
    path = tmp_path / "grid.img"
    path.write_bytes(BYTES)
    assert samples(Grid.open(os.fspath(path), LAYOUT)) == HEIGHTS


def test_a_short_file_is_refused_with_both_lengths(tmp_path: Path) -> None:
    path = tmp_path / "short.img"
    path.write_bytes(BYTES[:-1])
    with pytest.raises(GridError, match=r"short\.img holds 11 bytes.*need 12"):
        Grid.open(path, LAYOUT)


def test_a_missing_file_and_a_folder_are_refused_by_name(tmp_path: Path) -> None:
    with pytest.raises(GridError, match=r"absent\.img"):
        Grid.open(tmp_path / "absent.img", LAYOUT)
    with pytest.raises(GridError, match="not a file"):
        Grid.open(tmp_path, LAYOUT)


def test_a_change_in_the_buffer_is_seen_and_felt() -> None:
    buffer = bytearray(BYTES)
    grid = Grid.from_buffer(buffer, LAYOUT)
    assert grid.elevation(1, 1) == 5
    model = ContactModel(grid)
    model.place(1.2, -0.9, 50.0)
    before = model.update(1.2, -0.9, -50.0).proxy
    buffer[:] = struct.pack(">6h", *[height + 10 for height in HEIGHTS])
    assert samples(grid) == [height + 10 for height in HEIGHTS]
    model.place(1.2, -0.9, 50.0)
    after = model.update(1.2, -0.9, -50.0).proxy
    assert after != before


def test_the_buffer_is_locked_as_long_as_the_grid_lives() -> None:
    buffer = bytearray(BYTES)
    grid = Grid.from_buffer(buffer, LAYOUT)
    with pytest.raises(BufferError):
        buffer.append(0)
    del grid
    buffer.append(0)
    assert len(buffer) == 13


def test_models_and_sessions_keep_the_buffer_locked() -> None:
    buffer = bytearray(BYTES)
    model = ContactModel(Grid.from_buffer(buffer, LAYOUT))
    with pytest.raises(BufferError):
        buffer.clear()
    del model
    session = touch(Grid.from_buffer(buffer, LAYOUT), pressing())
    session.step(1)
    with pytest.raises(BufferError):
        buffer.clear()
    del session
    buffer.clear()


def test_a_short_buffer_is_refused_and_not_kept_locked() -> None:
    buffer = bytearray(BYTES[:-1])
    with pytest.raises(GridError, match=r"buffer holds 11 bytes.*need 12"):
        Grid.from_buffer(buffer, LAYOUT)
    buffer.append(0)


def test_a_buffer_with_gaps_is_refused() -> None:
    with pytest.raises(GridError, match="not C-contiguous"):
        Grid.from_buffer(memoryview(BYTES * 2)[::2], LAYOUT)


def test_what_is_no_buffer_is_a_type_error() -> None:
    with pytest.raises(TypeError):
        Grid.from_buffer([1, 2, 3], LAYOUT)  # type: ignore[arg-type]


def test_any_contiguous_buffer_will_do(tmp_path: Path) -> None:
    words = array("h", HEIGHTS)
    if sys.byteorder == "little":
        words.byteswap()
    assert samples(Grid.from_buffer(words, LAYOUT)) == HEIGHTS
    assert samples(Grid.from_buffer(BYTES, LAYOUT)) == HEIGHTS
    assert samples(Grid.from_buffer(memoryview(b"??" + BYTES)[2:], LAYOUT)) == HEIGHTS
    assert samples(Grid.from_buffer(memoryview(BYTES).cast("B", (2, 6)), LAYOUT)) == HEIGHTS
    path = tmp_path / "mapped.img"
    path.write_bytes(BYTES)
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as mapped:
        grid = Grid.from_buffer(mapped, LAYOUT)
        assert samples(grid) == HEIGHTS
        with pytest.raises(BufferError):
            mapped.close()
        del grid


def test_a_window_may_lie_off_the_map() -> None:
    session = touch(Grid.from_buffer(BYTES, LAYOUT), pressing())
    assert session.window.east == over_the_middle().east > LAYOUT.columns
    session.step(100)
    assert session.state().force == (0.0, 0.0, 0.0)
