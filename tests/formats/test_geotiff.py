"""What a GeoTIFF file means, and what is said of one that means nothing."""

from __future__ import annotations

import contextlib
import math
import random
from pathlib import Path
from typing import Any

import pytest
from proxygraph import CancelledError, DecodeError, GeoTiff, GridLayout, Progress

from addon.formats import ElevationGrid, FormatError, Region
from addon.formats.geotiff import geotiff_nodata
from addon.formats.geotiff.geotiff_reader import read_geotiff
from addon.formats.geotiff.tiff_magic import looks_like_tiff
from tests.formats.megdr_pair import rough
from tests.formats.tiff_file import ASCII, DOUBLE, LONG, SHORT, WGS_84, TiffFile

SHARED = Path(__file__).resolve().parents[3] / "shared" / "data"
REAL = SHARED / "ned" / "craterlake-elev-16bit-30m.tif"

needs_crater_lake = pytest.mark.skipif(
    not REAL.is_file(), reason="the real Crater Lake grid is not beside the checkout"
)

PACKINGS = [(1, 1), (32773, 1), (5, 1), (5, 2), (5, 3), (8, 1), (8, 2), (8, 3), (32946, 2)]
TYPES = ("u8", "i8", "u16", "i16", "u32", "i32", "f32", "f64")
TILES: tuple[tuple[int, int] | None, ...] = (None, (4, 5), (16, 16))
METRES = {1024: 1, 1025: 1, 3072: 32767, 3076: 9001}
"""Geo keys of a map in metres of a projection that is not stated."""


def heights_for(sample: str, rows: int = 11, columns: int = 9) -> list[list[float]]:
    """Values that the type holds, its limits and fractions among them."""
    found: list[list[float]] = [[value % 120 for value in row] for row in rough(rows, columns)]
    if sample.startswith("f"):
        return [[value * 1.25 - 20.5 for value in row] for row in found]
    bits = int(sample[1:])
    least, most = (0, 2**bits - 1) if sample.startswith("u") else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
    found[2][3:5] = [float(least), float(most)]
    return found


def read_back(grid: ElevationGrid) -> list[list[float | None]]:
    samples = grid.open()
    return [
        [samples.elevation(column, row) for column in range(grid.layout.columns)]
        for row in range(grid.layout.rows)
    ]


def refused(path: Path) -> FormatError:
    with pytest.raises(FormatError) as caught:
        read_geotiff(path)
    return caught.value


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("tile", TILES)
@pytest.mark.parametrize(("compression", "predictor"), PACKINGS)
def test_every_sample_is_read(
    tmp_path: Path, compression: int, predictor: int, tile: tuple[int, int] | None, order: Any
) -> None:
    for sample in TYPES:
        if predictor == 3 and not sample.startswith("f"):
            continue
        heights = heights_for(sample)
        for big in (False, True):
            file = TiffFile(
                heights,
                sample=sample,
                order=order,
                big=big,
                compression=compression,
                predictor=predictor,
                tile=tile,
                tags={42113: (ASCII, "77.7")},
            )
            grid = read_geotiff(file.write(tmp_path))
            assert read_back(grid) == heights, sample


@pytest.mark.parametrize("planar", [False, True])
@pytest.mark.parametrize(("compression", "predictor"), PACKINGS)
def test_the_first_of_several_bands_is_taken_and_a_note_says_so(
    tmp_path: Path, compression: int, predictor: int, planar: bool
) -> None:
    heights = heights_for("f32")
    file = TiffFile(
        heights, sample="f32", bands=3, planar=planar, compression=compression, predictor=predictor
    )
    grid = read_geotiff(file.write(tmp_path))
    assert read_back(grid) == heights
    assert "first of 3 bands" in grid.notes[0]


def test_lzw_whose_table_fills_and_begins_anew_is_read(tmp_path: Path) -> None:
    noise = random.Random(3)
    heights = [[float(noise.randrange(-30_000, 30_000)) for _ in range(70)] for _ in range(60)]
    file = TiffFile(heights, compression=5, rows_per_strip=60)
    assert read_back(read_geotiff(file.write(tmp_path))) == heights


def test_lzw_without_an_end_code_is_read(tmp_path: Path) -> None:
    heights = rough(8, 9)
    file = TiffFile(heights, compression=5, rows_per_strip=8)
    whole = file.data()
    tiff = GeoTiff.open(file.write(tmp_path))
    numbers = tiff.numbers(279)
    assert numbers is not None
    # The end code is in the last 2 bytes; what comes after the samples may be anything.
    end = 8 + int(numbers[0])
    (tmp_path / file.name).write_bytes(whole[: end - 1] + b"\xff" + whole[end:])
    assert read_back(read_geotiff(tmp_path / file.name)) == heights


def test_uncompressed_strips_are_mapped_in_place(tmp_path: Path) -> None:
    grid = read_geotiff(TiffFile(rough(7, 5), order=">").write(tmp_path))
    assert grid.decoding is None
    assert (grid.layout.offset, grid.layout.row_stride, grid.layout.byte_order) == (8, 10, "big")


def test_strips_that_are_not_in_one_piece_are_decoded(tmp_path: Path) -> None:
    heights = rough(4, 3)
    file = TiffFile(heights, rows_per_strip=2)
    first_strip = file.data()[8:20]
    file.tags = {273: (LONG, [len(file.data()), 20])}
    path = file.write(tmp_path)
    path.write_bytes(path.read_bytes() + first_strip)
    grid = read_geotiff(path)
    assert grid.decoding is not None
    assert read_back(grid) == heights


@pytest.mark.parametrize("compression", [1, 8])
def test_a_region_has_the_same_samples(tmp_path: Path, compression: int) -> None:
    heights = rough(23, 19)
    whole = read_geotiff(TiffFile(heights, compression=compression, tile=(4, 5)).write(tmp_path))
    cut = whole.region(Region(first_column=3, first_row=6, columns=11, rows=14))
    assert read_back(cut) == [row[3:14] for row in heights[6:20]]
    assert cut.georeference.x(0) == whole.georeference.x(3)


def test_a_region_needs_only_its_own_tiles(tmp_path: Path) -> None:
    heights = rough(16, 16)
    file = TiffFile(heights, compression=8, tile=(8, 8), tags={42113: (ASCII, "-5000")})
    path = file.write(tmp_path)
    data = bytearray(path.read_bytes())
    offsets = GeoTiff.open(path).numbers(324)
    assert offsets is not None
    data[int(offsets[3]) + 5] ^= 0xFF
    path.write_bytes(data)
    grid = read_geotiff(path)
    assert read_back(grid.region(Region(0, 0, 8, 16))) == [row[:8] for row in heights]
    with pytest.raises(FormatError, match="tile 3"):
        grid.open()


def test_a_region_across_the_seam_of_a_planet_is_brought_together(tmp_path: Path) -> None:
    heights = rough(18, 36)
    tags = {
        33550: (DOUBLE, [10.0, 10.0, 0.0]),
        33922: (DOUBLE, [0.0, 0.0, 0.0, 0.0, 90.0, 0.0]),
    }
    grid = read_geotiff(TiffFile(heights, compression=8, tile=(16, 16), tags=tags).write(tmp_path))
    assert grid.layout.wraps
    cut = grid.region(Region(first_column=33, first_row=1, columns=6, rows=4))
    assert read_back(cut) == [row[33:] + row[:3] for row in heights[1:5]]


@pytest.mark.parametrize("compression", [1, 8])
def test_rows_from_south_to_north_are_turned_over(tmp_path: Path, compression: int) -> None:
    heights = rough(7, 5)
    matrix = [0.5, 0.0, 0.0, 10.0, 0.0, 0.25, 0.0, 20.0, *[0.0] * 7, 1.0]
    tags = {33550: None, 33922: None, 34264: (DOUBLE, matrix)}
    grid = read_geotiff(TiffFile(heights, compression=compression, tags=tags).write(tmp_path))
    assert read_back(grid) == heights[::-1]
    assert grid.georeference.first_y == 20.0 + 6.5 * 0.25
    assert grid.georeference.y(6) == 20.0 + 0.5 * 0.25
    cut = grid.region(Region(1, 2, 3, 4))
    assert read_back(cut) == [row[1:4] for row in heights[::-1][2:6]]


def test_pixels_are_cells_unless_the_file_says_points(tmp_path: Path) -> None:
    cells = read_geotiff(TiffFile(rough(4, 5)).write(tmp_path)).georeference
    assert (cells.first_x, cells.first_y, cells.registration) == (10.25, 19.875, "cells")
    points = read_geotiff(TiffFile(rough(4, 5), keys={**WGS_84, 1025: 2}).write(tmp_path)).georeference
    assert (points.first_x, points.first_y, points.registration) == (10.0, 20.0, "points")


def test_a_tie_point_within_the_raster_is_taken_back_to_its_corner(tmp_path: Path) -> None:
    tags = {33922: (DOUBLE, [2.0, 4.0, 0.0, 11.0, 19.0, 0.0])}
    place = read_geotiff(TiffFile(rough(4, 5), tags=tags).write(tmp_path)).georeference
    assert (place.first_x, place.first_y) == (10.25, 19.875)


@pytest.mark.parametrize(
    ("matrix", "found"),
    [
        ([0.5, 0.1, 0, 10, 0.1, -0.25, 0, 20, *[0] * 7, 1], "turned or sheared"),
        ([-0.5, 0, 0, 10, 0, -0.25, 0, 20, *[0] * 7, 1], "columns that run west"),
        ([0, 0, 0, 10, 0, 0, 0, 20, *[0] * 7, 1], "steps of 0"),
        ([math.nan, 0, 0, 10, 0, -0.25, 0, 20, *[0] * 7, 1], "nan"),
        ([1e300, 0, 0, 10, 0, -1e300, 0, 20, *[0] * 7, 1], "5e+299"),
        ([0.5] * 3, "3 numbers"),
    ],
)
def test_rasters_that_are_not_upright_are_refused(tmp_path: Path, matrix: list[float], found: str) -> None:
    tags = {33550: None, 33922: None, 34264: (DOUBLE, matrix)}
    error = refused(TiffFile(rough(4, 5), tags=tags).write(tmp_path))
    assert found in str(error)


def test_control_points_without_a_scale_are_refused(tmp_path: Path) -> None:
    tags = {33550: None, 33922: (DOUBLE, [0.0, 0, 0, 10, 20, 0, 5, 5, 0, 12, 18, 0])}
    assert "control points" in str(refused(TiffFile(rough(4, 5), tags=tags).write(tmp_path)))


@pytest.mark.parametrize(
    ("keys", "degrees"),
    [
        ({2054: 9102}, 1.0),
        ({2054: 9104}, 1 / 3600),
        ({2054: 9101}, math.degrees(1)),
        ({2054: 32767, 2055: 0.5}, math.degrees(0.5)),
    ],
)
def test_angles_in_other_units_become_degrees(tmp_path: Path, keys: dict[int, Any], degrees: float) -> None:
    tags = {
        33550: (DOUBLE, [0.5 / degrees, 0.25 / degrees, 0.0]),
        33922: (DOUBLE, [0.0, 0.0, 0.0, 10.0 / degrees, 20.0 / degrees, 0.0]),
    }
    place = read_geotiff(
        TiffFile(rough(4, 5), keys={**WGS_84, **keys}, tags=tags).write(tmp_path)
    ).georeference
    assert place.first_x == pytest.approx(10.25)
    assert place.step_y == pytest.approx(0.25)


@pytest.mark.parametrize(
    ("code", "metres"),
    [
        ({3076: 9001}, 1.0),
        ({3076: 9002}, 0.3048),
        ({3076: 9003}, 1200 / 3937),
        ({3076: 32767, 3077: 2.5}, 2.5),
    ],
)
def test_maps_in_feet_become_metres(tmp_path: Path, code: dict[int, Any], metres: float) -> None:
    place = read_geotiff(TiffFile(rough(4, 5), keys={**METRES, **code}).write(tmp_path)).georeference
    assert place.first_x == pytest.approx(10.25 * metres)
    assert place.cell_size(4, 4) == pytest.approx((0.5 * metres, 0.25 * metres))
    assert not place.projection.in_degrees


def test_cells_of_degrees_are_narrower_away_from_the_equator(tmp_path: Path) -> None:
    tags = {33922: (DOUBLE, [0.0, 0.0, 0.0, 10.0, 60.5, 0.0])}
    layout = read_geotiff(TiffFile(rough(4, 5), tags=tags).write(tmp_path)).layout
    assert layout.cell_width == pytest.approx(0.5 * 55_800, rel=2e-3)
    assert layout.cell_height == pytest.approx(0.25 * 111_412, rel=2e-3)


@pytest.mark.parametrize(
    ("keys", "body", "semi_major"),
    [
        (
            {2048: 32767, 2049: "GCS Name = GCS_Mars_2000_Sphere", 2057: 3396190.0, 2059: 0.0},
            "Mars",
            3396190.0,
        ),
        ({2048: 32767, 2049: "Moon 2000", 2057: 1737400.0, 2058: 1737400.0}, "Moon", 1737400.0),
        ({2048: 32767, 2049: "somewhere", 2057: 3396190.0, 2058: 3376200.0}, "Mars", 3396190.0),
        ({2048: 32767, 2049: "Vesta", 2057: 255000.0, 2059: 0.0}, "Vesta", 255000.0),
        ({2048: 32767, 2057: 12345.0, 2059: 0.0}, "", 12345.0),
        ({2048: 4267}, "Earth", 6378206.4),
        ({2048: 4326}, "Earth", 6378137.0),
        ({2048: 32767, 2056: 7004}, "Earth", 6377397.155),
    ],
)
def test_bodies_and_their_ellipsoids(
    tmp_path: Path, keys: dict[int, Any], body: str, semi_major: float
) -> None:
    place = read_geotiff(TiffFile(rough(4, 5), keys={1024: 2, **keys}).write(tmp_path)).georeference
    assert (place.body, place.ellipsoid.semi_major) == (body, semi_major)
    is_sphere = keys.get(2059) == 0.0 or keys.get(2057) == keys.get(2058, "none")
    assert place.ellipsoid.is_sphere == is_sphere
    assert place.latitude_kind == ("planetocentric" if is_sphere else "planetographic")


@pytest.mark.parametrize(
    ("keys", "field"),
    [
        ({2057: -5.0}, "EllipsoidSemiMajorAxis"),
        ({2057: math.nan}, "EllipsoidSemiMajorAxis"),
        ({2057: 1e300}, "EllipsoidSemiMajorAxis"),
        ({2057: 6e6, 2058: 7e6}, "EllipsoidSemiMajorAxis"),
        ({2057: 6e6, 2059: 0.5}, "EllipsoidInvFlattening"),
        ({2054: 7}, "GeogAngularUnits"),
        ({2054: 32767, 2055: -1.0}, "GeogAngularUnitSize"),
        ({1024: 3}, "GTModelType"),
        ({1024: "text"}, "GTModelType"),
    ],
)
def test_keys_that_no_body_has_are_refused(tmp_path: Path, keys: dict[int, Any], field: str) -> None:
    error = refused(TiffFile(rough(4, 5), keys={**WGS_84, **keys}).write(tmp_path))
    assert error.field == field


@pytest.mark.parametrize(
    "directory", [[1], [2, 0, 0, 0], [1, 1, 0, 9, 1024, 0, 1, 2], [1, 1, 0, 1, 2057, 34736, 1, 9]]
)
def test_a_key_directory_that_contradicts_itself_is_refused(tmp_path: Path, directory: list[int]) -> None:
    error = refused(TiffFile(rough(4, 5), keys={}, tags={34735: (SHORT, directory)}).write(tmp_path))
    assert "GeoKey" in error.field


@pytest.mark.parametrize(
    ("code", "name", "body"),
    [
        (32633, "WGS 84 / UTM zone 33N", "Earth"),
        (32733, "WGS 84 / UTM zone 33S", "Earth"),
        (26910, "NAD83 / UTM zone 10N", "Earth"),
        (25832, "ETRS89 / UTM zone 32N", "Earth"),
        (3031, "WGS 84 / Antarctic Polar Stereographic", "Earth"),
        (3413, "WGS 84 / NSIDC Sea Ice Polar Stereographic North", "Earth"),
        (3857, "WGS 84 / Pseudo-Mercator", "Earth"),
        (5070, "NAD83 / Conus Albers", "Earth"),
    ],
)
def test_codes_of_projected_systems(tmp_path: Path, code: int, name: str, body: str) -> None:
    grid = read_geotiff(TiffFile(rough(4, 5), keys={1024: 1, 3072: code}).write(tmp_path))
    assert (grid.georeference.frame, grid.georeference.body) == (name, body)
    assert not grid.georeference.projection.in_degrees


def test_a_code_that_is_not_known_is_named_and_touch_is_right(tmp_path: Path) -> None:
    grid = read_geotiff(TiffFile(rough(4, 5), keys={1024: 1, 3072: 2056, 3076: 9001}).write(tmp_path))
    assert grid.georeference.projection.name == "unknown projection"
    assert any("EPSG:2056" in note for note in grid.notes)
    assert grid.layout.cell_width == 0.5


@pytest.mark.parametrize(
    ("keys", "reference", "unit", "scale"),
    [
        ({}, "not stated", "m", 1.0),
        ({4096: 5703, 4099: 9001}, "NAVD88", "m", 1.0),
        ({4096: 6360}, "NAVD88", "US survey foot", 1200 / 3937),
        ({4096: 5703, 4099: 9002}, "NAVD88", "ft", 0.3048),
        ({4096: 3855}, "EGM2008 geoid", "m", 1.0),
        ({4096: 32767, 4097: "areoid"}, "areoid", "m", 1.0),
        ({4096: 1234}, "EPSG:1234", "m", 1.0),
    ],
)
def test_heights_have_a_reference_and_a_unit(
    tmp_path: Path, keys: dict[int, Any], reference: str, unit: str, scale: float
) -> None:
    grid = read_geotiff(TiffFile([[10, 20], [30, 40]], keys={**WGS_84, **keys}).write(tmp_path))
    place = grid.georeference
    assert (place.vertical_reference, place.vertical_unit) == (reference, unit)
    assert grid.open().elevation(1, 0) == pytest.approx(20 * scale)


def test_scale_offset_and_unit_of_the_metadata_are_applied(tmp_path: Path) -> None:
    metadata = (
        '<GDALMetadata><Item name="OFFSET" sample="0" role="offset">100</Item>'
        '<Item name="SCALE" sample="0" role="scale">0.5</Item>'
        '<Item name="SCALE" sample="1" role="scale">77</Item>'
        "<Item role='unittype' sample='0' name='UNITTYPE'>ft</Item></GDALMetadata>"
    )
    grid = read_geotiff(TiffFile([[10, 20], [30, 40]], tags={42112: (ASCII, metadata)}).write(tmp_path))
    assert grid.open().elevation(1, 0) == pytest.approx((20 * 0.5 + 100) * 0.3048)
    assert grid.georeference.vertical_unit == "ft"


@pytest.mark.parametrize("scale", ["0", "nan", "much", "1e999"])
def test_a_scale_that_makes_no_heights_is_refused(tmp_path: Path, scale: str) -> None:
    metadata = f'<Item name="SCALE" sample="0" role="scale">{scale}</Item>'
    error = refused(TiffFile(rough(4, 5), tags={42112: (ASCII, metadata)}).write(tmp_path))
    assert error.field == "SCALE"


@pytest.mark.parametrize(
    ("sample", "text", "void", "height"),
    [
        ("i16", "-9999", -9999, 5),
        ("i16", " -9999.0 ", -9999, 5),
        ("f32", "-3.4028234663852886e+38", -3.4028234663852886e38, 5),
        ("f32", "-3.40282347e+38", -3.4028234663852886e38, 5),
        ("f32", "-3.4028235e+38", -3.4028234663852886e38, 5),
        ("f32", "0.1", 0.10000000149011612, 5),
        ("f32", "nan", math.nan, 5),
        ("f64", "-1.7976931348623157e+308", -1.7976931348623157e308, 5),
        ("u16", "65535", 65535, 5),
        ("u8", "0", 0, 5),
    ],
)
@pytest.mark.parametrize("compression", [1, 8])
def test_the_stated_value_for_missing_heights_is_a_hole(
    tmp_path: Path, sample: str, text: str, void: float, height: float, compression: int
) -> None:
    heights = [[height, void], [height, height]]
    file = TiffFile(heights, sample=sample, compression=compression, tags={42113: (ASCII, text)})
    assert read_back(read_geotiff(file.write(tmp_path))) == [[height, None], [height, height]]


@pytest.mark.parametrize("text", ["-3.40282e+38", "-3.402823e+38", "-3.4028e+38", "-3.4e+38"])
@pytest.mark.parametrize("compression", [1, 8])
def test_the_largest_number_written_with_few_digits_is_a_hole(
    tmp_path: Path, text: str, compression: int
) -> None:
    for void in (-3.4028234663852886e38, float(text)):
        heights = [[5.0, void], [-7.0, 5.0]]
        file = TiffFile(heights, sample="f32", compression=compression, tags={42113: (ASCII, text)})
        assert read_back(read_geotiff(file.write(tmp_path))) == [[5.0, None], [-7.0, 5.0]]


def test_tiles_that_were_left_out_are_holes_like_a_void_written_with_few_digits(tmp_path: Path) -> None:
    file = TiffFile(
        [[-3.4e38, 7.0, 5.0, 6.0]] * 4,
        sample="f32",
        compression=8,
        tile=(2, 4),
        absent=frozenset({1}),
        tags={42113: (ASCII, "-3.4e+38")},
    )
    assert read_back(read_geotiff(file.write(tmp_path)))[0] == [None, 7.0, None, None]


def test_a_void_beside_the_largest_number_that_is_written_out_is_what_it_is(tmp_path: Path) -> None:
    null, below = -3.4028226550889045e38, -3.4028234663852886e38
    file = TiffFile([[5.0, null], [below, 5.0]], sample="f32", tags={42113: (ASCII, repr(null))})
    assert read_back(read_geotiff(file.write(tmp_path)))[0] == [5.0, None]


@pytest.mark.parametrize(
    ("sample", "text"), [("u16", "-9999"), ("i16", "nan"), ("i16", "0.5"), ("u8", "1e9"), ("i16", "no")]
)
def test_a_stated_value_that_no_sample_has_hides_nothing(tmp_path: Path, sample: str, text: str) -> None:
    grid = read_geotiff(
        TiffFile([[0, 1], [2, 3]], sample=sample, tags={42113: (ASCII, text)}).write(tmp_path)
    )
    assert read_back(grid) == [[0, 1], [2, 3]]
    assert any("missing heights" in note for note in grid.notes)


@pytest.mark.parametrize("sample", ["i16", "i32", "f32", "f64"])
@pytest.mark.parametrize("void", [-32767, -32768, -9999])
@pytest.mark.parametrize("compression", [1, 8])
def test_customary_voids_that_the_file_does_not_state_are_holes_and_a_note_says_so(
    tmp_path: Path, sample: str, void: int, compression: int
) -> None:
    grid = read_geotiff(
        TiffFile([[void, 20], [30, void]], sample=sample, compression=compression).write(tmp_path)
    )
    assert read_back(grid) == [[None, 20], [30, None]]
    assert any(f"{void:g}" in note for note in grid.notes)


@pytest.mark.parametrize("compression", [1, 8])
@pytest.mark.parametrize(("tile", "rows_per_strip"), [(None, 1), (None, 3), (None, 400), ((16, 16), 0)])
@pytest.mark.parametrize("most", [8, 64, 500, 2_000])
def test_of_a_large_raster_bands_are_looked_at_and_a_note_says_so(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    most: int,
    tile: tuple[int, int] | None,
    rows_per_strip: int,
    compression: int,
) -> None:
    monkeypatch.setattr(geotiff_nodata, "MOST_LOOKED_AT", most)
    heights = [[-9999] + [5] * 3 for _ in range(700)]
    file = TiffFile(heights, compression=compression, tile=tile, rows_per_strip=rows_per_strip, keys=METRES)
    grid = read_geotiff(file.write(tmp_path))
    assert grid.open().elevation(0, 650) is None
    assert any("as far as was looked at" in note for note in grid.notes)


@pytest.mark.parametrize("void", [-3.4028234663852886e38, -999_999])
def test_customary_voids_of_floating_point_are_holes(tmp_path: Path, void: float) -> None:
    grid = read_geotiff(TiffFile([[void, 20], [30, void]], sample="f32").write(tmp_path))
    assert read_back(grid) == [[None, 20], [30, None]]


def test_a_trench_that_reaches_a_customary_value_is_no_hole(tmp_path: Path) -> None:
    heights = [[-9_999, -9_400, -8_700], [-9_990, -9_000, -10_910]]
    assert read_back(read_geotiff(TiffFile(heights).write(tmp_path))) == heights
    heights = [[-9_999, -9_400, -8_700], [-9_900, -9_000, 5]]
    assert read_back(read_geotiff(TiffFile(heights).write(tmp_path))) == heights


def test_a_customary_value_in_decimetres_is_judged_in_metres(tmp_path: Path) -> None:
    metadata = {42112: (ASCII, '<Item name="SCALE" sample="0" role="scale">0.1</Item>')}
    heights = [[-32_767, -25_000], [-20_000, -10_000]]
    grid = read_geotiff(TiffFile(heights, tags=metadata).write(tmp_path))
    assert grid.open().elevation(0, 0) == pytest.approx(-3276.7)


def test_tiles_that_were_left_out_are_holes(tmp_path: Path) -> None:
    heights = rough(8, 8)
    file = TiffFile(
        heights, compression=8, tile=(4, 4), absent=frozenset({1}), tags={42113: (ASCII, "-9999")}
    )
    assert read_back(read_geotiff(file.write(tmp_path)))[0] == [*heights[0][:4], None, None, None, None]


def test_a_file_without_georeference_is_a_metre_a_sample(tmp_path: Path) -> None:
    file = TiffFile(rough(4, 5), keys={}, tags={33550: None, 33922: None})
    grid = read_geotiff(file.write(tmp_path))
    assert (grid.layout.cell_width, grid.layout.cell_height) == (1.0, 1.0)
    assert grid.georeference.projection.name == "unknown projection"
    assert any("metre a sample is assumed" in note for note in grid.notes)


@pytest.mark.parametrize("name", ["grid.tfw", "GRID.TFW", "grid.tifw", "grid.wld"])
def test_a_world_file_beside_it_is_honoured(tmp_path: Path, name: str) -> None:
    file = TiffFile(rough(4, 5), keys={}, tags={33550: None, 33922: None})
    (tmp_path / name).write_text("30.0\r\n0.0\r\n0.0\r\n-20.0\r\n500015.0\r\n4999990.0\r\n", newline="")
    place = read_geotiff(file.write(tmp_path)).georeference
    assert (place.first_x, place.first_y, place.step_x, place.step_y) == (500_015, 4_999_990, 30, 20)


DEGREES_ALONE: dict[int, Any] = {
    33550: (DOUBLE, [0.000833333, 0.000833333, 0.0]),
    33922: (DOUBLE, [0.0, 0.0, 0.0, 7.0, 47.0, 0.0]),
}


@pytest.mark.parametrize("keys", [{}, {1025: 1}])
@pytest.mark.parametrize("from_world_file", [True, False])
def test_degrees_without_a_coordinate_system_are_assumed_and_a_note_says_so(
    tmp_path: Path, from_world_file: bool, keys: dict[int, Any]
) -> None:
    tags = {33550: None, 33922: None} if from_world_file else DEGREES_ALONE
    if from_world_file:
        (tmp_path / "grid.tfw").write_text("0.000833333\n0\n0\n-0.000833333\n7.0\n47.0\n")
    grid = read_geotiff(TiffFile(rough(4, 5), keys=keys, tags=tags).write(tmp_path))
    assert grid.layout.cell_height == pytest.approx(92.6, abs=0.1)
    assert grid.georeference.body == "Earth"
    place = grid.georeference.longitude_latitude(0.0, 0.0)
    assert place == pytest.approx((7.0, 47.0), abs=0.0005)
    assert any("WGS 84 are assumed" in note for note in grid.notes)


def test_metres_without_a_coordinate_system_are_assumed_and_a_note_says_so(tmp_path: Path) -> None:
    tags = {**DEGREES_ALONE, 33550: (DOUBLE, [30.0, 30.0, 0.0]), 33922: (DOUBLE, [0, 0, 0, 5e5, 5e6, 0])}
    grid = read_geotiff(TiffFile(rough(4, 5), keys={}, tags=tags).write(tmp_path))
    assert grid.layout.cell_height == 30.0
    assert grid.georeference.longitude_latitude(0.0, 0.0) is None
    assert any("metres of an unknown map" in note for note in grid.notes)


def test_a_prj_file_beside_a_raster_without_keys_is_followed(tmp_path: Path) -> None:
    (tmp_path / "grid.prj").write_text(
        'PROJCS["here",GEOGCS["x",DATUM["x",SPHEROID["WGS_1984",6378137.0,298.257223563]],'
        'PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],'
        'PARAMETER["Central_Meridian",9.0],PARAMETER["Latitude_Of_Origin",0.0],'
        'PARAMETER["Scale_Factor",1.0],UNIT["Foot",0.3048]]'
    )
    tags = {**DEGREES_ALONE, 33550: (DOUBLE, [30.0, 30.0, 0.0]), 33922: (DOUBLE, [0, 0, 0, -15, 15, 0])}
    grid = read_geotiff(TiffFile(rough(4, 5), keys={}, tags=tags).write(tmp_path))
    assert grid.layout.cell_width == pytest.approx(30.0 * 0.3048)
    assert grid.georeference.longitude_latitude(0.0, 0.0) == pytest.approx((9.0, 0.0), abs=1e-9)
    assert grid.georeference.frame == "here"


def test_the_keys_are_believed_before_a_prj_file(tmp_path: Path) -> None:
    (tmp_path / "grid.prj").write_text("Projection UTM\nZone 10\nDatum NAD27\nUnits METERS\n")
    assert read_geotiff(TiffFile(rough(4, 5)).write(tmp_path)).georeference.frame == "WGS 84"


@pytest.mark.parametrize(
    ("scale", "corner"),
    [(30.0, 1e300), (1e-20, 5e5), (1e300, 0.0), (30.0, -2e10)],
)
def test_metres_that_are_on_no_planet_or_lost_in_rounding_are_refused(
    tmp_path: Path, scale: float, corner: float
) -> None:
    tags = {33550: (DOUBLE, [scale, scale, 0.0]), 33922: (DOUBLE, [0, 0, 0, corner, 5e6, 0])}
    file = TiffFile(rough(4, 5), keys={1024: 1, 1025: 1, 3072: 32632}, tags=tags)
    assert refused(file.write(tmp_path)).field == "place of the grid"


def test_the_file_itself_is_believed_before_a_world_file(tmp_path: Path) -> None:
    (tmp_path / "grid.tfw").write_text("30\n0\n0\n-20\n500015\n4999990\n")
    assert read_geotiff(TiffFile(rough(4, 5)).write(tmp_path)).georeference.first_x == 10.25


@pytest.mark.parametrize(
    "text", ["", "1 2 3", "1\n0\n0\n-1\nnan\n5", "x\n" * 6, "1\n2\n2\n-1\n0\n0", "9" * 9000]
)
def test_a_world_file_that_is_none_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "grid.tfw").write_text(text)
    file = TiffFile(rough(4, 5), keys={}, tags={33550: None, 33922: None})
    assert refused(file.write(tmp_path)).field == "grid.tfw"


@pytest.mark.parametrize(
    ("code", "name"),
    [(50000, "ZSTD"), (7, "JPEG"), (34887, "LERC"), (34925, "LZMA"), (50001, "WebP"), (4242, "4242")],
)
def test_other_compressions_are_named_with_a_way_out(tmp_path: Path, code: int, name: str) -> None:
    file = TiffFile(rough(4, 5), tags={259: (SHORT, [code])})
    error = refused(file.write(tmp_path))
    assert error.field == "Compression"
    assert name in str(error)
    assert "gdal_translate" in str(error)


@pytest.mark.parametrize(
    ("tags", "found"),
    [
        ({339: (SHORT, [3])}, "floating point numbers of 16 bits"),
        ({258: (SHORT, [64]), 339: (SHORT, [2])}, "signed whole numbers of 64 bits"),
        ({258: (SHORT, [1]), 339: (SHORT, [1])}, "of 1 bits"),
        ({339: (SHORT, [6])}, "complex"),
    ],
)
def test_other_number_formats_are_refused(tmp_path: Path, tags: dict[int, Any], found: str) -> None:
    assert found in str(refused(TiffFile(rough(4, 5), tags=tags).write(tmp_path)))


@pytest.mark.parametrize(
    ("tags", "field"),
    [
        ({256: None}, "ImageWidth"),
        ({257: None}, "ImageLength"),
        ({256: (LONG, [0])}, "ImageWidth"),
        ({273: None}, "StripOffsets"),
        ({273: (LONG, [8])}, "StripOffsets"),
        ({278: (LONG, [0])}, "RowsPerStrip"),
        ({322: (LONG, [16])}, "TileLength"),
        ({277: (SHORT, [0])}, "SamplesPerPixel"),
        ({284: (SHORT, [9])}, "PlanarConfiguration"),
        ({266: (SHORT, [2])}, "FillOrder"),
        ({256: (ASCII, "wide")}, "ImageWidth"),
        ({257: (LONG, [4_000_000_000])}, "StripOffsets"),
    ],
)
def test_missing_and_absurd_tags_are_named(tmp_path: Path, tags: dict[int, Any], field: str) -> None:
    error = refused(TiffFile(rough(4, 5), tags=tags).write(tmp_path))
    assert error.field == field
    assert error.file.name == "grid.tif"


@pytest.mark.parametrize("compression", [1, 5, 8])
def test_sizes_that_the_file_cannot_hold_are_refused(tmp_path: Path, compression: int) -> None:
    high = {257: (LONG, [2_000_000_000]), 278: (LONG, [2_000_000_000])}
    file = TiffFile(rough(3, 5), compression=compression, tags=high)
    assert "strip 0" in refused(file.write(tmp_path)).field
    wide = TiffFile(rough(3, 5), compression=compression, tags={256: (LONG, [2_000_000_000])})
    assert refused(wide.write(tmp_path)).field == "row of samples"


def test_a_predictor_of_floating_point_for_whole_numbers_is_refused(tmp_path: Path) -> None:
    file = TiffFile(rough(4, 5), compression=8, tags={317: (SHORT, [3])})
    assert refused(file.write(tmp_path)).field == "Predictor"


@pytest.mark.parametrize("compression", [1, 5, 8, 32773])
@pytest.mark.parametrize("big", [False, True])
def test_a_file_cut_anywhere_is_refused_in_words(tmp_path: Path, compression: int, big: bool) -> None:
    whole = TiffFile(rough(6, 5), compression=compression, big=big).data()
    path = tmp_path / "cut.tif"
    for length in range(len(whole) - (8 if big else 4)):
        path.write_bytes(whole[:length])
        assert refused(path).file == path


def test_a_file_cut_after_its_directory_is_refused_in_words(tmp_path: Path) -> None:
    """The directory may come first: then the samples are what is missing."""
    file = TiffFile(rough(6, 5), rows_per_strip=2, tags={273: (LONG, [8, 28, 5000])})
    error = refused(file.write(tmp_path))
    assert error.field == "strip 2 (rows 4 to 5)"
    assert "cut short" in str(error)


@pytest.mark.parametrize("compression", [5, 8])
def test_damaged_samples_are_refused_when_they_are_opened(tmp_path: Path, compression: int) -> None:
    file = TiffFile(rough(6, 5), compression=compression, rows_per_strip=6, tags={42113: (ASCII, "-9999")})
    data = bytearray(file.data())
    data[8:14] = b"\xff" * 6
    path = tmp_path / "damaged.tif"
    path.write_bytes(data)
    with pytest.raises(FormatError, match=r"damaged\.tif"):
        read_geotiff(path).open()


def test_a_checksum_shows_damage_that_inflates_all_the_same(tmp_path: Path) -> None:
    file = TiffFile(rough(6, 5), compression=8, rows_per_strip=6, tags={42113: (ASCII, "-9999")})
    path = file.write(tmp_path)
    data = bytearray(path.read_bytes())
    numbers = GeoTiff.open(path).numbers(279)
    assert numbers is not None
    data[8 + int(numbers[0]) - 1] ^= 1
    path.write_bytes(data)
    with pytest.raises(FormatError, match="damaged data"):
        read_geotiff(path).open()


@pytest.mark.parametrize(
    ("name", "data", "found"),
    [
        ("empty.tif", b"", "an empty file"),
        ("page.tif", b"<!DOCTYPE html><html>not found</html>", "<!DO"),
        ("picture.tif", b"\x89PNG\r\n\x1a\n" + bytes(64), "PNG"),
        ("short.tif", b"II", "II"),
        ("odd.tif", b"II*\0\xff\xff\xff\xff", "directory"),
        ("none.tif", b"II*\0\x08\0\0\0\0\0\0\0\0\0", "0 entries"),
        ("big.tif", b"II+\0\x08\0\0\0\x10" + bytes(7) + b"\xff" * 8, "entries"),
        ("offsets.tif", b"II+\0\x04\0\0\0\x10" + bytes(40), "BigTIFF header"),
    ],
)
def test_other_files_are_refused_in_words(tmp_path: Path, name: str, data: bytes, found: str) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    assert found in str(refused(path))


@pytest.mark.parametrize("seed", range(15))
def test_a_damaged_file_is_read_or_refused_in_words(tmp_path: Path, seed: int) -> None:
    chance = random.Random(seed)
    path = tmp_path / "damaged.tif"
    for _ in range(10):
        file = TiffFile(
            rough(9, 8),
            compression=chance.choice([1, 5, 8, 32773]),
            tile=chance.choice([None, (4, 4)]),
            big=chance.random() < 0.3,
            order=chance.choice(["<", ">"]),
            keys={**WGS_84, 2049: "Mars", 2057: 3396190.0, 2059: 169.8, 4096: 5703},
            tags={42112: (ASCII, '<Item name="SCALE" sample="0" role="scale">0.5</Item>')},
        )
        data = bytearray(file.data())
        for _ in range(chance.randrange(1, 5)):
            place = chance.randrange(len(data))
            data[place : place + 4] = chance.choice([b"\xff\xff\xff\xff", bytes(4), chance.randbytes(4)])
        path.write_bytes(data)
        with contextlib.suppress(FormatError):
            grid = read_geotiff(path)
            if grid.layout.samples < 1 << 20:
                grid.open()


def test_folders_and_missing_files_are_refused_in_words(tmp_path: Path) -> None:
    assert "folder" in str(refused(tmp_path))
    assert "No such file" in str(refused(tmp_path / "none.tif"))
    assert refused(tmp_path / ("x" * 300 + ".tif")).field == "file"


def test_names_with_spaces_and_other_letters_are_read(tmp_path: Path) -> None:
    file = TiffFile(rough(4, 5), compression=8, name="Höhen der Erde 高さ.TIF")
    assert read_geotiff(file.write(tmp_path)).open().elevation(0, 0) == -2000


def test_a_single_row_makes_no_surface(tmp_path: Path) -> None:
    assert "rows is 1" in str(refused(TiffFile(rough(1, 5)).write(tmp_path)))


def test_bytes_tell_a_tiff_file_not_its_name() -> None:
    assert looks_like_tiff(TiffFile(rough(2, 2)).data())
    assert looks_like_tiff(TiffFile(rough(2, 2), order=">", big=True).data())
    assert not looks_like_tiff(b"II\x2a\x01")
    assert not looks_like_tiff(b"<html>")


def test_decoding_tells_how_far_it_has_come_and_ends_when_asked(tmp_path: Path) -> None:
    grid = read_geotiff(TiffFile(rough(6, 5), compression=8).write(tmp_path))
    progress = Progress()
    grid.open(progress)
    assert progress.share == 1.0
    progress.cancel()
    with pytest.raises(CancelledError):
        grid.open(progress)


def test_a_cache_file_has_the_same_samples(tmp_path: Path) -> None:
    heights = rough(6, 5)
    tiff = GeoTiff.open(TiffFile(heights, compression=8).write(tmp_path))
    layout = GridLayout(6, 5, cell_width=1, cell_height=1, byte_order="little")
    grid = tiff.decode(layout, cache=tmp_path / "cache")
    assert [[grid.elevation(column, row) for column in range(5)] for row in range(6)] == heights
    assert (tmp_path / "cache").stat().st_size == 60


@pytest.mark.parametrize(
    ("first_column", "first_row", "rows", "columns", "sample"),
    [(5, 0, 2, 2, "i16"), (0, 5, 2, 2, "i16"), (0, 0, 7, 2, "i16"), (0, 0, 2, 6, "i16"), (0, 0, 2, 2, "f32")],
)
def test_windows_off_the_raster_are_refused(
    tmp_path: Path, first_column: int, first_row: int, rows: int, columns: int, sample: Any
) -> None:
    tiff = GeoTiff.open(TiffFile(rough(6, 5)).write(tmp_path))
    layout = GridLayout(rows, columns, cell_width=1, cell_height=1, sample=sample)
    with pytest.raises(DecodeError):
        tiff.decode(layout, first_column, first_row)


@needs_crater_lake
def test_crater_lake_has_its_heights_place_and_holes() -> None:
    grid = read_geotiff(REAL)
    assert grid.decoding is None
    found = grid.open().range()
    assert found is not None
    assert (found.minimum, found.maximum, found.voids) == (1289, 1880, 39_489)
    assert grid.georeference.first_x == pytest.approx(-122.16544770319864, abs=1e-12)
    assert grid.georeference.first_y == pytest.approx(42.97931664484247, abs=1e-12)
    assert grid.georeference.registration == "points"
    assert any("-32767" in note for note in grid.notes)
