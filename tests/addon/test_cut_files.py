"""Files that are cut in the middle of an import: what is lost reads as zeros, and zeros are no heights."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.addon.scene import module
from tests.formats.megdr_pair import MegdrPair, rough

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="a mapped file is cut as Linux allows it")


@pytest.fixture
def label(tmp_path: Path) -> Path:
    heights = rough(64, 128)
    heights[4][5] = -32768
    return MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path)


def cutting(data: Path, step: str) -> Any:
    """Work that loses most of a file as soon as a step begins."""
    work = module("terrain.work").Work()
    begin = work.begin

    def begun(words: str, *, until: float) -> Any:
        if words.startswith(step):
            os.truncate(data, 4096)
        return begin(words, until=until)

    work.begin = begun
    return work


def cut_when_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every grid lose most of its file as soon as it is mapped."""
    kind = module("formats").ElevationGrid
    opened = kind.open

    def open_and_cut(grid: Any, progress: Any = None) -> Any:
        samples = opened(grid, progress)
        os.truncate(grid.data_path, 4096)
        return samples

    monkeypatch.setattr(kind, "open", open_and_cut)


@pytest.mark.parametrize(
    ("step", "fill_voids"),
    [
        ("Measuring", False),
        ("Choosing", False),
        ("Filling", True),
        ("Choosing", True),  # what is filled is told from the file's own voids
    ],
)
def test_a_file_that_is_cut_during_an_import_is_refused_by_name(
    label: Path, step: str, fill_voids: bool
) -> None:
    options = module("terrain.options").ImportOptions(fill_voids=fill_voids)
    with pytest.raises(ValueError, match=r"grid\.img: samples: found a file that was cut") as refused:
        module("terrain.prepare").prepare(label, options, cutting(label.with_suffix(".img"), step))
    assert isinstance(refused.value, module("formats").FormatError)


def test_a_kept_terrain_is_not_filled_from_a_file_that_is_cut(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    prepare = module("terrain.prepare")
    options = module("terrain.options").ImportOptions(fill_voids=True)
    kept = prepare.prepare(label, options, module("terrain.work").Work()).kept
    cut_when_opened(monkeypatch)
    with pytest.raises(module("formats").FormatError, match=r"grid\.img: samples"):
        module("terrain.opened").OpenedGrids().open(kept)


def test_the_import_dialog_tells_no_heights_of_a_file_that_is_cut(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    description = module("ui.import_description")
    cut_when_opened(monkeypatch)
    text = " ".join(description.described(label, module("terrain.options").ImportOptions()))
    assert "that was cut" in text
    description._cached_extremes.cache_clear()
