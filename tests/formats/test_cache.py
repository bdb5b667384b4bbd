"""Decoded grids on the disk."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from proxygraph import Grid, GridLayout, Progress

from addon.formats import ElevationGrid, Region, read_grid
from addon.formats import cache as caching
from addon.formats.cache import cache, cache_file, cached_file, make_room
from addon.formats.decoders import DECODERS
from addon.formats.decoding import Decoding
from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.raw_grids import EhdrPair
from tests.formats.tiff_file import TiffFile
from tests.formats.usgs_dem_file import DemFile


@pytest.fixture
def small(tmp_path: Path) -> Iterator[Path]:
    """A cache that takes everything into files."""
    before = replace(cache)
    cache.folder, cache.most_in_memory = tmp_path / "cache", 0
    yield cache.folder
    cache.folder, cache.most_in_memory = before.folder, before.most_in_memory
    cache.most_on_disk = before.most_on_disk


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[Path | None]:
    """What the decoder of these tests was asked for: the file that it was to write."""
    asked: list[Path | None] = []

    def decode(path: Path, layout: GridLayout, decoding: Decoding, _progress: Progress | None) -> Grid:
        place = cache_file(path, layout, decoding)
        asked.append(place)
        raw = path.read_bytes()[: layout.byte_length]
        if place is None:
            return Grid.from_buffer(raw, layout)
        place.write_bytes(raw)
        return Grid.open(place, layout)

    monkeypatch.setitem(DECODERS, "test", decode)
    return asked


def decoded(tmp_path: Path) -> ElevationGrid:
    grid = read_grid(MegdrPair(rough(9, 13)).write(tmp_path))
    return replace(grid, decoding=Decoding("test", options={"page": 1}))


def test_small_grids_stay_in_memory(tmp_path: Path, calls: list[Path | None]) -> None:
    assert decoded(tmp_path).open().elevation(0, 0) == -2000.0
    assert calls == [None]


@pytest.mark.usefixtures("small")
def test_a_large_grid_is_decoded_once(tmp_path: Path, calls: list[Path | None]) -> None:
    grid = decoded(tmp_path)
    first, second = grid.open(), grid.open()
    assert len(calls) == 1
    assert [first.elevation(5, 5), second.elevation(5, 5)] == [float(rough(9, 13)[5][5])] * 2


@pytest.mark.usefixtures("small")
def test_a_changed_file_a_region_and_another_page_are_decoded_anew(
    tmp_path: Path, calls: list[Path | None]
) -> None:
    grid = decoded(tmp_path)
    grid.open()
    status = grid.data_path.stat()
    os.utime(grid.data_path, ns=(status.st_atime_ns, status.st_mtime_ns + 1))
    grid.open()
    replace(grid, decoding=Decoding("test", options={"page": 2})).open()
    grid.region(Region(0, 0, 13, 4)).open()
    assert len(set(calls)) == len(calls) == 4


def test_a_cache_file_of_another_length_is_not_believed(
    tmp_path: Path, small: Path, calls: list[Path | None]
) -> None:
    grid = decoded(tmp_path)
    grid.open()
    only = next(small.iterdir())
    only.write_bytes(only.read_bytes()[:-1])
    assert grid.open().elevation(12, 8) == float(rough(9, 13)[8][12])
    assert len(calls) == 2


def test_the_longest_unused_files_make_room(small: Path) -> None:
    small.mkdir()
    for number in range(4):
        file = small / f"{number}{caching.SUFFIX}"
        file.write_bytes(bytes(100))
        os.utime(file, ns=(0, number))
    (small / "kept.txt").write_bytes(bytes(1000))
    cache.most_on_disk = 350
    make_room(100)
    assert sorted(file.name for file in small.iterdir()) == ["2.samples", "3.samples", "kept.txt"]


def test_use_makes_a_file_young(tmp_path: Path, small: Path, calls: list[Path | None]) -> None:
    grid = decoded(tmp_path)
    grid.open()
    file = next(small.iterdir())
    os.utime(file, ns=(0, 0))
    assert cached_file(grid.data_path, grid.layout, Decoding("test", options={"page": 1})) == file
    assert file.stat().st_mtime_ns > 0
    assert len(calls) == 1


def test_what_an_unfinished_decoder_left_counts_and_goes(small: Path) -> None:
    small.mkdir()
    (small / f"x{caching.SUFFIX}.123.part").write_bytes(bytes(100))
    cache.most_on_disk = 50
    make_room(10)
    assert not list(small.iterdir())


def esri_ascii(folder: Path) -> Path:
    path = folder / "grid.asc"
    path.write_text("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n1 2 3\n4 5 6.5\n")
    return path


def geotiff(folder: Path) -> Path:
    path = folder / "grid.tif"
    path.write_bytes(TiffFile(rough(5, 7), compression=8).data())
    return path


def bands(folder: Path) -> Path:
    words = {"NBANDS": 2, "LAYOUT": "BIP", "TOTALROWBYTES": None}
    return EhdrPair(words=words, data=bytes(range(100))).write(folder)


def usgs_dem(folder: Path) -> Path:
    path = folder / "grid.dem"
    path.write_bytes(DemFile().data())
    return path


@pytest.mark.parametrize("write", [esri_ascii, geotiff, bands, usgs_dem])
def test_every_native_decoder_writes_large_grids_to_the_disk_and_maps_them(
    tmp_path: Path, small: Path, write: Callable[[Path], Path]
) -> None:
    cache.most_in_memory = 1 << 30
    described = read_grid(write(tmp_path))
    expected = described.open().elevations(range(3), range(2)).tobytes()
    assert not any(small.parent.glob("cache/*"))
    cache.most_in_memory = 0
    assert described.open().elevations(range(3), range(2)).tobytes() == expected
    (file,) = small.iterdir()
    assert file.stat().st_size == described.layout.byte_length
