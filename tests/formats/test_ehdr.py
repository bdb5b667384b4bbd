"""EHdr rasters: GTOPO30, SRTM30, GLOBE, BIL, BIP, BSQ."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import Region, read_grid
from tests.formats.megdr_pair import rough
from tests.formats.raw_grids import EhdrPair, packed
from tests.formats.reading import SHARED, complaint, heights, needs, needs_raw_decoder


def test_heights_and_places_are_those_of_the_header(tmp_path: Path) -> None:
    pair = EhdrPair()
    grid = read_grid(pair.write(tmp_path))
    assert heights(grid) == pair.heights
    place = grid.georeference
    assert (place.x(0), place.y(0)) == (10.25, 49.75)
    assert (place.x(5), place.y(3)) == (12.75, 48.25)
    assert place.body == "Earth"
    assert place.registration == "cells"
    assert grid.decoding is None


@pytest.mark.parametrize("chosen", ["grid.HDR", "grid.DEM", "grid.hdr", "grid.dem"])
def test_either_file_may_be_chosen(tmp_path: Path, chosen: str) -> None:
    EhdrPair().write(tmp_path)
    assert read_grid(tmp_path / chosen).samples == 24


@pytest.mark.parametrize("companion", ["grid.PRJ", "grid.STX", "grid.GIF"])
def test_a_file_that_comes_along_leads_to_the_grid(tmp_path: Path, companion: str) -> None:
    EhdrPair().write(tmp_path)
    (tmp_path / companion).write_bytes(b"Projection GEOGRAPHIC\n")
    assert read_grid(tmp_path / companion).data_path.name == "grid.DEM"


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_line_ends(tmp_path: Path, line_end: str) -> None:
    assert read_grid(EhdrPair(line_end=line_end).write(tmp_path)).samples == 24


def test_keywords_in_lower_case(tmp_path: Path) -> None:
    header = EhdrPair().write(tmp_path)
    header.write_text(header.read_text().lower())
    assert read_grid(header).samples == 24


def test_the_sea_is_a_hole(tmp_path: Path) -> None:
    grid = read_grid(EhdrPair([[1, -9999], [2, 3]]).write(tmp_path))
    assert heights(grid) == [[1, None], [2, 3]]


def test_a_lying_stx_is_not_believed(tmp_path: Path) -> None:
    pair = EhdrPair()
    header = pair.write(tmp_path)
    (tmp_path / "grid.STX").write_text("1 0 4535 100 100\n")
    found = read_grid(header).open().range()
    assert found is not None
    assert found.maximum == max(max(row) for row in pair.heights)


@pytest.mark.parametrize(
    ("order", "kind", "bits", "sample"),
    [
        ("M", "SIGNEDINT", 16, ">h"),
        ("I", "SIGNEDINT", 16, "<h"),
        ("I", None, 16, "<h"),
        ("M", "UNSIGNEDINT", 16, ">H"),
        ("I", "SIGNEDINT", 32, "<i"),
        ("M", "FLOAT", 32, ">f"),
        ("I", "FLOAT", 32, "<f"),
        ("I", "FLOAT", 64, "<d"),
    ],
)
def test_sample_types_are_mapped(tmp_path: Path, order: str, kind: str, bits: int, sample: str) -> None:
    rows = [[40_000 if sample[-1] == "H" else -2000, 1], [2, 3]]
    pair = EhdrPair(rows, words={"BYTEORDER": order, "PIXELTYPE": kind, "NBITS": bits}, sample=sample)
    grid = read_grid(pair.write(tmp_path))
    assert grid.decoding is None
    assert heights(grid) == rows


@pytest.mark.parametrize(
    ("kind", "bits", "sample"), [(None, 8, ">B"), ("SIGNEDINT", 8, ">b"), ("UNSIGNEDINT", 32, ">I")]
)
@needs_raw_decoder
def test_other_sample_types_are_decoded(tmp_path: Path, kind: str, bits: int, sample: str) -> None:
    pair = EhdrPair([[7, 1], [2, 3]], words={"PIXELTYPE": kind, "NBITS": bits}, sample=sample)
    assert heights(read_grid(pair.write(tmp_path))) == [[7, 1], [2, 3]]


def test_bytes_around_rows_are_stepped_over(tmp_path: Path) -> None:
    rows = rough(3, 2)
    data = b"skip" + b"".join(packed([row]) + b"..." for row in rows)
    words = {"SKIPBYTES": 4, "TOTALROWBYTES": 7, "BANDROWBYTES": 4}
    grid = read_grid(EhdrPair(rows, words=words, data=data).write(tmp_path))
    assert heights(grid) == rows


@pytest.mark.parametrize("layout", ["BIL", "BSQ"])
def test_the_first_of_several_bands_is_mapped(tmp_path: Path, layout: str) -> None:
    first, second = rough(2, 3), [[9, 9, 9], [9, 9, 9]]
    rows = [first[0], second[0], first[1], second[1]] if layout == "BIL" else [*first, *second]
    words = {"NBANDS": 2, "LAYOUT": layout, "TOTALROWBYTES": None}
    grid = read_grid(EhdrPair(first, words=words, data=packed(rows)).write(tmp_path))
    assert heights(grid) == first
    assert "2 bands" in " ".join(grid.notes)


@needs_raw_decoder
def test_the_first_of_bands_by_pixel_is_decoded(tmp_path: Path) -> None:
    first = rough(2, 3)
    data = packed([[value for height in row for value in (height, 9)] for row in first])
    words = {"NBANDS": 2, "LAYOUT": "BIP", "TOTALROWBYTES": None, "BANDROWBYTES": None}
    grid = read_grid(EhdrPair(first, words=words, data=data).write(tmp_path))
    assert heights(grid) == first


@pytest.mark.parametrize(
    ("words", "y"),
    [
        ({"XLLCORNER": 10.0, "YLLCORNER": 48.0}, 49.75),
        ({"XLLCENTER": 10.25, "YLLCENTER": 48.25}, 49.75),
    ],
)
def test_corners_of_the_lower_left(tmp_path: Path, words: dict[str, float], y: float) -> None:
    pair = EhdrPair(
        words={"ULXMAP": None, "ULYMAP": None, "XDIM": None, "YDIM": None, "CELLSIZE": 0.5, **words}
    )
    place = read_grid(pair.write(tmp_path)).georeference
    assert (place.x(0), place.y(0)) == (10.25, y)


@pytest.mark.parametrize("suffix", [".bil", ".BIP", ".bsq", ".raw", ".odd", ""])
def test_other_endings_of_the_data(tmp_path: Path, suffix: str) -> None:
    pair = EhdrPair(suffixes=(".hdr", suffix))
    header = pair.write(tmp_path)
    assert heights(read_grid(tmp_path / f"grid{suffix}")) == pair.heights
    if suffix != ".odd":
        assert read_grid(header).samples == 24


def test_metres_of_an_unknown_map(tmp_path: Path) -> None:
    words = {"ULXMAP": 500_000, "ULYMAP": 4_600_000, "XDIM": 30, "YDIM": 30}
    grid = read_grid(EhdrPair(words=words).write(tmp_path))
    assert (grid.layout.cell_width, grid.layout.cell_height) == (30.0, 30.0)
    assert grid.georeference.longitude_latitude(0, 0) is None
    assert "no .prj file" in " ".join(grid.notes)


def test_a_whole_planet_wraps(tmp_path: Path) -> None:
    pair = EhdrPair(rough(3, 40), words={"ULXMAP": -175.5, "XDIM": 9, "ULYMAP": 30, "YDIM": 30})
    assert read_grid(pair.write(tmp_path)).layout.wraps


@pytest.mark.parametrize("change", [-1, 1, 37])
def test_a_size_that_is_wrong_is_refused(tmp_path: Path, change: int) -> None:
    data = packed(rough(4, 6))
    pair = EhdrPair(data=data[:change] if change < 0 else data + bytes(change))
    text = complaint(pair.write(tmp_path))
    for word in ("grid.DEM: length", f"{48 + change} bytes", "48 bytes"):
        assert word in text


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ({"NROWS": None}, ["grid.HDR"]),
        ({"NROWS": 0}, ["NROWS", "0", "at least 2"]),
        ({"NROWS": 1}, ["NROWS", "1", "at least 2"]),
        ({"NROWS": -4}, ["NROWS", "-4", "whole"]),
        ({"NROWS": "many"}, ["NROWS", "MANY", "a number"]),
        ({"NROWS": 10**12}, ["NROWS", "1,000,000,000,000"]),
        ({"NCOLS": "1e300"}, ["NCOLS", "1e+300"]),
        ({"NCOLS": "nan"}, ["NCOLS", "NAN", "a number"]),
        ({"NCOLS": 7}, ["bytes of a row", "12", "14"]),
        ({"NBITS": 12}, ["NBITS", "12", "16 SIGNEDINT"]),
        ({"BYTEORDER": "X"}, ["BYTEORDER", "X", "M"]),
        ({"BYTEORDER": None}, ["BYTEORDER", "nothing"]),
        ({"LAYOUT": "TIF"}, ["LAYOUT", "TIF", "BIL"]),
        ({"NBANDS": 0}, ["NBANDS", "0"]),
        ({"XDIM": 0}, ["XDIM", "0", "above 0"]),
        ({"YDIM": -1}, ["YDIM", "-1", "above 0"]),
        ({"XDIM": None}, ["XDIM", "nothing"]),
        ({"ULXMAP": None}, ["ULXMAP", "XLLCORNER"]),
        ({"ULXMAP": "1e300"}, ["1e+300", "coordinates on a planet"]),
        ({"ULYMAP": "inf"}, ["ULYMAP", "INF", "a number"]),
        ({"NODATA": "none at all", "NBITS": 16}, []),
        ({"SKIPBYTES": 10**15}, ["length", "48 bytes"]),
        ({"SKIPBYTES": "1e300"}, ["SKIPBYTES"]),
        ({"TOTALROWBYTES": 3}, ["bytes of a row", "3", "12"]),
    ],
)
def test_a_header_that_cannot_be_used(tmp_path: Path, words: dict[str, object], named: list[str]) -> None:
    header = EhdrPair(words=words).write(tmp_path)
    if not named:
        assert read_grid(header).layout.void is None
        return
    text = complaint(header)
    for word in named:
        assert word in text
    assert len(text) < 500


def test_a_header_without_data(tmp_path: Path) -> None:
    header = EhdrPair().write(tmp_path)
    (tmp_path / "grid.DEM").unlink()
    text = complaint(header)
    assert "grid.HDR: data file" in text
    assert "grid.dem" in text


@pytest.mark.parametrize("length", range(0, 250, 7))
def test_a_header_cut_anywhere_is_refused_or_read(tmp_path: Path, length: int) -> None:
    header = EhdrPair().write(tmp_path)
    header.write_bytes(header.read_bytes()[:length])
    assert "grid" in complaint(header)


@needs("gtopo30/W002N52.DEM")
def test_the_real_tile() -> None:
    grid = read_grid(SHARED / "gtopo30" / "W002N52.DEM")
    found = grid.open().range()
    assert found is not None
    assert (found.minimum, found.maximum, found.voids) == (1.0, 613.0, 821)
    assert grid.georeference.x(-0.5) == pytest.approx(-2.0)
    assert grid.georeference.y(-0.5) == pytest.approx(54.0)
    assert grid.notes == ()


@needs_raw_decoder
def test_regions_of_decoded_samples(tmp_path: Path) -> None:
    rows = [[row * 10 + column for column in range(6)] for row in range(4)]
    grid = read_grid(EhdrPair(rows, words={"PIXELTYPE": None}, sample=">B").write(tmp_path))
    part = grid.region(Region(2, 1, 3, 2))
    assert heights(part) == [row[2:5] for row in rows[1:3]]
    assert part.georeference.x(0) == grid.georeference.x(2)
