"""Text grids agree with rasterio, heights and places both.

Run in an environment that has it: ``pip install rasterio``; the project itself does not need it.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from addon.formats import ElevationGrid
from addon.formats.text.esri_ascii import read_esri_ascii
from addon.formats.text.usgs_dem import read_usgs_dem
from tests.formats.usgs_dem_file import DemFile, ProfileOfHeights

rasterio: Any = pytest.importorskip("rasterio", reason="rasterio is not installed: nothing to compare with")

REAL = Path(__file__).resolve().parents[3] / "shared" / "data" / "usgs_dem" / "SainteHelens.dem"

needs_dem = pytest.mark.skipif(not REAL.is_file(), reason="the real DEM is not beside the checkout")


def known_heights(grid: ElevationGrid, digits: int) -> dict[tuple[float, float], float]:
    """Every height that is no void, by its place in the map's own coordinates."""
    layout, georeference, samples = grid.layout, grid.georeference, grid.open()
    values = samples.elevations(range(layout.columns), range(layout.rows))
    return {
        (round(georeference.x(column), digits), round(georeference.y(row), digits)): value
        for row in range(layout.rows)
        for column in range(layout.columns)
        if not math.isnan(value := values[row * layout.columns + column])
    }


def their_heights(path: Path, digits: int) -> dict[tuple[float, float], float]:
    """The same of rasterio, whose samples lie in the middle of their cells."""
    with rasterio.open(path) as file:
        band, transform, nodata = file.read(1), file.transform, file.nodata
    return {
        (
            round(transform.c + (column + 0.5) * transform.a, digits),
            round(transform.f + (row + 0.5) * transform.e, digits),
        ): float(value)
        for row, line in enumerate(band)
        for column, value in enumerate(line)
        if value != nodata and not math.isnan(value)
    }


@needs_dem
def test_saint_helens() -> None:
    ours, theirs = known_heights(read_usgs_dem(REAL), 3), their_heights(REAL, 3)
    assert len(ours) == 148_885
    assert ours == theirs


@pytest.mark.parametrize("header_bytes", [864, 893, 918, 1024])
def test_a_quadrangle(tmp_path: Path, header_bytes: int) -> None:
    profiles = [
        ProfileOfHeights(
            500_010.0 + 30.0 * column, 4_000_020.0 + 30.0 * (column % 3), range(column, column + 200)
        )
        for column in range(5)
    ]
    corners = "".join(
        DemFile().real(number, 24)
        for number in (500_000.0, 4_000_000.0, 500_000.0, 4_006_100.0, 500_140.0, 4_006_100.0, 500_140.0, 4e6)
    )
    path = DemFile(profiles, header_bytes=header_bytes, fields={547: corners}).write(tmp_path)
    assert known_heights(read_usgs_dem(path), 3) == their_heights(path, 3)


def test_a_degree(tmp_path: Path) -> None:
    west, south = -439_200.0, 165_600.0
    profiles = [
        ProfileOfHeights(west + 3.0 * column, south, [column * row - 40 for row in range(30)])
        for column in range(20)
    ]
    corners = [west, south, west, south + 87.0, west + 57.0, south + 87.0, west + 57.0, south]
    fields = {
        157: "     0     0",
        529: "     3     2",
        547: "".join(DemFile().real(number, 24) for number in corners),
        817: DemFile().real(3.0, 12) + DemFile().real(3.0, 12) + DemFile().real(1.0, 12),
    }
    path = DemFile(profiles, fields=fields).write(tmp_path)
    assert known_heights(read_usgs_dem(path), 9) == their_heights(path, 9)


@pytest.mark.parametrize("corner", ["corner", "center"])
@pytest.mark.parametrize(
    "words", [["1", "-7", "32767", "-9999"], ["0.5", "-1.25", "1e3", "-9999"], ["100000", "2", "-9999", "7"]]
)
def test_esri_ascii(tmp_path: Path, corner: str, words: list[str]) -> None:
    path = tmp_path / "grid.asc"
    rows = [" ".join(words[(row + column) % 4] for column in range(6)) for row in range(5)]
    path.write_text(
        f"ncols 6\nnrows 5\nxll{corner} 500010\nyll{corner} 4000000\ncellsize 25\nNODATA_value -9999\n"
        + "\n".join(rows)
        + "\n"
    )
    assert known_heights(read_esri_ascii(path), 3) == their_heights(path, 3)
