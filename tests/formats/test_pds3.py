"""What a MOLA label of a cylindrical map means, and how it is refused."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from addon.formats import FormatError, read_grid
from tests.formats.megdr_pair import MegdrPair, planet, rough

REAL = Path(__file__).resolve().parents[3] / "shared" / "data" / "mola" / "megt90n000cb.lbl"

needs_mola = pytest.mark.skipif(not REAL.is_file(), reason="the real MOLA grid is not beside the checkout")


@pytest.fixture
def pair() -> MegdrPair:
    return MegdrPair(rough(4, 6))


def test_samples_lie_where_the_label_says(pair: MegdrPair, tmp_path: Path) -> None:
    grid = read_grid(pair.write(tmp_path))
    samples = grid.open()
    for row, heights in enumerate(pair.heights):
        for column, height in enumerate(heights):
            assert samples.elevation(column, row) == height


def test_the_data_file_leads_to_its_label(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    assert read_grid(label.with_suffix(".img")).data_path == label.with_suffix(".img")


@pytest.mark.parametrize("ending", ["lbl", "img", "LBL", "IMG"])
def test_partners_in_another_letter_case_are_found(pair: MegdrPair, tmp_path: Path, ending: str) -> None:
    label = pair.write(tmp_path)
    label.with_suffix(".img").rename(tmp_path / "GRID.Img")
    label.rename(tmp_path / "Grid.LBL")
    assert read_grid(tmp_path / f"grid.{ending}").samples == 24


@pytest.mark.parametrize(
    ("sample_type", "sample", "first"),
    [
        ("MSB_INTEGER", ">h", -2000),
        ("LSB_INTEGER", "<h", -2000),
        ("MSB_UNSIGNED_INTEGER", ">H", 40_000),
        ("LSB_UNSIGNED_INTEGER", "<H", 40_000),
    ],
)
def test_sample_types(tmp_path: Path, sample_type: str, sample: str, first: int) -> None:
    pair = MegdrPair([[first, 1], [2, 3]], sample=sample, image={"SAMPLE_TYPE": sample_type})
    assert read_grid(pair.write(tmp_path)).open().elevation(0, 0) == first


def test_scaling_factor_and_offset_are_applied(tmp_path: Path) -> None:
    pair = MegdrPair([[4, 8], [12, 16]], image={"SCALING_FACTOR": 0.25, "OFFSET": -8000})
    assert read_grid(pair.write(tmp_path)).open().elevation(1, 1) == 16 * 0.25 - 8000


def test_radius_products_do_not_overflow(tmp_path: Path) -> None:
    image = {"OFFSET": 3_396_000, "NAME": "MEDIAN_RADIUS"}
    grid = read_grid(MegdrPair([[21134, 1], [2, 3]], image=image).write(tmp_path))
    assert grid.open().elevation(0, 0) == 3_417_134
    assert grid.georeference.vertical_reference == "centre of the body"


def test_missing_constant_is_a_hole(tmp_path: Path) -> None:
    pair = MegdrPair([[1, -32768], [2, 3]], image={"MISSING_CONSTANT": -32768})
    assert read_grid(pair.write(tmp_path)).open().elevation(1, 0) is None


def test_bytes_around_the_samples_are_stepped_over(tmp_path: Path) -> None:
    pair = MegdrPair(
        rough(2, 3), header={"^IMAGE": '("GRID.IMG", 3 <BYTES>)'}, image={"LINE_PREFIX_BYTES": 4}
    )
    label = pair.write(tmp_path)
    rows = (pair.data()[:6], pair.data()[6:])
    label.with_suffix(".img").write_bytes(b".." + b"".join(b"pre4" + row for row in rows))
    samples = read_grid(label).open()
    assert samples.elevation(2, 1) == pair.heights[1][2]


def test_a_pointer_may_count_records(tmp_path: Path) -> None:
    pair = MegdrPair(rough(2, 3), header={"^IMAGE": '("GRID.IMG", 2)'})
    label = pair.write(tmp_path)
    label.with_suffix(".img").write_bytes(bytes(6) + pair.data())
    assert read_grid(label).open().elevation(0, 0) == pair.heights[0][0]


def test_geometry_comes_from_resolution_and_limits(pair: MegdrPair, tmp_path: Path) -> None:
    grid = read_grid(pair.write(tmp_path))
    degree = math.pi * 3_396_000.0 / 180.0
    assert grid.layout.cell_height == pytest.approx(degree, rel=1e-12)
    assert grid.layout.cell_width == pytest.approx(degree * math.cos(math.radians(8.0)), rel=1e-12)
    assert not grid.layout.wraps


def test_samples_are_at_cell_centres(pair: MegdrPair, tmp_path: Path) -> None:
    place = read_grid(pair.write(tmp_path)).georeference
    assert place.longitude_latitude(0, 0) == (20.5, 9.5)
    assert place.longitude_latitude(5, 3) == (25.5, 6.5)


def test_columns_and_rows_lead_to_longitude_and_latitude(pair: MegdrPair, tmp_path: Path) -> None:
    grid = read_grid(pair.write(tmp_path))
    assert grid.georeference.longitude_latitude(2.0, 3.0) == pytest.approx((22.5, 6.5))


def test_longitudes_run_from_0_to_360_east(tmp_path: Path) -> None:
    grid = read_grid(replace(MegdrPair(rough(4, 6)), west=-3.0).write(tmp_path))
    assert grid.georeference.x(0) % 360.0 == 357.5
    assert grid.georeference.x(5) % 360.0 == 2.5


def test_a_map_across_the_meridian_may_name_its_limits_backwards(tmp_path: Path) -> None:
    pair = replace(MegdrPair(rough(4, 6)), west=357.0, projection={"EASTERNMOST_LONGITUDE": 3.0})
    grid = read_grid(pair.write(tmp_path))
    assert not grid.layout.wraps
    assert grid.georeference.x(3) % 360.0 == 0.5


def test_a_whole_planet_wraps_and_has_no_edge(tmp_path: Path) -> None:
    grid = read_grid(planet().write(tmp_path))
    assert grid.layout.wraps
    assert grid.triangles == 2 * 360 * 179
    assert grid.layout.cell_width == pytest.approx(grid.layout.cell_height)


def test_made_up_heights_are_named_so(pair: MegdrPair, tmp_path: Path) -> None:
    assert not read_grid(pair.write(tmp_path)).synthetic
    told = replace(pair, header={"DATA_SET_ID": '"HAPTIC_TERRAIN_SYNTHETIC"'}, name="told")
    grid = read_grid(told.write(tmp_path))
    assert grid.synthetic
    assert "synthetic" in grid.title.lower()


@needs_mola
def test_the_real_planet_has_its_known_extremes() -> None:
    grid = read_grid(REAL)
    extent = grid.open().range()
    assert extent is not None
    assert (grid.samples, grid.triangles) == (1_036_800, 2_070_720)
    place = grid.georeference
    top, bottom = extent.maximum_cell, extent.minimum_cell
    assert (extent.maximum, place.longitude_latitude(*top)) == (21134, (226.875, 17.375))
    assert (extent.minimum, place.longitude_latitude(*bottom)) == (-8068, (62.125, -32.875))


@needs_mola
def test_the_real_planet_has_its_known_mean() -> None:
    grid = read_grid(REAL)
    samples, layout = grid.open(), grid.layout
    total = weight = 0.0
    for row in range(layout.rows):
        share = math.cos(math.radians(grid.georeference.y(row)))
        total += share * sum(samples.elevations(range(layout.columns), [row]))
        weight += share * layout.columns
    assert total / weight == pytest.approx(-551.5, abs=0.05)


def complaint(path: Path) -> str:
    with pytest.raises(FormatError) as caught:
        read_grid(path)
    return str(caught.value)


def test_a_missing_label_is_named(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    label.unlink()
    assert "grid.lbl" in complaint(label)
    assert "grid.lbl" in complaint(label.with_suffix(".img"))


@pytest.mark.parametrize("name", ["mars.lbl", "mars.img", "mars"])
def test_a_mistyped_path_is_told_whole(tmp_path: Path, name: str) -> None:
    wrong = tmp_path / "nowhere" / name
    with pytest.raises(FormatError, match=r"Check the path\.$") as caught:
        read_grid(wrong)
    assert f"no such file as {wrong}" in str(caught.value)


def test_a_missing_data_file_is_named(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    label.with_suffix(".img").unlink()
    assert "GRID.IMG" in complaint(label)


def test_data_shorter_than_the_label_says(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    label.with_suffix(".img").write_bytes(pair.data()[:-1])
    text = complaint(label)
    assert "47 bytes" in text
    assert "48 bytes" in text


@pytest.mark.parametrize(
    ("image", "named"),
    [
        ({"SAMPLE_TYPE": "VAX_REAL"}, ["SAMPLE_TYPE", "VAX_REAL", "MSB_INTEGER"]),
        ({"SAMPLE_TYPE": "IEEE_REAL"}, ["SAMPLE_BITS", "16", "32, 64 for IEEE_REAL"]),
        ({"SAMPLE_BITS": 12}, ["SAMPLE_BITS", "12", "8, 16, 32"]),
        ({"SAMPLE_BITS": None}, ["SAMPLE_BITS"]),
        ({"ENCODING_TYPE": "CLEM-JPEG-1"}, ["ENCODING_TYPE", "CLEM-JPEG-1", "raw samples"]),
        ({"LINES": "many"}, ["LINES", "many", "a number"]),
        ({"LINES": 1}, ["LINES", "1", "at least 2"]),
        ({"LINE_SAMPLES": 1}, ["LINE_SAMPLES", "1", "at least 2"]),
        ({"LINE_SAMPLES": 7}, ["LINE_SAMPLES", "7", "6"]),
        ({"LINES": 3.5}, ["LINES", "3.5", "whole"]),
        ({"LINES": -4}, ["LINES", "-4"]),
        ({"BANDS": 3, "BAND_STORAGE_TYPE": "HEAPED"}, ["BAND_STORAGE_TYPE", "HEAPED"]),
        ({"SCALING_FACTOR": "'N/A'"}, ["SCALING_FACTOR", "N/A", "a number"]),
        ({"SCALING_FACTOR": 0}, ["grid", "scale"]),
    ],
)
def test_an_image_object_that_cannot_be_used(
    pair: MegdrPair, tmp_path: Path, image: dict[str, object], named: list[str]
) -> None:
    text = complaint(replace(pair, image=image).write(tmp_path))
    assert "grid.lbl" in text
    for word in named:
        assert word in text


@pytest.mark.parametrize(
    ("projection", "named"),
    [
        ({"MAP_PROJECTION_TYPE": '"POLAR STEREOGRAPHIC"'}, ["CENTER_LATITUDE", "nothing", "90 or -90"]),
        ({"MAP_PROJECTION_TYPE": None}, ["MAP_PROJECTION_TYPE", "IMAGE_MAP_PROJECTION"]),
        ({"MAP_RESOLUTION": 0}, ["MAP_RESOLUTION", "above 0"]),
        ({"MAP_RESOLUTION": "'N/A'"}, ["MAP_RESOLUTION", "N/A"]),
        ({"MAP_RESOLUTION": None}, ["MAP_RESOLUTION", "IMAGE_MAP_PROJECTION"]),
        ({"MAXIMUM_LATITUDE": 100}, ["MAXIMUM_LATITUDE", "100"]),
        ({"POSITIVE_LONGITUDE_DIRECTION": '"WEST"'}, ["POSITIVE_LONGITUDE_DIRECTION", "WEST", "EAST"]),
    ],
)
def test_a_projection_that_cannot_be_used(
    pair: MegdrPair, tmp_path: Path, projection: dict[str, object], named: list[str]
) -> None:
    text = complaint(replace(pair, projection=projection).write(tmp_path))
    for word in named:
        assert word in text


def test_no_image_object(pair: MegdrPair, tmp_path: Path) -> None:
    label = pair.write(tmp_path)
    label.write_text(label.read_text().replace("= IMAGE\n", "= TABLE\n"))
    assert "IMAGE" in complaint(label)


@pytest.mark.parametrize("pointer", ["0", "1.5", "TRUE", "(1, 2, 3)", "('GRID.IMG', 0)", None])
def test_a_pointer_that_leads_nowhere(pair: MegdrPair, tmp_path: Path, pointer: str | None) -> None:
    assert "^IMAGE" in complaint(replace(pair, header={"^IMAGE": pointer}).write(tmp_path))


@pytest.mark.parametrize(
    "name", ["../G.IMG", "/G.IMG", "C:G.IMG", r"..\G.IMG", "", ".", "..", "G" * 300, "G\N{CENT SIGN}" * 200]
)
def test_a_pointer_to_anything_but_a_file_beside_the_label(
    pair: MegdrPair, tmp_path: Path, name: str
) -> None:
    label = replace(pair, header={"^IMAGE": "NAME"}).write(tmp_path)
    label.write_text(label.read_text().replace("^IMAGE = NAME", f'^IMAGE = "{name}"'), encoding="latin-1")
    (tmp_path.parent / "G.IMG").write_bytes(pair.data())
    text = complaint(label)
    for word in ("grid.lbl: ^IMAGE: found", name[:50], "expected the bare name", "Mend the label."):
        assert word in text
    assert len(text) < 400


@pytest.mark.parametrize("name", ["lbl", "img"])
def test_a_chosen_name_that_no_system_takes(tmp_path: Path, name: str) -> None:
    assert "no such file" in complaint(tmp_path / f"{'g' * 300}.{name}")


HUGE = "1" + 400 * "0"


@pytest.mark.parametrize(
    ("where", "field", "value"),
    [
        ("image", "LINES", HUGE),
        ("image", "LINES", "1e300"),
        ("image", "LINE_PREFIX_BYTES", "1e30"),
        ("image", "LINE_SUFFIX_BYTES", f"16#{'F' * 6000}#"),
        ("image", "OFFSET", "1e400"),
        ("image", "MISSING_CONSTANT", HUGE),
        ("projection", "A_AXIS_RADIUS", HUGE),
        ("projection", "MAP_RESOLUTION", "1e400"),
        ("projection", "WESTERNMOST_LONGITUDE", "1e300"),
        ("header", "^IMAGE", '("G.IMG", 1e400 <BYTES>)'),
        ("header", "^IMAGE", f'("G.IMG", {HUGE})'),
        ("header", "^IMAGE", '("G.IMG", 1.5 <BYTES>)'),
        ("header", "^IMAGE", '("G.IMG", "3" <BYTES>)'),
    ],
)
def test_numbers_beyond_all_measure(
    pair: MegdrPair, tmp_path: Path, where: str, field: str, value: str
) -> None:
    spoilt: dict[str, Any] = {where: {field: value}}
    text = complaint(replace(pair, **spoilt).write(tmp_path))
    assert text.startswith("grid.lbl: ")
    assert field in text
    assert "expected" in text
    assert len(text) < 500


@pytest.mark.parametrize(
    ("field", "value", "same"),
    [
        ("A_AXIS_RADIUS", "3396000.0 <M>", "3396.0 <KM>"),
        ("A_AXIS_RADIUS", "3396.0", "3396.0 <KM>"),
        ("A_AXIS_RADIUS", "3396.0 <km>", "3396.0 <KM>"),
        ("MAP_RESOLUTION", "1.0 <PIX/DEG>", "1.0 <PIXEL/DEGREE>"),
        ("MAP_RESOLUTION", "1.0", "1.0 <PIXEL/DEGREE>"),
        ("MAXIMUM_LATITUDE", "10 <DEG>", "10 <DEGREE>"),
    ],
)
def test_written_units_are_heeded(pair: MegdrPair, tmp_path: Path, field: str, value: str, same: str) -> None:
    written = read_grid(replace(pair, projection={field: value}).write(tmp_path))
    meant = read_grid(replace(pair, projection={field: same}).write(tmp_path))
    assert written.georeference == meant.georeference
    assert written.georeference.ellipsoid.semi_major == 3_396_000.0


@pytest.mark.parametrize(
    ("where", "field", "value", "unit"),
    [
        ("projection", "A_AXIS_RADIUS", "2110 <MILES>", "MILES"),
        ("projection", "MAP_RESOLUTION", "1.0 <PIXEL/RADIAN>", "PIXEL/RADIAN"),
        ("projection", "MAXIMUM_LATITUDE", "0.2 <RADIAN>", "RADIAN"),
        ("projection", "WESTERNMOST_LONGITUDE", "20 <HOUR>", "HOUR"),
        ("image", "OFFSET", "3396 <FEET>", "FEET"),
        ("image", "UNIT", "FATHOM", "FATHOM"),
    ],
)
def test_other_units_are_refused(
    pair: MegdrPair, tmp_path: Path, where: str, field: str, value: str, unit: str
) -> None:
    spoilt: dict[str, Any] = {where: {field: value}}
    text = complaint(replace(pair, **spoilt).write(tmp_path))
    for word in (f"grid.lbl: {field}", unit, "expected", "Mend" if where != "image" else "."):
        assert word in text


def test_a_text_that_is_too_long_for_a_label_is_not_followed(
    pair: MegdrPair, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def follow(_text: str, **_options: object) -> None:
        raise AssertionError("the text was followed")

    label = pair.write(tmp_path)
    label.write_text(label.read_text().replace("END\n", "A = (1, 2)\n" * 6000 + "END\n"))
    monkeypatch.setattr("addon.formats.pds.label.pvl.loads", follow)
    assert "65,536 bytes" in complaint(label)


@pytest.mark.parametrize(
    "content",
    [b"hello", bytes(range(256)) * 40, b"PDS_VERSION_ID = PDS3\r\nOBJECT ="],
)
def test_not_a_label_at_all(tmp_path: Path, content: bytes) -> None:
    label = tmp_path / "grid.lbl"
    label.write_bytes(content)
    assert "grid.lbl: label" in complaint(label) or "^IMAGE" in complaint(label)


def test_another_kind_of_file(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("Buy milk.")
    text = complaint(tmp_path / "notes.txt")
    assert "notes.txt" in text
    assert ".lbl or .img" in text


@pytest.mark.parametrize("line", ["==A = 1", "A == 1", "=", "A = = 1", "(=", "A = (1 == 2)"])
def test_signs_that_lead_nowhere_do_not_go_round_for_ever(pair: MegdrPair, tmp_path: Path, line: str) -> None:
    label = pair.write(tmp_path)
    for place in ("LINES = 4", "OBJECT = IMAGE_MAP", "RECORD_TYPE"):
        spoilt = label.read_text().replace(place, f"{line}\n{place}", 1)
        label.with_name("spoilt.lbl").write_text(spoilt)
        with suppress(FormatError):
            read_grid(label.with_name("spoilt.lbl"))


def test_a_folder_is_not_a_label(tmp_path: Path) -> None:
    (tmp_path / "grid.lbl").mkdir()
    assert "grid.lbl" in complaint(tmp_path / "grid.lbl")
