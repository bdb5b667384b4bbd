"""The bench of readers refuses to race two that read different places."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import read_grid

rasterio = pytest.importorskip("rasterio", reason="the bench measures beside it")


def written(folder: Path, *, corner: float = 500_000.0, cell: float = 30.0) -> Path:
    path = folder / "grid.asc"
    header = f"ncols 3\nnrows 2\nxllcorner {corner}\nyllcorner 4100000\ncellsize {cell}\n"
    path.write_text(header + "1 2 3\n4 5 6\n")
    return path


def check(folder: Path, seen: Path) -> None:
    """Compare our place of one file with that which GDAL sees in another."""
    from tests.bench.measure_formats import check_place

    folder.mkdir()
    place = read_grid(written(folder)).georeference
    with rasterio.open(seen) as file:
        check_place(seen, place, (3, 2), file.xy(0, 0), file.xy(1, 2))


def test_readers_that_agree_are_raced(tmp_path: Path) -> None:
    check(tmp_path / "ours", written(tmp_path))


@pytest.mark.parametrize("changes", [{"corner": 500_003.0}, {"corner": 499_985.0}, {"cell": 30.001}])
def test_a_shift_of_a_part_of_a_cell_is_seen(tmp_path: Path, changes: dict[str, float]) -> None:
    with pytest.raises(SystemExit, match="cells between the two readers"):
        check(tmp_path / "ours", written(tmp_path, **changes))
