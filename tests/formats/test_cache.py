"""Decoded grids on the disk."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from proxygraph import Grid, GridLayout, Progress

from addon.formats import ElevationGrid, FormatError, Region, read_grid
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


def dead_process() -> int:
    """The number of a process that was."""
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        process.wait()
    return process.pid


def unfinished(folder: Path, process: int) -> Path:
    folder.mkdir(exist_ok=True)
    part = folder / f"x{caching.SUFFIX}.{process}.0.part"
    part.write_bytes(bytes(100))
    return part


def test_what_a_dead_process_left_goes_with_the_next_decoding(
    tmp_path: Path, small: Path, calls: list[Path | None]
) -> None:
    dead, living = unfinished(small, dead_process()), unfinished(small, os.getppid())
    whole = small / f"y{caching.SUFFIX}"
    whole.write_bytes(bytes(100))
    decoded(tmp_path).open()
    assert not dead.exists()
    assert living.exists()
    assert whole.exists()
    assert len(calls) == 1


def test_what_nobody_can_still_be_writing_goes_though_the_number_lives(
    tmp_path: Path, small: Path, calls: list[Path | None]
) -> None:
    old = unfinished(small, os.getpid())
    os.utime(old, (0, 0))
    decoded(tmp_path).open()
    assert not old.exists()
    assert len(calls) == 1


def test_a_file_that_is_being_written_counts_and_stays(small: Path) -> None:
    part = unfinished(small, os.getpid())
    whole = small / f"y{caching.SUFFIX}"
    whole.write_bytes(bytes(100))
    cache.most_on_disk = 150
    make_room(10)
    assert list(small.iterdir()) == [part]


def test_a_grid_larger_than_the_whole_cache_is_refused_before_anything_goes(
    tmp_path: Path, small: Path
) -> None:
    small.mkdir()
    other = small / f"other{caching.SUFFIX}"
    other.write_bytes(bytes(100))
    grid = read_grid(esri_ascii(tmp_path))
    cache.most_on_disk = grid.layout.byte_length - 1
    with pytest.raises(
        FormatError, match=r"grid\.asc: cache: found 24 bytes .* at most 23 .* smaller region"
    ):
        grid.open()
    assert list(small.iterdir()) == [other]


def test_a_cache_folder_that_cannot_be_made_is_not_blamed_on_the_data(tmp_path: Path, small: Path) -> None:
    small.write_text("a file where the folder should be")
    with pytest.raises(FormatError, match="cache: found the cache folder") as refused:
        read_grid(esri_ascii(tmp_path)).open()
    assert str(small) in str(refused.value)
    assert "24 bytes" in str(refused.value)
    assert "Put the data file back" not in str(refused.value)


def test_a_cache_folder_that_may_not_be_written_to_is_named(
    tmp_path: Path, small: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    small.mkdir()
    monkeypatch.setattr(os, "access", lambda *_: False)  # the person who runs the tests may be allowed all
    with pytest.raises(FormatError, match=f"cache: found the cache folder {small} .*denied"):
        read_grid(esri_ascii(tmp_path)).open()


@pytest.mark.usefixtures("small")
def test_a_full_disk_is_not_blamed_on_the_data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def decode(*_: object) -> Grid:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setitem(DECODERS, "test", decode)
    with pytest.raises(FormatError, match=r"cache: found the cache folder .*No space left.*Free space"):
        decoded(tmp_path).open()


@pytest.mark.skipif(sys.platform != "linux", reason="files are limited as Linux allows it")
@pytest.mark.usefixtures("small")
def test_room_that_the_system_refuses_a_native_decoder_is_told_with_the_folder(tmp_path: Path) -> None:
    import resource

    grid = read_grid(esri_ascii(tmp_path))
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (10, hard))
    try:
        with pytest.raises(FormatError) as refused:
            grid.open()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert "cache: found the cache folder" in str(refused.value)
    assert "(File too large)" in str(refused.value)
    assert not list(cache.folder.iterdir())


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
