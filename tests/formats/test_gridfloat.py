"""GridFloat pairs."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import read_grid
from tests.formats.raw_grids import GridFloatPair, packed
from tests.formats.reading import complaint, heights

EXPECTED = [[1.5, -2.25, 3.0], [700.125, None, 6.5]]


@pytest.mark.parametrize("chosen", ["grid.hdr", "grid.flt", "GRID.FLT"])
def test_heights_and_places_are_those_of_the_header(tmp_path: Path, chosen: str) -> None:
    GridFloatPair().write(tmp_path)
    grid = read_grid(tmp_path / chosen)
    assert heights(grid) == EXPECTED
    assert grid.decoding is None
    assert grid.format == "GridFloat"
    assert (grid.georeference.x(0), grid.georeference.y(0)) == (-119.875, 40.375)


def test_a_centre_instead_of_a_corner(tmp_path: Path) -> None:
    words = {"xllcorner": None, "yllcorner": None, "xllcenter": -119.875, "yllcenter": 40.125}
    place = read_grid(GridFloatPair(words=words).write(tmp_path)).georeference
    assert (place.x(0), place.y(0)) == (-119.875, 40.375)


@pytest.mark.parametrize(("order", "sample"), [("LSBFIRST", "<f"), ("MSBFIRST", ">f"), ("msbfirst", ">f")])
def test_byte_orders(tmp_path: Path, order: str, sample: str) -> None:
    assert (
        heights(read_grid(GridFloatPair(words={"byteorder": order}, sample=sample).write(tmp_path)))
        == EXPECTED
    )


@pytest.mark.parametrize(("sample", "told"), [("<f", "LSBFIRST is assumed"), (">f", "only MSBFIRST")])
def test_a_missing_byte_order_is_found_by_the_heights(tmp_path: Path, sample: str, told: str) -> None:
    grid = read_grid(GridFloatPair(words={"byteorder": None}, sample=sample).write(tmp_path))
    assert heights(grid) == EXPECTED
    assert told in " ".join(grid.notes)


@pytest.mark.parametrize(
    "void", ["-3.4028234663852886e+38", "-3.40282346639e+38", "-3.4028235e38", "-3.40282e+38"]
)
def test_the_largest_number_is_void_however_it_is_rounded(tmp_path: Path, void: str) -> None:
    largest = -3.4028234663852886e38
    pair = GridFloatPair([[1, largest], [2, 3]], words={"NODATA_value": void})
    assert heights(read_grid(pair.write(tmp_path))) == [[1, None], [2, 3]]


def test_a_void_is_rounded_as_the_samples_are(tmp_path: Path) -> None:
    pair = GridFloatPair([[1, -0.1], [2, 3]], words={"NODATA_value": "-0.1"})
    assert heights(read_grid(pair.write(tmp_path)))[0] == [1, None]


def test_data_longer_or_shorter_than_the_header_says(tmp_path: Path) -> None:
    header = GridFloatPair().write(tmp_path)
    data = packed(GridFloatPair().heights, "<f")
    for spoilt in (data[:-1], data + b"\r"):
        header.with_suffix(".flt").write_bytes(spoilt)
        assert f"{len(spoilt)} bytes, expected 24 bytes" in complaint(header)


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ({"cellsize": None}, "CELLSIZE"),
        ({"cellsize": "nan"}, "CELLSIZE"),
        ({"cellsize": 0}, "above 0"),
        ({"cellsize": "1e-320"}, "place of the grid"),
        ({"ncols": 1}, "at least 2"),
        ({"ncols": 10**12}, "NCOLS"),
        ({"xllcorner": None}, "XLLCORNER"),
        ({"yllcorner": 1e7, "xllcorner": 1e300}, "coordinates on a planet"),
        ({"byteorder": "VAX"}, "VAX"),
    ],
)
def test_a_header_that_cannot_be_used(tmp_path: Path, words: dict[str, object], named: str) -> None:
    assert named in complaint(GridFloatPair(words=words).write(tmp_path))
