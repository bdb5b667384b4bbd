"""SRTM squares."""

from __future__ import annotations

from pathlib import Path
from struct import pack

import pytest

from addon.formats import HgtPosition, read_grid
from addon.formats.raw.hgt import position_of
from tests.formats.reading import SHARED, complaint, needs


def square(path: Path, rows: int = 1201, columns: int = 1201) -> Path:
    """A square of height 0 whose first samples are 7, void and -3."""
    with path.open("wb") as file:
        file.write(pack(">3h", 7, -32768, -3))
        file.truncate(2 * rows * columns)
    return path


@pytest.mark.parametrize(("rows", "columns"), [(1201, 1201), (3601, 3601), (3601, 1801), (1201, 601)])
def test_the_size_tells_rows_and_columns(tmp_path: Path, rows: int, columns: int) -> None:
    grid = read_grid(square(tmp_path / "S34W071.hgt", rows, columns))
    assert (grid.layout.rows, grid.layout.columns) == (rows, columns)
    samples = grid.open()
    assert [samples.elevation(column, 0) for column in range(3)] == [7, None, -3]
    place = grid.georeference
    assert (place.x(0), place.y(0)) == (-71.0, -33.0)
    assert place.x(columns - 1) == pytest.approx(-70.0)
    assert place.y(rows - 1) == pytest.approx(-34.0)
    assert place.registration == "points"
    assert grid.notes == ()


@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("N51W001.hgt", (51.0, -1.0)),
        ("n00e006.HGT", (0.0, 6.0)),
        ("S01E179.SRTMGL1.hgt", (-1.0, 179.0)),
        ("srtm_N10_E020.hgt", None),
        ("copy of N10E020.hgt", (10.0, 20.0)),
        ("N91E020.hgt", None),
        ("N10E999.hgt", None),
        ("london.hgt", None),
        ("ASTGTMV003_N10E020_dem.hgt", None),
    ],
)
def test_names_that_tell_the_place(name: str, place: tuple[float, float] | None) -> None:
    found = position_of(name)
    if name.startswith(("srtm", "ASTGTM")):  # an underscore before the letter is as good as a space
        assert found == HgtPosition(10.0, 20.0)
    else:
        assert (found and (found.latitude, found.longitude)) == place


def test_a_renamed_file_is_imported_and_says_how_to_give_its_place(tmp_path: Path) -> None:
    grid = read_grid(square(tmp_path / "london.hgt"))
    assert (grid.georeference.x(0), grid.georeference.y(0)) == (0.0, 1.0)
    for word in ("0 N 0 E", "N51W001.hgt", "position"):
        assert word in " ".join(grid.notes)


def test_a_place_may_be_given(tmp_path: Path) -> None:
    grid = read_grid(square(tmp_path / "london.hgt"), HgtPosition(51.0, -1.0))
    assert (grid.georeference.x(0), grid.georeference.y(0)) == (-1.0, 52.0)
    assert grid.notes == ()
    with pytest.raises(ValueError, match="position"):
        read_grid(tmp_path / "london.hgt", HgtPosition(float("nan"), 0.0))


def test_another_ending_is_no_hindrance(tmp_path: Path) -> None:
    assert read_grid(square(tmp_path / "N51W001.bin")).format == "SRTM (hgt)"


@pytest.mark.parametrize("size", [2 * 1201 * 1201 - 1, 2 * 1201 * 1201 + 1, 1201 * 1201, 10])
def test_other_sizes_are_refused_with_the_known_ones(tmp_path: Path, size: int) -> None:
    path = tmp_path / "N51W001.hgt"
    path.write_bytes(b"\0\1" * 5)
    with path.open("r+b") as file:
        file.truncate(size)
    text = complaint(path)
    for word in (f"{size:,} bytes", "2,884,802 (1201 x 1201)", "25,934,402 (3601 x 3601)"):
        assert word in text


@pytest.mark.parametrize(
    ("content", "word"),
    [
        (b"<!DOCTYPE html><html>401</html>", "an HTML page"),
        (b"PK\x03\x04rest", "a zip archive"),
        (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
        (b"", "no bytes"),
    ],
)
def test_what_is_no_square_is_named(tmp_path: Path, content: bytes, word: str) -> None:
    path = tmp_path / "N51W001.hgt"
    path.write_bytes(content)
    assert word in complaint(path)


def test_a_square_may_begin_with_the_bytes_of_a_picture(tmp_path: Path) -> None:
    """-40 m and -32 m below the sea are how a JPEG begins."""
    path = square(tmp_path / "N31E035.hgt")
    with path.open("r+b") as file:
        file.write(b"\xff\xd8\xff\xe0")
    assert read_grid(path).open().elevation(0, 0) == -40


@needs("srtm/N51W001.hgt")
def test_the_real_square() -> None:
    grid = read_grid(SHARED / "srtm" / "N51W001.hgt")
    found = grid.open().range()
    assert found is not None
    assert (found.minimum, found.maximum, found.voids) == (-30.0, 296.0, 28)
    assert grid.georeference.longitude_latitude(1200, 1200) == (0.0, 51.0)
