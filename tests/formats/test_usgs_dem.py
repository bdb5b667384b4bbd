"""What a USGS DEM means."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import pytest
from proxygraph import CancelledError, Progress

from addon.formats import ElevationGrid, FormatError, Region
from addon.formats.body.datums import CLARKE_1866, GRS80, WGS84
from addon.formats.projections import KINDS, Geographic, Unknown
from addon.formats.text.usgs_dem import read_usgs_dem
from tests.formats.reading import assert_looked_through
from tests.formats.usgs_dem_file import VOID, DemFile, ProfileOfHeights

REAL = Path(__file__).resolve().parents[3] / "shared" / "data" / "usgs_dem" / "SainteHelens.dem"

needs_dem = pytest.mark.skipif(not REAL.is_file(), reason="the real DEM is not beside the checkout")


def elevation_at(grid: ElevationGrid, x: float, y: float) -> float | None:
    """The elevation at the map's own coordinates."""
    georeference = grid.georeference
    column = (x - georeference.first_x) / georeference.step_x
    row = (georeference.first_y - y) / georeference.step_y
    assert column == int(column)
    assert row == int(row)
    return grid.open().elevation(int(column), int(row))


def assert_heights(grid: ElevationGrid, file: DemFile) -> None:
    """Every height of the file is where it belongs, and nothing else is."""
    known = 0
    for profile in file.profiles:
        for number, height in enumerate(profile.heights):
            found = elevation_at(grid, profile.x, profile.y + 30.0 * number)
            is_void = height in {None, VOID, -32000}
            assert found == (None if is_void else height)
            known += not is_void
    found_range = grid.open().range()
    assert found_range is not None
    assert grid.samples - found_range.voids == known


def refusal(file: DemFile | bytes, folder: Path) -> str:
    """What is said of a file that cannot be read."""
    path = folder / "spoilt.dem"
    path.write_bytes(file if isinstance(file, bytes) else file.data())
    with pytest.raises(FormatError) as caught:
        read_usgs_dem(path)
    text = str(caught.value)
    assert text.startswith("spoilt.dem: ")
    for word in ("found", "expected"):
        assert word in text
    assert len(text) < 600
    return text


@pytest.mark.parametrize("header_bytes", [864, 893, 918, 1024])
@pytest.mark.parametrize(
    ("line", "trimmed"), [("", False), ("\n", False), ("\r\n", False), ("\n", True), ("\r\n", True)]
)
@pytest.mark.parametrize("exponent", ["D", "E", "d"])
def test_every_form_of_records(
    tmp_path: Path, header_bytes: int, line: str, trimmed: bool, exponent: str
) -> None:
    file = DemFile(header_bytes=header_bytes, line=line, trimmed=trimmed, exponent=exponent)
    grid = read_usgs_dem(file.write(tmp_path))
    assert (grid.layout.columns, grid.layout.rows) == (3, 350)
    assert grid.layout.sample == "i16"
    assert_heights(grid, file)


def test_the_grid_begins_in_the_north_west(tmp_path: Path) -> None:
    grid = read_usgs_dem(DemFile().write(tmp_path))
    assert (grid.georeference.first_x, grid.georeference.first_y) == (500_010.0, 3_999_990.0 + 349 * 30.0)
    assert (grid.georeference.step_x, grid.georeference.step_y) == (30.0, 30.0)
    assert (grid.layout.cell_width, grid.layout.cell_height) == (30.0, 30.0)
    assert grid.georeference.registration == "points"
    assert grid.title == "A QUADRANGLE, NOWHERE"
    assert grid.format == "USGS DEM"


def test_cells_of_ten_metres_and_of_fractions_of_a_metre(tmp_path: Path) -> None:
    profiles = [ProfileOfHeights(10.0 * column, 10.0 * column, [column, 12345]) for column in range(4)]
    file = DemFile(profiles, fields={817: "        10.0        10.0         0.1"})
    grid = read_usgs_dem(file.write(tmp_path))
    assert (grid.layout.columns, grid.layout.rows, grid.layout.sample) == (4, 5, "i16")
    assert elevation_at(grid, 20.0, 30.0) == pytest.approx(1234.5, rel=1e-15)


def test_heights_in_feet_are_given_in_metres(tmp_path: Path) -> None:
    grid = read_usgs_dem(DemFile(fields={535: "     1"}).write(tmp_path))
    assert elevation_at(grid, 500_010.0, 4_000_020.0) == pytest.approx(100 * 0.3048, rel=1e-15)
    assert grid.georeference.vertical_unit == "ft"
    assert elevation_at(grid, 500_070.0, 4_000_080.0) is None


@pytest.mark.parametrize("unit", [1, 2])
@pytest.mark.parametrize("scale", [1.0, 0.1])
def test_range_and_voids_are_known_from_the_look_at_every_height(
    tmp_path: Path, unit: int, scale: float
) -> None:
    fields = {535: f"{unit:6d}", 841: DemFile().real(scale, 12)}
    grid = read_usgs_dem(DemFile(fields=fields).write(tmp_path))
    assert_looked_through(grid)
    part = grid.region(Region(0, 0, 2, 2))
    assert (part.range, part.voids) == (None, None)


def test_a_local_datum_is_added(tmp_path: Path) -> None:
    profiles = [ProfileOfHeights(30.0 * column, 0.0, [1, 2, VOID], 1000.0) for column in range(2)]
    grid = read_usgs_dem(DemFile(profiles).write(tmp_path))
    assert grid.layout.sample == "i16"
    assert elevation_at(grid, 30.0, 30.0) == 1002.0
    assert elevation_at(grid, 30.0, 60.0) is None


@pytest.mark.parametrize(
    ("datums", "resolution", "sample"),
    [
        ((10.0, 20.0), "1.0", "i16"),
        ((10.0, 40_000.0), "1.0", "i32"),
        ((0.25, 0.5), "1.0", "f64"),
        ((1.0, 2.0), "0.1", "f64"),
    ],
)
def test_local_datums_that_differ_lose_nothing(
    tmp_path: Path, datums: tuple[float, float], resolution: str, sample: str
) -> None:
    profiles = [
        ProfileOfHeights(30.0 * column, 0.0, [-5, 7, VOID], datum) for column, datum in enumerate(datums)
    ]
    fields = {817: f"        30.0        30.0{resolution:>12}"}
    grid = read_usgs_dem(DemFile(profiles, fields=fields).write(tmp_path))
    assert grid.layout.sample == sample
    for column, datum in enumerate(datums):
        assert elevation_at(grid, 30.0 * column, 30.0) == 7 * float(resolution) + datum
        assert elevation_at(grid, 30.0 * column, 60.0) is None


def test_heights_beyond_sixteen_bits(tmp_path: Path) -> None:
    profiles = [ProfileOfHeights(30.0 * column, 0.0, [99_999, VOID, -32000, -9999]) for column in range(2)]
    grid = read_usgs_dem(DemFile(profiles).write(tmp_path))
    assert grid.layout.sample == "i32"
    assert [elevation_at(grid, 0.0, 30.0 * row) for row in range(4)] == [99_999.0, None, None, -9999.0]


def test_blank_heights_are_voids_and_are_told(tmp_path: Path) -> None:
    profiles = [ProfileOfHeights(0.0, 0.0, [1, None, 3]), ProfileOfHeights(30.0, 0.0, [4, 5, None])]
    for line, trimmed in (("", False), ("\n", True)):
        file = DemFile(profiles, line=line, trimmed=trimmed)
        grid = read_usgs_dem(file.write(tmp_path))
        assert_heights(grid, file)
        assert any("2 heights are blank" in note for note in grid.notes)


def test_a_degree_in_seconds_of_arc_and_west_of_greenwich(tmp_path: Path) -> None:
    profiles = [ProfileOfHeights(-439_200.0 + 3.0 * column, 165_600.0, [5, 6, 7]) for column in range(4)]
    file = DemFile(
        profiles,
        fields={157: "     0     0", 529: "     3     2", 817: "         3.0         3.0         1.0"},
    )
    grid = read_usgs_dem(file.write(tmp_path))
    georeference = grid.georeference
    assert isinstance(georeference.projection, Geographic)
    assert georeference.first_x == pytest.approx(-122.0, abs=1e-12)
    assert georeference.first_y == pytest.approx(46.0 + 6.0 / 3600.0, abs=1e-12)
    assert georeference.step_x == pytest.approx(3.0 / 3600.0, rel=1e-15)
    assert georeference.longitude_latitude(0, 0) == pytest.approx((238.0, 46.0 + 6.0 / 3600.0))
    # A second of longitude is shorter than one of latitude there.
    assert grid.layout.cell_width == pytest.approx(grid.layout.cell_height * 0.697, rel=1e-3)


@pytest.mark.parametrize(
    ("codes", "datum", "vertical"),
    [
        (" 1 1", "NAD27", "local mean sea level"),
        (" 2 4", "NAD83", "NGVD 29"),
        (" 3 3", "WGS 84", "NAVD 88"),
        ("    ", "NAD27", "mean sea level"),
        (" 9 9", "NAD27", "mean sea level"),
        ("abcd", "NAD27", "mean sea level"),
    ],
)
def test_datums(tmp_path: Path, codes: str, datum: str, vertical: str) -> None:
    grid = read_usgs_dem(DemFile(fields={889: codes}).write(tmp_path))
    assert grid.georeference.frame == f"{datum}, UTM zone 10N"
    assert grid.georeference.ellipsoid == {"NAD27": CLARKE_1866, "NAD83": GRS80, "WGS 84": WGS84}[datum]
    assert grid.georeference.vertical_reference == vertical
    assert any("NAD27 is assumed" in note for note in grid.notes) == (codes not in {" 1 1", " 2 4", " 3 3"})


@pytest.mark.skipif("transverse Mercator" not in KINDS, reason="transverse Mercator is not there yet")
def test_utm_gives_longitude_and_latitude(tmp_path: Path) -> None:
    grid = read_usgs_dem(DemFile().write(tmp_path))
    place = grid.georeference.longitude_latitude(0, 0)
    assert place is not None
    assert place == pytest.approx((360.0 - 123.0, 36.2), abs=0.2)


def test_state_plane_is_touched_without_longitude_and_latitude(tmp_path: Path) -> None:
    file = DemFile(fields={157: "     2   401", 529: "     1     1"})
    grid = read_usgs_dem(file.write(tmp_path))
    assert isinstance(grid.georeference.projection, Unknown)
    assert grid.layout.cell_width == pytest.approx(30.0 * 1200 / 3937)
    assert "zone 401" in grid.georeference.frame


def test_a_missing_last_profile_is_told(tmp_path: Path) -> None:
    file = DemFile(fields={859: "     4"})
    grid = read_usgs_dem(file.write(tmp_path))
    assert_heights(grid, file)
    assert any("1 of 4 profiles are missing" in note for note in grid.notes)


def test_a_number_of_profiles_that_is_blank_is_counted(tmp_path: Path) -> None:
    file = DemFile(fields={859: "      "})
    grid = read_usgs_dem(file.write(tmp_path))
    assert_heights(grid, file)


def test_a_file_cut_in_a_profile_is_read_as_far_as_it_is_whole(tmp_path: Path) -> None:
    file = DemFile()
    pieces = file.pieces()
    # In the middle of the 150th height of the second profile: its second record has begun.
    path = tmp_path / "cut.dem"
    path.write_bytes(b"".join(pieces[:3]) + pieces[3][: 3 * 6 + 2])
    grid = read_usgs_dem(path)
    assert elevation_at(grid, 500_040.0, 3_999_990.0 + 30.0 * 148) == 348.0
    assert grid.layout.rows == 149
    assert any("The file ends in profile 2: 149 of its 350 heights" in note for note in grid.notes)
    assert any("1 of 3 profiles are missing" in note for note in grid.notes)


@pytest.mark.parametrize("line", ["", "\n", "\r\n"])
def test_a_file_cut_at_any_record_is_read_or_refused(tmp_path: Path, line: str) -> None:
    pieces = DemFile(line=line).pieces()
    refused = []
    for count in range(len(pieces)):
        for more in (-7, -1, 0, 1, 144, 145):
            data = b"".join(pieces)[: max(0, len(b"".join(pieces[:count])) + more)]
            path = tmp_path / "cut.dem"
            path.write_bytes(data)
            try:
                grid = read_usgs_dem(path)
            except FormatError:
                refused.append(count)
            else:
                assert grid.open().range() is not None
    # With two profiles there is a surface.
    assert max(refused) == 2


def test_a_profile_that_is_left_out_is_a_hole(tmp_path: Path) -> None:
    file = DemFile([ProfileOfHeights(x, 0.0, [1, 2]) for x in (0.0, 30.0, 90.0)])
    grid = read_usgs_dem(file.write(tmp_path))
    assert grid.layout.columns == 4
    assert_heights(grid, file)
    assert elevation_at(grid, 60.0, 0.0) is None


def test_profiles_beside_the_rows_are_told(tmp_path: Path) -> None:
    file = DemFile([ProfileOfHeights(0.0, 0.0, [1, 2]), ProfileOfHeights(30.0, 9.0, [3, 4])])
    assert any("0.30 cells beside" in note for note in read_usgs_dem(file.write(tmp_path)).notes)


def test_only_a_region_is_decoded(tmp_path: Path) -> None:
    file = DemFile()
    whole = read_usgs_dem(file.write(tmp_path))
    part = whole.region(Region(1, 100, 2, 50)).region(Region(0, 10, 2, 20))
    samples, all_samples = part.open(), whole.open()
    for row in range(20):
        for column in range(2):
            assert samples.elevation(column, row) == all_samples.elevation(column + 1, row + 110)
    assert part.georeference.first_y == whole.georeference.first_y - 110 * 30.0


def test_reading_can_be_cancelled(tmp_path: Path) -> None:
    path = DemFile().write(tmp_path)
    progress = Progress()
    grid = read_usgs_dem(path, progress)
    grid.open(progress)
    assert progress.share == 1.0
    progress.cancel()
    with pytest.raises(CancelledError):
        read_usgs_dem(path, progress)
    with pytest.raises(CancelledError):
        grid.open(progress)


@needs_dem
def test_the_real_saint_helens() -> None:
    grid = read_usgs_dem(REAL)
    samples = grid.open()
    heights = samples.range()
    assert heights is not None
    assert (heights.minimum, heights.maximum) == (682.0, 2543.0)
    assert grid.samples - heights.voids == 148_885
    assert grid.layout.columns == 327
    assert grid.layout.sample == "i16"
    assert grid.title.startswith("MOUNT ST. HELENS")
    # The first profile: 22 heights, the first three of them 909, 910 and 910.
    assert [elevation_at(grid, 557_820.0, 5_121_240.0 + 30.0 * row) for row in range(3)] == [
        909.0,
        910.0,
        910.0,
    ]
    assert elevation_at(grid, 557_820.0, 5_121_240.0 + 30.0 * 22) is None
    assert elevation_at(grid, 557_820.0, 5_121_210.0) is None


@pytest.mark.parametrize(
    ("first", "text", "field", "found"),
    [
        (157, "    21", "coordinate system", "21"),
        (157, "      ", "coordinate system", "nothing"),
        (157, "    -1", "coordinate system", ""),
        (529, "     9", "ground unit", "9"),
        (529, "     3", "ground unit", "ArcSeconds"),
        (535, "     3", "elevation unit", "3"),
        (535, "   abc", "elevation unit", "abc"),
        (817, "         0.0", "DX", "0.0"),
        (817, "       -30.0", "DX", "-30.0"),
        (829, "         NaN", "DY", "NaN"),
        (829, "       1D999", "DY", "1D999"),
        (841, "         xyz", "DZ", "xyz"),
        (841, "       1D+99", "heights", "e"),
        (817, "      1D-300", "places of the profiles", "cells"),
        (817, "       1D300", "profiles", "1 columns"),
        (817, "        45.0", "DX", "column of another"),
        (829, "      1D-300", "places of the profiles", "cells"),
        (859, "    -3", "number of profiles", "-3"),
        (859, "     0", "number of profiles", "0"),
        (859, "  many", "number of profiles", "many"),
        (547, f"{'inf':>24}", "corner", "inf"),
        (739, f"{'low':>24}", "minimum", "low"),
    ],
)
def test_absurd_fields(tmp_path: Path, first: int, text: str, field: str, found: str) -> None:
    told = refusal(DemFile(fields={first: text}), tmp_path)
    assert f"spoilt.dem: {field}" in told
    assert found in told


@pytest.mark.parametrize(
    "far",
    [
        ProfileOfHeights(1e15, 0.0, [1, 2]),
        ProfileOfHeights(60.0, -1e12, [1, 2]),
        ProfileOfHeights(60.0, 30.0 * 2e6, [1, 2]),
    ],
)
def test_a_profile_far_away_takes_no_memory(tmp_path: Path, far: ProfileOfHeights) -> None:
    near = [ProfileOfHeights(30.0 * column, 0.0, [1, 2, 3]) for column in range(2)]
    assert "places of the profiles" in refusal(DemFile([*near, far]), tmp_path)


def test_coordinates_beyond_any_planet(tmp_path: Path) -> None:
    profiles = [ProfileOfHeights(9e11 + 30.0 * column, 0.0, [1, 2]) for column in range(2)]
    assert "place of the grid" in refusal(DemFile(profiles), tmp_path)
    latitudes = [ProfileOfHeights(3.0 * column, 3600.0 * 100.0, [1, 2]) for column in range(2)]
    fields = {157: "     0     0", 529: "     3     2", 817: "         3.0         3.0         1.0"}
    assert "place of the grid" in refusal(DemFile(latitudes, fields=fields), tmp_path)


def test_a_height_that_is_no_number_is_named(tmp_path: Path) -> None:
    data = DemFile().data()
    place = data.index(b"   103")
    text = refusal(data[:place] + b"  1.03" + data[place + 6 :], tmp_path)
    assert "height 4 of profile 1" in text
    assert "1.03" in text


def test_one_profile_has_no_surface(tmp_path: Path) -> None:
    assert "1 columns and 3 rows" in refusal(DemFile([ProfileOfHeights(0.0, 0.0, [1, 2, 3])]), tmp_path)


def test_a_million_profiles_told_of(tmp_path: Path) -> None:
    grid = read_usgs_dem(DemFile(fields={859: "999999"}).write(tmp_path))
    assert any("999996 of 999999 profiles are missing" in note for note in grid.notes)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"hello",
        b"<html><body>not found</body></html>" * 60,
        b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 12,
        bytes(115_200),
        b"II*\0" + bytes(4000),
        b" " * 5000,
        b"\n" * 5000,
    ],
    ids=["empty", "hello", "HTML", "PNG", "GTOPO30", "TIFF", "blanks", "lines"],
)
def test_what_is_no_dem(tmp_path: Path, content: bytes) -> None:
    refusal(content, tmp_path)


def test_an_a_record_alone(tmp_path: Path) -> None:
    assert "first profile" in refusal(DemFile().data()[:1024].ljust(3000), tmp_path)


def test_a_folder_and_a_file_that_is_not_there(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "missing.dem"):
        with pytest.raises(FormatError, match="found"):
            read_usgs_dem(path)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="everything may be read by root")
def test_a_file_without_permission(tmp_path: Path) -> None:
    path = DemFile().write(tmp_path)
    path.chmod(0)
    with pytest.raises(FormatError, match="permission"):
        read_usgs_dem(path)


def test_a_path_with_blanks_and_unicode(tmp_path: Path) -> None:
    folder = tmp_path / "höhen und tiefen \N{MOUNTAIN}"
    folder.mkdir()
    assert read_usgs_dem(DemFile().write(folder)).samples == 1050


def test_a_file_that_changed_since_it_was_read(tmp_path: Path) -> None:
    file = DemFile()
    path = file.write(tmp_path)
    grid = read_usgs_dem(path)
    replace(file, profiles=[ProfileOfHeights(30.0 * column, 0.0, [99_999] * 3) for column in range(2)]).write(
        tmp_path
    )
    with pytest.raises(FormatError):
        grid.open()
