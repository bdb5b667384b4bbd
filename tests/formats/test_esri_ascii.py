"""What an Esri ASCII grid means."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from struct import pack, unpack

import pytest
from proxygraph import CancelledError, Progress

from addon.formats import ElevationGrid, FormatError, Region
from addon.formats.projections import Geographic, Unknown
from addon.formats.text.esri_ascii import read_esri_ascii
from tests.formats.reading import assert_looked_through

HEADER = {
    "ncols": "3",
    "nrows": "2",
    "xllcorner": "500000",
    "yllcorner": "4000000",
    "cellsize": "30",
    "NODATA_value": "-9999",
}
HEIGHTS = ["1 2 3", "4 -9999 -6"]


def text(
    changes: dict[str, str | None] | None = None, heights: list[str] | None = None, line: str = "\n"
) -> str:
    """A grid; a header line that is changed to ``None`` is left out."""
    header = {**HEADER, **(changes or {})}
    lines = [f"{key} {value}" for key, value in header.items() if value is not None]
    return line.join([*lines, *(HEIGHTS if heights is None else heights), ""])


def read(folder: Path, content: str | bytes, name: str = "grid.asc") -> ElevationGrid:
    """Write and read a grid."""
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_esri_ascii(path)


def elevations(grid: ElevationGrid) -> list[float | None]:
    """Every sample, in the order of the file."""
    samples = grid.open()
    return [
        samples.elevation(column, row)
        for row in range(grid.layout.rows)
        for column in range(grid.layout.columns)
    ]


def refusal(folder: Path, content: str | bytes) -> str:
    """What is said of a file that cannot be read."""
    with pytest.raises(FormatError) as caught:
        read(folder, content)
    told = str(caught.value)
    assert told.startswith("grid.asc: ")
    for word in ("found", "expected"):
        assert word in told
    assert len(told) < 600
    return told


@pytest.mark.parametrize("line", ["\n", "\r\n", "\r", "\n\n", " \t\n"])
def test_line_ends_of_every_kind(tmp_path: Path, line: str) -> None:
    grid = read(tmp_path, text(line=line))
    assert elevations(grid) == [1.0, 2.0, 3.0, 4.0, None, -6.0]
    assert (grid.layout.columns, grid.layout.rows, grid.layout.sample) == (3, 2, "i16")


def test_keywords_in_any_case_and_order(tmp_path: Path) -> None:
    keys = reversed([f"{key.swapcase()} {value}" for key, value in HEADER.items()])
    assert elevations(read(tmp_path, "\n".join([*keys, *HEIGHTS]))) == [1.0, 2.0, 3.0, 4.0, None, -6.0]


@pytest.mark.parametrize(
    "heights", [["1 2 3 4 -9999 -6"], ["1", "2", "3", "4", "-9999", "-6"], ["1 2", "3 4 -9999", "-6"]]
)
def test_rows_may_be_broken_anywhere(tmp_path: Path, heights: list[str]) -> None:
    assert elevations(read(tmp_path, text(heights=heights))) == [1.0, 2.0, 3.0, 4.0, None, -6.0]


def test_a_corner_is_half_a_cell_beyond_the_first_sample(tmp_path: Path) -> None:
    georeference = read(tmp_path, text()).georeference
    assert (georeference.first_x, georeference.first_y) == (500_015.0, 4_000_045.0)
    assert (georeference.step_x, georeference.step_y) == (30.0, 30.0)
    assert georeference.registration == "cells"


def test_a_centre_is_the_first_sample_itself(tmp_path: Path) -> None:
    changes = {"xllcorner": None, "yllcorner": None, "XLLCENTER": "500000", "yllcenter": "4000000"}
    georeference = read(tmp_path, text(changes)).georeference
    assert (georeference.first_x, georeference.first_y) == (500_000.0, 4_000_030.0)


def test_a_centre_in_x_alone(tmp_path: Path) -> None:
    georeference = read(tmp_path, text({"xllcorner": None, "xllcenter": "500000"})).georeference
    assert (georeference.first_x, georeference.first_y) == (500_000.0, 4_000_045.0)


def test_cells_that_are_not_square(tmp_path: Path) -> None:
    grid = read(tmp_path, text({"cellsize": None, "dx": "10", "DY": "20"}))
    assert (grid.layout.cell_width, grid.layout.cell_height) == (10.0, 20.0)
    assert grid.georeference.first_y == 4_000_030.0


def test_nodata_is_minus_9999_where_it_is_left_out(tmp_path: Path) -> None:
    grid = read(tmp_path, text({"NODATA_value": None}))
    assert elevations(grid)[4] is None


@pytest.mark.parametrize(
    "nodata", ["nan", "NaN", "-nan", "-3.4028235e+38", "1e39", "-32768", "40000", "0.5", "inf"]
)
def test_void_values_of_every_kind(tmp_path: Path, nodata: str) -> None:
    for others in ("1 2", "1.5 2", "1.1 2", "100000 2", "-32767 2", "-32768.5 32767"):
        first, second = (float(word) for word in others.split())
        grid = read(tmp_path, text({"ncols": "2", "NODATA_value": nodata}, [f"{others} {nodata} 7"]))
        assert elevations(grid) == [first, second, None, 7.0]


def test_nan_is_a_void_whatever_the_header_says(tmp_path: Path) -> None:
    assert elevations(read(tmp_path, text(heights=["1 nan 3 4 5 -NaN"]))) == [1.0, None, 3.0, 4.0, 5.0, None]


def test_the_largest_single_as_written_by_two_programs(tmp_path: Path) -> None:
    grid = read(tmp_path, text({"NODATA_value": "-3.4028234663852886e+38"}, ["1 2 3 4 -3.40282347e+38 -6"]))
    assert elevations(grid)[4] is None
    assert grid.layout.sample == "i16"


def test_a_grid_of_voids(tmp_path: Path) -> None:
    assert elevations(read(tmp_path, text(heights=["-9999 " * 6]))) == [None] * 6


@pytest.mark.parametrize(
    ("heights", "sample"),
    [
        ("0 1 2 3 4 32767", "i16"),
        ("0 1 2 3 4.0 5e3", "i16"),
        ("-32767 1 2 3 4 5", "i16"),
        ("-32768 1 2 3 4 5", "i32"),
        ("0 1 2 3 4 32768", "i32"),
        ("2147483647 1 2 3 4 5", "i32"),
        ("2147483648 1 2 3 4 5", "f32"),
        ("0.5 1 2 3 4 -1e3", "f32"),
        ("16777217.5 1 2 3 4 5", "f64"),
        ("0.1 1 2 3 4 5", "f64"),
        ("123.456 1 2 3 4 5", "f64"),
        ("9007199254740991 1 2 3 4 5", "f64"),
        ("0.1234567890123456789 1e-7 +2 .5 5. 1E+2", "f64"),
    ],
)
def test_the_smallest_type_that_loses_nothing(tmp_path: Path, heights: str, sample: str) -> None:
    grid = read(tmp_path, text(heights=[heights]))
    assert grid.layout.sample == sample
    assert elevations(grid) == [float(word) for word in heights.split()]


def test_single_precision_is_exact_where_it_is_taken(tmp_path: Path) -> None:
    words = "0.25 -1.5 1048576.125 3.0517578125e-05 0 7"
    grid = read(tmp_path, text(heights=[words]))
    assert grid.layout.sample == "f32"
    for word, found in zip(words.split(), elevations(grid), strict=True):
        assert found == unpack("f", pack("f", float(word)))[0] == float(word)


def test_degrees_are_assumed_where_they_may_be(tmp_path: Path) -> None:
    changes: dict[str, str | None] = {"xllcorner": "-122", "yllcorner": "46", "cellsize": "0.01"}
    grid = read(tmp_path, text(changes))
    assert isinstance(grid.georeference.projection, Geographic)
    assert grid.georeference.body == "Earth"
    assert any("WGS 84 are assumed" in note for note in grid.notes)
    assert grid.layout.cell_height == pytest.approx(1111.6, rel=1e-3)
    assert grid.layout.cell_width == pytest.approx(774.0, rel=1e-2)


def test_metres_of_an_unknown_map_are_touched(tmp_path: Path) -> None:
    grid = read(tmp_path, text())
    assert isinstance(grid.georeference.projection, Unknown)
    assert any("unknown map" in note for note in grid.notes)


@pytest.mark.parametrize("name", ["grid.prj", "GRID.PRJ"])
def test_a_prj_file_beside_says_where(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text(
        'GEOGCS["Mars 2000",DATUM["D",SPHEROID["Mars",3396190,169.894447]],'
        'PRIMEM["P",0],UNIT["Degree",0.0174532925199433]]'
    )
    grid = read(tmp_path, text({"xllcorner": "0", "yllcorner": "-1", "cellsize": "1"}))
    assert grid.georeference.body == "Mars"
    assert grid.georeference.ellipsoid.semi_major == 3_396_190.0
    assert grid.georeference.frame == "Mars 2000"
    assert grid.notes == ()


def test_a_prj_file_that_is_not_understood_is_told(tmp_path: Path) -> None:
    (tmp_path / "grid.prj").write_text("<html>")
    assert any("grid.prj is not understood" in note for note in read(tmp_path, text()).notes)


@pytest.mark.parametrize(
    "heights",
    [HEIGHTS, ["1.5 2 nan", "-7.25 1e4 5"], ["-9999 " * 6], ["1 2 3", "4 5 6"], ["0.1 0.2 0.3 -4.1 5 6"]],
)
@pytest.mark.parametrize("unit", ["METERS", "FEET"])
def test_range_and_voids_are_known_from_the_look_at_every_height(
    tmp_path: Path, heights: list[str], unit: str
) -> None:
    (tmp_path / "grid.prj").write_text(f"Projection UTM\nZone 10\nDatum NAD27\nZunits {unit}\nUnits METERS\n")
    grid = read(tmp_path, text(heights=heights))
    assert_looked_through(grid)
    part = grid.region(Region(0, 0, 2, 2))
    assert (part.range, part.voids) == (None, None)


def test_units_of_heights_from_the_prj_file(tmp_path: Path) -> None:
    (tmp_path / "grid.prj").write_text("Projection UTM\nZone 10\nDatum NAD27\nZunits FEET\nUnits METERS\n")
    grid = read(tmp_path, text())
    assert elevations(grid)[0] == pytest.approx(0.3048)
    assert grid.georeference.frame == "NAD27, UTM zone 10N"


def test_a_whole_planet_wraps(tmp_path: Path) -> None:
    changes: dict[str, str | None] = {
        "ncols": "40",
        "nrows": "2",
        "xllcorner": "0",
        "yllcorner": "-9",
        "cellsize": "9",
    }
    rows = [" ".join(str(100 * row + column) for column in range(40)) for row in range(2)]
    grid = read(tmp_path, text(changes, rows))
    assert grid.layout.wraps
    assert elevations(grid.region(Region(37, 0, 3, 2))) == [37.0, 38.0, 39.0, 137.0, 138.0, 139.0]
    assert elevations(grid.region(Region(38, 0, 4, 2))) == [38.0, 39.0, 0.0, 1.0, 138.0, 139.0, 100.0, 101.0]


def test_only_a_region_is_decoded(tmp_path: Path) -> None:
    rows = [" ".join(str(100 * row + column) for column in range(20)) for row in range(15)]
    grid = read(tmp_path, text({"ncols": "20", "nrows": "15"}, rows))
    part = grid.region(Region(5, 4, 3, 2))
    assert elevations(part) == [405.0, 406.0, 407.0, 505.0, 506.0, 507.0]
    assert part.georeference.first_x == 500_015.0 + 150.0
    eastern = grid.region(Region(18, 13, 2, 2))
    assert elevations(eastern) == [1318.0, 1319.0, 1418.0, 1419.0]


def test_a_file_of_many_pieces(tmp_path: Path) -> None:
    rows, columns = 300, 400
    heights = [
        [(row * 7919 + column * 104_729) % 4001 / 8.0 for column in range(columns)] for row in range(rows)
    ]
    words = ["   ".join(f"{height:.7f}" for height in row) for row in heights]
    grid = read(tmp_path, text({"ncols": str(columns), "nrows": str(rows)}, words))
    assert (tmp_path / "grid.asc").stat().st_size > 1_400_000
    assert grid.layout.sample == "f32"
    assert elevations(grid) == [height for row in heights for height in row]


def test_blanks_longer_than_any_piece(tmp_path: Path) -> None:
    content = text(heights=["1 2" + " " * 700_000 + "3", "\n" * 300_000 + "4 5 6"])
    assert elevations(read(tmp_path, content)) == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


def test_a_number_with_many_zeros(tmp_path: Path) -> None:
    assert elevations(read(tmp_path, text(heights=["0" * 300 + "7 1." + "0" * 400 + " 3 4 5 6"])))[:2] == [
        7.0,
        1.0,
    ]
    assert "row 1, column 1" in refusal(tmp_path, text(heights=["0" * 2000 + "7 2 3 4 5 6"]))


def test_reading_can_be_cancelled(tmp_path: Path) -> None:
    grid = read(tmp_path, text())
    progress = Progress()
    progress.cancel()
    with pytest.raises(CancelledError):
        read_esri_ascii(grid.path, progress)
    with pytest.raises(CancelledError):
        grid.open(progress)


def test_a_byte_order_mark_is_stepped_over(tmp_path: Path) -> None:
    assert elevations(read(tmp_path, b"\xef\xbb\xbf" + text().encode()))[0] == 1.0


@pytest.mark.parametrize(
    ("changes", "field", "found"),
    [
        ({"ncols": None}, "NCOLS", "nothing"),
        ({"nrows": None}, "NROWS", "nothing"),
        ({"xllcorner": None}, "XLLCORNER or XLLCENTER", "nothing"),
        ({"yllcorner": None}, "YLLCORNER or YLLCENTER", "nothing"),
        ({"cellsize": None}, "CELLSIZE", "nothing"),
        ({"cellsize": None, "dx": "3"}, "CELLSIZE", "nothing"),
        ({"ncols": "0"}, "NCOLS", "0"),
        ({"ncols": "1"}, "NCOLS", "1"),
        ({"ncols": "-3"}, "NCOLS", "-3"),
        ({"ncols": "2.5"}, "NCOLS", "2.5"),
        ({"ncols": "nan"}, "NCOLS", "NaN"),
        ({"ncols": "1e300"}, "NCOLS", "e"),
        ({"nrows": "1000000000000"}, "NROWS", "1000000000000"),
        ({"ncols": "1000000", "nrows": "1000000"}, "NCOLS and NROWS", "1000000 x 1000000"),
        ({"cellsize": "0"}, "CELLSIZE", "0"),
        ({"cellsize": "-30"}, "CELLSIZE", "-30"),
        ({"cellsize": "nan"}, "CELLSIZE", "NaN"),
        ({"cellsize": "inf"}, "CELLSIZE", "inf"),
        ({"cellsize": None, "dx": "3", "dy": "-1"}, "DY", "-1"),
        ({"dx": "3"}, "CELLSIZE", "3"),
        ({"xllcorner": "nan"}, "XLLCORNER", "NaN"),
        ({"xllcenter": "3"}, "XLLCORNER", "XLLCENTER as well"),
        ({"yllcenter": "3"}, "YLLCORNER", "YLLCENTER as well"),
        ({"NCOLS": "4"}, "NCOLS", "3 and 4"),
        ({"NODATA": "7"}, "NODATA_VALUE", "7 as NODATA"),
        ({"cellsize": "30,5"}, "CELLSIZE", "30,5"),
        ({"cellsize": "thirty"}, "CELLSIZE", "thirty"),
        ({"byteorder": "LSBFIRST"}, "header", "byteorder"),
        ({"xllcorner": "1e300"}, "place of the grid", "1e+300"),
        ({"cellsize": "1e-300"}, "place of the grid", "1e-300"),
        ({"cellsize": "1e300"}, "place of the grid", "1e+300"),
    ],
)
def test_absurd_headers(tmp_path: Path, changes: dict[str, str | None], field: str, found: str) -> None:
    told = refusal(tmp_path, text(changes))
    assert f"grid.asc: {field}: found" in told
    assert found in told


@pytest.mark.parametrize(
    ("heights", "field", "found", "expected"),
    [
        (["1 2 3", "4 5"], "number of heights", "5", "6 for NCOLS and NROWS"),
        ([], "number of heights", "0", "6"),
        (["1 2 3", "4 5 6 7"], "number of heights", "7", "6"),
        (["1 2 3", "4 5,5 6"], "height in row 2, column 2", "5,5", "a decimal point, not a comma"),
        (["1 2 3", "4 five 6"], "height in row 2, column 2", "five", "a number"),
        (["1 2 0x3", "4 5 6"], "height in row 1, column 3", "0x3", "a number"),
        (["1 2 3", "4 5 --6"], "height in row 2, column 3", "--6", "a number"),
        (["1 2 3", "4 5 1e"], "height in row 2, column 3", "1e", "a number"),
        (["1 2 3", "4 5 \0"], "number of heights", "5", "6"),
    ],
)
def test_heights_that_are_none(
    tmp_path: Path, heights: list[str], field: str, found: str, expected: str
) -> None:
    # The header alone must not give the size away.
    told = refusal(tmp_path, text(heights=heights) + " " * 20)
    assert f"grid.asc: {field}: found" in told
    assert found in told
    assert expected in told


def test_a_file_cut_anywhere_is_refused_in_words(tmp_path: Path) -> None:
    whole = text().encode()
    end = len(whole.rstrip()) - 1  # without the last digit, "-" is no number
    for length in range(end + 1):
        assert refusal(tmp_path, whole[:length])


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\n",
        b"<html><body>not found</body></html>" * 40,
        b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 12,
        bytes(5000),
        b"A" * 100_000,
        b"ncols",
        b"ncols 3 nrows",
    ],
    ids=["empty", "line", "HTML", "PNG", "zeros", "letters", "keyword", "half"],
)
def test_what_is_no_grid(tmp_path: Path, content: bytes) -> None:
    refusal(tmp_path, content)


def test_a_folder_and_a_file_that_is_not_there(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "missing.asc"):
        with pytest.raises(FormatError, match="found"):
            read_esri_ascii(path)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="everything may be read by root")
def test_a_file_without_permission(tmp_path: Path) -> None:
    grid = read(tmp_path, text())
    grid.path.chmod(0)
    with pytest.raises(FormatError, match="permission"):
        read_esri_ascii(grid.path)


def test_a_path_with_blanks_and_unicode(tmp_path: Path) -> None:
    folder = tmp_path / "höhen und tiefen \N{MOUNTAIN}"
    folder.mkdir()
    assert read(folder, text()).samples == 6


def test_a_file_that_changed_since_it_was_read(tmp_path: Path) -> None:
    grid = read(tmp_path, text())
    grid.path.write_text(text(heights=["1.5 2 3 4 5 6"]))
    with pytest.raises(FormatError, match=r"1\.5"):
        grid.open()
    grid.path.write_text(text({"nrows": "3"}, ["1 2 3 4 5 6 7 8 9"]))
    assert elevations(replace(grid))[:3] == [1.0, 2.0, 3.0]
    grid.path.write_text(text({"ncols": "2"}, ["1 2 3 4"]))
    with pytest.raises(FormatError, match="region"):
        grid.open()
