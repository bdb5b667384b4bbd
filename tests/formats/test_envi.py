"""ENVI rasters."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from addon.formats import read_grid
from tests.formats.raw_grids import EnviPair, packed
from tests.formats.reading import complaint, heights, needs_raw_decoder

EXPECTED = [[1.5, -2.25, 3.0], [700.125, None, 6.5]]


@pytest.mark.parametrize(
    "names",
    [("grid.hdr", "grid"), ("grid.hdr", "grid.dat"), ("grid.dat.hdr", "grid.dat"), ("GRID.HDR", "grid.IMG")],
)
def test_header_and_data_find_each_other(tmp_path: Path, names: tuple[str, str]) -> None:
    EnviPair(names=names).write(tmp_path)
    for chosen in names:
        grid = read_grid(tmp_path / chosen)
        assert heights(grid) == EXPECTED
        assert grid.format == "ENVI"
        assert grid.decoding is None


def test_map_info_places_the_outer_corner_of_the_first_pixel(tmp_path: Path) -> None:
    place = read_grid(EnviPair().write(tmp_path)).georeference
    assert (place.x(0), place.y(0)) == (10.25, 49.875)
    assert (place.step_x, place.step_y) == (0.5, 0.25)
    assert place.body == "Earth"


def test_map_info_may_place_another_pixel(tmp_path: Path) -> None:
    words = {"map info": "{Geographic Lat/Lon, 1.5, 2.5, 10.25, 49.625, 0.5, 0.25, WGS-84}"}
    place = read_grid(EnviPair(words=words).write(tmp_path)).georeference
    assert (place.x(0), place.y(0)) == (10.25, 49.875)


@pytest.mark.parametrize("sample", ["<h", ">h", "<H", ">i", "<f", ">f", "<d", ">d"])
def test_sample_types_are_mapped(tmp_path: Path, sample: str) -> None:
    grid = read_grid(EnviPair([[1, 2], [3, 4]], sample=sample).write(tmp_path))
    assert heights(grid) == [[1, 2], [3, 4]]
    assert grid.decoding is None


@pytest.mark.parametrize("sample", ["<B", ">I"])
@needs_raw_decoder
def test_other_sample_types_are_decoded(tmp_path: Path, sample: str) -> None:
    assert heights(read_grid(EnviPair([[1, 2], [3, 4]], sample=sample).write(tmp_path))) == [[1, 2], [3, 4]]


def test_header_offset_gain_and_offset_of_data(tmp_path: Path) -> None:
    words = {"header offset": 5, "data gain values": "{0.5, 3}", "data offset values": "{100}"}
    pair = EnviPair([[1, 2], [3, 4]], words=words, sample=">h", data=b"12345" + packed([[1, 2], [3, 4]]))
    assert heights(read_grid(pair.write(tmp_path))) == [[100.5, 101], [101.5, 102]]


@pytest.mark.parametrize("interleave", ["bsq", "BIL"])
def test_the_first_of_several_bands_is_mapped(tmp_path: Path, interleave: str) -> None:
    rows = [[1, 2], [9, 9], [3, 4], [9, 9]] if interleave == "BIL" else [[1, 2], [3, 4], [9, 9], [9, 9]]
    words = {"bands": 2, "interleave": interleave}
    pair = EnviPair([[1, 2], [3, 4]], words=words, sample=">h", data=packed(rows))
    grid = read_grid(pair.write(tmp_path))
    assert heights(grid) == [[1, 2], [3, 4]]
    assert "2 bands" in " ".join(grid.notes)


def test_mars_is_no_ellipsoid_of_the_earth(tmp_path: Path) -> None:
    words = {"map info": "{Geographic Lat/Lon, 1, 1, 10, 50, 0.5, 0.25, D_Mars_2000, units=Degrees}"}
    place = read_grid(EnviPair(words=words).write(tmp_path)).georeference
    assert place.body == "Mars"
    assert place.ellipsoid.semi_major == 3_396_190.0


@pytest.mark.parametrize(("half", "north"), [("North", 4_600_000), ("South", 5_400_000)])
def test_utm_zones_give_longitude_and_latitude(tmp_path: Path, half: str, north: int) -> None:
    """500 km east is the central meridian: 123 W in zone 10."""
    words = {"map info": f"{{UTM, 1.5, 1.5, 500000, {north}, 30, 30, 10, {half}, WGS-84, units=Meters}}"}
    grid = read_grid(EnviPair(words=words).write(tmp_path))
    found = grid.georeference.longitude_latitude(0, 0)
    assert found is not None
    assert found[0] == pytest.approx(237.0)
    assert abs(found[1]) == pytest.approx(41.5520, abs=1e-3)
    assert (found[1] > 0) == (half == "North")
    assert grid.notes == ()


@pytest.mark.parametrize(
    ("units", "metres"),
    [
        ("Meters", 1.0),
        ("Km", 1000.0),
        ("Feet", 0.3048),
        ("US Survey Feet", 1200 / 3937),
        ("Miles", 1609.344),
        ("Nautical Miles", 1852.0),
    ],
)
def test_lengths_of_map_info_have_its_units(tmp_path: Path, units: str, metres: float) -> None:
    words = {"map info": f"{{UTM, 1, 1, 500, 600, 10, 20, 10, North, WGS-84, units={units}}}"}
    grid = read_grid(EnviPair(words=words).write(tmp_path))
    assert grid.layout.cell_width == pytest.approx(10.0 * metres, rel=1e-12)
    assert grid.layout.cell_height == pytest.approx(20.0 * metres, rel=1e-12)
    assert grid.georeference.x(0) == pytest.approx(505.0 * metres, rel=1e-12)
    assert grid.georeference.y(0) == pytest.approx(590.0 * metres, rel=1e-12)


@pytest.mark.parametrize("datum", ["WGS-84", "D_Mars_2000", "of nobody"])
@pytest.mark.parametrize(
    ("units", "degrees"),
    [("Degrees", 1.0), ("Minutes", 1 / 60), ("SECONDS", 1 / 3600), ("Radians", 180 / math.pi)],
)
def test_angles_of_map_info_have_its_units(tmp_path: Path, units: str, degrees: float, datum: str) -> None:
    x, y, step = 10.0 / degrees, 50.0 / degrees, 0.5 / degrees
    words = {"map info": f"{{Geographic Lat/Lon, 1, 1, {x}, {y}, {step}, {step}, {datum}, units={units}}}"}
    place = read_grid(EnviPair(words=words).write(tmp_path)).georeference
    assert (place.x(0), place.y(0), place.step_x) == pytest.approx((10.25, 49.75, 0.5))


def test_the_feet_of_the_coordinate_system_string_are_more_exact(tmp_path: Path) -> None:
    told = (
        'PROJCS["x",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137,298.257223563]],'
        'PRIMEM["Greenwich",0],UNIT["Degree",0.017453292519943295]],PROJECTION["Transverse_Mercator"],'
        'PARAMETER["False_Easting",0],PARAMETER["False_Northing",0],PARAMETER["Central_Meridian",-123],'
        'PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0],UNIT["Foot_US",0.30480060960121924]]'
    )
    words = {
        "map info": "{Transverse Mercator, 1, 1, 0, 0, 1, 1, WGS-84, units=Feet}",
        "coordinate system string": f"{{{told}}}",
    }
    place = read_grid(EnviPair(words=words).write(tmp_path)).georeference
    assert place.step_x == pytest.approx(1200 / 3937, rel=1e-9)


def test_without_map_info_the_grid_is_read_and_says_so(tmp_path: Path) -> None:
    grid = read_grid(EnviPair(words={"map info": None}).write(tmp_path))
    assert grid.layout.cell_width == 1.0
    assert "no map info" in " ".join(grid.notes)


def test_keywords_in_capitals_and_carriage_returns(tmp_path: Path) -> None:
    header = EnviPair().write(tmp_path)
    text = header.read_text().replace("samples", "SAMPLES").replace("data type", "Data  Type")
    header.write_bytes(text.replace("\n", "\r\n").encode())
    assert heights(read_grid(header)) == EXPECTED


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ({"samples": None}, ["samples", "nothing"]),
        ({"lines": 1}, ["lines", "1", "at least 2"]),
        ({"lines": 10**12}, ["lines", "1,000,000,000,000"]),
        ({"samples": "-3"}, ["samples", "-3"]),
        ({"samples": "nan"}, ["samples", "nan"]),
        ({"samples": 1e300}, ["samples"]),
        ({"data type": 6}, ["data type", "6", "12"]),
        ({"data type": None}, ["data type"]),
        ({"byte order": 2}, ["byte order", "2"]),
        ({"byte order": None}, ["byte order"]),
        ({"interleave": "heap"}, ["interleave", "heap"]),
        ({"bands": 0}, ["bands", "0"]),
        ({"bands": 3}, []),
        ({"header offset": 10**15}, ["length", "24 bytes"]),
        ({"file compression": 1}, ["file compression"]),
        ({"data gain values": "{0}"}, ["grid", "scale"]),
        ({"map info": "{UTM, 1, 1, x, 5, 1, 1, 10, North}"}, ["map info", "x"]),
        ({"map info": "{UTM, 1, 1, 5, 5, 1, 1, 61, North}"}, ["map info: zone", "61"]),
        ({"map info": "{UTM, 1, 1, 5, 5, 0, 1, 10, North}"}, ["x size", "above 0"]),
        ({"map info": "{UTM, 1, 1, 1e300, 5, 1, 1}"}, ["coordinates on a planet"]),
        ({"map info": "{UTM, 1, 1, 5, 5, 1, 1, 10, North, rotation=30}"}, ["rotation", "30"]),
        ({"map info": "{UTM, 1, 1, 5, 5, 1, 1, 10, North, units=Cubits}"}, ["units", "cubits", "feet"]),
        ({"map info": "{UTM, 1, 1, 5, 5, 1, 1, 10, North, units=Degrees}"}, ["units", "degrees", "Meters"]),
        (
            {"map info": "{Geographic Lat/Lon, 1, 1, 0, 5, 1, 1, WGS-84, units=Feet}"},
            ["units", "feet", "Degrees"],
        ),
        (
            {"map info": "{Geographic Lat/Lon, 1, 1, 0, 500, 1, 1, WGS-84}"},
            ["place of the grid", "498.5 to 499.5"],
        ),
    ],
)
def test_a_header_that_cannot_be_used(tmp_path: Path, words: dict[str, object], named: list[str]) -> None:
    header = EnviPair(words=words).write(tmp_path)
    if not named:
        assert read_grid(header).samples == 6  # bands after the first may be missing
        return
    text = complaint(header)
    for word in named:
        assert word in text


def test_data_cut_short(tmp_path: Path) -> None:
    header = EnviPair(data=bytes(23)).write(tmp_path)
    assert "grid: length: found 23 bytes, expected 24 bytes" in complaint(header)


def test_a_header_without_data(tmp_path: Path) -> None:
    header = EnviPair().write(tmp_path)
    (tmp_path / "grid").unlink()
    assert "grid.dat" in complaint(header)


@pytest.mark.parametrize("length", range(0, 400, 11))
def test_a_header_cut_anywhere(tmp_path: Path, length: int) -> None:
    header = EnviPair().write(tmp_path)
    whole = header.read_bytes()
    header.write_bytes(whole[:length])
    if length <= whole.index(b"byte order") or whole.index(b"map info = ") + 12 < length < whole.index(
        b"}\ndata"
    ):
        assert "grid" in complaint(header)
    elif whole.index(b"byte order") + 14 < length < whole.index(b"map info = {"):
        assert "no map info" in " ".join(read_grid(header).notes)
