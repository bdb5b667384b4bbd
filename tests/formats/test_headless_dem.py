"""GTOPO30 tiles without their header."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import read_grid
from tests.formats.reading import complaint

SIZES = {57_600_000: (6000, 4800), 51_840_000: (3600, 7200)}


def sparse(path: Path, size: int) -> Path:
    """A file of that size which takes no room."""
    with path.open("wb") as file:
        file.write(b"\xd8\xf1\x01\x02")
        file.truncate(size)
    return path


@pytest.mark.parametrize("size", SIZES)
def test_size_and_name_of_a_tile_are_enough(tmp_path: Path, size: int) -> None:
    grid = read_grid(sparse(tmp_path / "w020n90.dem", size))
    assert (grid.layout.rows, grid.layout.columns) == SIZES[size]
    assert grid.georeference.x(-0.5) == pytest.approx(-20.0)
    assert grid.georeference.y(-0.5) == pytest.approx(90.0)
    assert grid.open().elevation(0, 0) is None
    assert "no .HDR" in " ".join(grid.notes)


@pytest.mark.parametrize(
    ("name", "size"), [("W020N90.DEM", 57_600_001), ("ANTARCPS.DEM", 58_320_000), ("mine.dem", 57_600_000)]
)
def test_otherwise_the_known_sizes_are_offered(tmp_path: Path, name: str, size: int) -> None:
    text = complaint(sparse(tmp_path / name, size))
    for word in (".HDR", f"{size:,}", "57,600,000", "51,840,000", "58,320,000"):
        assert word in text
