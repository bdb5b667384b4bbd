"""Grids that were decoded stay open for touch."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import bpy
import pytest

from tests.addon.decoded import decode_everything
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough


@pytest.fixture
def label(tmp_path: Path) -> Path:
    return MegdrPair(rough(9, 13)).write(tmp_path)


def opened() -> Any:
    return module("touch.live").live.opened


def test_touch_uses_what_the_import_decoded(label: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    calls = decode_everything(monkeypatch)
    import_grid(label)
    for _ in range(2):
        bpy.ops.haptic_terrain.touch_start()
        bpy.ops.haptic_terrain.touch_stop()
    assert len(calls) == 1


def test_a_loaded_file_decodes_again_once_and_finds_the_same_grid(
    label: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = decode_everything(monkeypatch)
    import_grid(label)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "kept.blend"))
    assert len(opened()) == 0
    for _ in range(2):
        bpy.ops.haptic_terrain.touch_start()
        bpy.ops.haptic_terrain.touch_stop()
    assert len(calls) == 2


def test_mapped_grids_are_not_kept_open(label: Path) -> None:
    import_grid(label)
    bpy.ops.haptic_terrain.touch_start()
    assert len(opened()) == 0


def kept_grids(label: Path, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    decode_everything(monkeypatch)
    kept = module("terrain.kept").recall(import_grid(label))
    decoding = module("formats.decoding").Decoding
    return [
        replace(kept, grid=replace(kept.grid, decoding=decoding("test", options={"page": page})))
        for page in range(3)
    ]


def test_the_longest_unused_grids_are_let_go(label: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = kept_grids(label, monkeypatch)
    size = kept[0].grid.layout.byte_length
    grids = module("terrain.opened").OpenedGrids(most_bytes=2 * size)
    first, second = grids.open(kept[0]), grids.open(kept[1])
    assert grids.open(kept[0]) is first
    grids.open(kept[2])
    assert len(grids) == 2
    assert grids.open(kept[0]) is first
    assert grids.open(kept[1]) is not second


def test_a_grid_larger_than_all_room_is_kept_alone(label: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = kept_grids(label, monkeypatch)
    grids = module("terrain.opened").OpenedGrids(most_bytes=1)
    assert grids.open(kept[0]) is grids.open(kept[0])
    grids.open(kept[1])
    assert len(grids) == 1


def shorten(data: Path) -> None:
    data.write_bytes(data.read_bytes()[:-2])


def lengthen(data: Path) -> None:
    data.write_bytes(data.read_bytes() + b"\0\0")


def change(data: Path) -> None:
    raw = bytearray(data.read_bytes())
    raw[7] ^= 1
    status = data.stat()
    data.write_bytes(raw)
    os.utime(data, ns=(status.st_atime_ns, status.st_mtime_ns + 1))


@pytest.mark.parametrize("spoil", [shorten, lengthen, change])
@pytest.mark.parametrize("decoded", [False, True])
def test_a_file_that_was_changed_since_is_told_and_not_touched(
    label: Path, monkeypatch: pytest.MonkeyPatch, spoil: Callable[[Path], None], decoded: bool
) -> None:
    if decoded:
        decode_everything(monkeypatch)
    import_grid(label)
    spoil(label.with_suffix(".img"))
    with pytest.raises(RuntimeError, match=r"grid\.img: data file: found .*import the grid again"):
        bpy.ops.haptic_terrain.touch_start()
    assert module("touch.live").live.touch is None


def test_a_copied_file_is_the_same_file(label: Path) -> None:
    import_grid(label)
    os.utime(label.with_suffix(".img"), ns=(1, 1))
    assert bpy.ops.haptic_terrain.touch_start() == {"FINISHED"}


def test_what_a_decoder_needs_is_remembered_whatever_it_is(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    decode_everything(monkeypatch)
    terrain = import_grid(label)
    keeping, decoding = module("terrain.kept"), module("formats.decoding").Decoding
    kept = keeping.recall(terrain)
    options = {"offset": 2**40, "none": None, "list": [1.5, "x"], "nested": {"page": 3}}
    kept = replace(kept, grid=replace(kept.grid, decoding=decoding("test", 2**33, 5, options)), filled=True)
    keeping.keep(terrain, kept)
    assert keeping.recall(terrain) == kept


RAW = {
    "rows": "3",
    "columns": "4",
    "sample": "i16",
    "byte_order": "big",
    "offset": "0",
    "pixel_stride": "2",
    "row_stride": "8",
    "south_first": False,
    "wraps": False,
}


@pytest.mark.parametrize(
    "changed",
    [
        {"kind": "evil"},
        {"kind": ["raw"]},
        {"kind": "raw"},
        {"kind": "raw", "options": {"samples": 1}},
        {"kind": "raw", "options": {"samples": {**RAW, "sample": "u24"}}},
        {"kind": "raw", "options": {"samples": {**RAW, "rows": "9" * 40}}},
        {"kind": "geotiff", "options": {"south_up": False}},
        {"kind": "geotiff", "options": {"south_up": False, "fill": "x"}},
        {"kind": "usgs_dem", "options": [1]},
        {"kind": "usgs_dem", "first_column": -1},
        {"kind": "usgs_dem", "first_row": 2**80},
        {"kind": "usgs_dem", "first_row": 0.5},
        {"kind": "usgs_dem", "unheard_of": 1},
        {},
        [],
    ],
)
def test_a_decoding_that_was_changed_is_told(label: Path, changed: object) -> None:
    terrain = import_grid(label)
    keeping = module("terrain.kept")
    terrain[keeping.KEY]["decoding"] = json.dumps(changed)
    with pytest.raises(keeping.KeptError, match="does not remember its grid"):
        keeping.recall(terrain)
    with pytest.raises(RuntimeError, match="does not remember its grid"):
        bpy.ops.haptic_terrain.touch_start()


def test_a_whole_decoding_is_recalled(label: Path) -> None:
    terrain = import_grid(label)
    keeping = module("terrain.kept")
    terrain[keeping.KEY]["decoding"] = json.dumps({"kind": "raw", "options": {"samples": RAW}})
    assert keeping.recall(terrain).grid.decoding.options == {"samples": RAW}


def test_cache_files_lie_in_the_extension_s_own_folder() -> None:
    folder = module("formats.cache").cache.folder
    package = str(module("registration").__package__)
    assert folder == Path(bpy.utils.extension_path_user(package, path="cache"))
    assert folder.is_relative_to(os.environ["BLENDER_USER_RESOURCES"])
