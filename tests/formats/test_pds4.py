"""PDS4 labels with raw arrays."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from addon.formats import read_grid
from addon.formats.projections import (
    LambertConformalConic,
    Mercator,
    PolarStereographic,
    Projection,
    TransverseMercator,
)
from tests.formats.raw_grids import EQUIRECTANGULAR, POLAR, Pds4Pair
from tests.formats.reading import complaint, heights, needs_raw_decoder

RADIUS = 1_737_400.0

EXPECTED = [[10, -20, 30], [40, None, 60]]


@pytest.mark.parametrize("chosen", ["grid.xml", "grid.img", "GRID.XML"])
def test_heights_and_places_are_those_of_the_label(tmp_path: Path, chosen: str) -> None:
    Pds4Pair().write(tmp_path)
    grid = read_grid(tmp_path / chosen)
    assert heights(grid) == EXPECTED
    assert grid.decoding is None
    place = grid.georeference
    assert (place.x(0), place.y(0)) == (10.5, 5.5)
    assert (place.x(2), place.y(1)) == (12.5, 4.5)
    assert (place.body, place.ellipsoid.semi_major) == ("Moon", RADIUS)


@pytest.mark.parametrize("array", ["Array_2D_Image", "Array_2D_Map", "Array_2D"])
def test_kinds_of_arrays(tmp_path: Path, array: str) -> None:
    assert heights(read_grid(Pds4Pair(array=array).write(tmp_path))) == EXPECTED


@pytest.mark.parametrize(
    ("data_type", "sample"),
    [
        ("SignedMSB2", ">h"),
        ("SignedLSB2", "<h"),
        ("UnsignedMSB2", ">H"),
        ("SignedMSB4", ">i"),
        ("SignedLSB4", "<i"),
        ("IEEE754MSBSingle", ">f"),
        ("IEEE754LSBSingle", "<f"),
        ("IEEE754MSBDouble", ">d"),
        ("IEEE754LSBDouble", "<d"),
    ],
)
def test_data_types_are_mapped(tmp_path: Path, data_type: str, sample: str) -> None:
    rows = [[1, 2, 3], [4, 40_000 if sample == ">H" else 4, 6]]
    grid = read_grid(Pds4Pair(rows, sample=sample, data_type=data_type).write(tmp_path))
    assert heights(grid) == rows
    assert grid.decoding is None


@pytest.mark.parametrize(("data_type", "sample"), [("UnsignedByte", "B"), ("UnsignedLSB4", "<I")])
@needs_raw_decoder
def test_other_data_types_are_decoded(tmp_path: Path, data_type: str, sample: str) -> None:
    rows = [[1, 2, 3], [4, 5, 6]]
    assert heights(read_grid(Pds4Pair(rows, sample=sample, data_type=data_type).write(tmp_path))) == rows


def test_factor_offset_and_kilometres(tmp_path: Path) -> None:
    element = "<unit>km</unit><scaling_factor>0.5</scaling_factor><value_offset>2</value_offset>"
    assert heights(read_grid(Pds4Pair(element=element).write(tmp_path)))[0] == [7000, -8000, 17_000]


def test_samples_may_begin_anywhere(tmp_path: Path) -> None:
    assert heights(read_grid(Pds4Pair(before=b"abc").write(tmp_path))) == EXPECTED


def test_axes_are_ordered_by_their_numbers(tmp_path: Path) -> None:
    axes = "".join(
        f"<Axis_Array><axis_name>{name}</axis_name><elements>{count}</elements>"
        f"<sequence_number>{number}</sequence_number></Axis_Array>"
        for name, count, number in (("Sample", 3, 2), ("Line", 2, 1))
    )
    assert heights(read_grid(Pds4Pair(axes=axes).write(tmp_path))) == EXPECTED


def test_samples_that_run_down_are_refused(tmp_path: Path) -> None:
    axes = "".join(
        f"<Axis_Array><axis_name>{name}</axis_name><elements>{count}</elements></Axis_Array>"
        for name, count in (("Sample", 3), ("Line", 2), ("Band", 1))
    )
    assert "sample x line x band" in complaint(Pds4Pair(axes=axes).write(tmp_path))


def test_an_equirectangular_map_is_placed_by_its_corner(tmp_path: Path) -> None:
    """At 60 degrees of true scale a degree of longitude has half the metres."""
    degree = math.radians(1.0) * RADIUS
    pair = Pds4Pair(
        projection=EQUIRECTANGULAR,
        resolution=f'<cart:pixel_resolution_x unit="km/pixel">{degree / 1000}</cart:pixel_resolution_x>'
        f'<cart:pixel_resolution_y unit="m/pixel">{degree}</cart:pixel_resolution_y>',
        corner=f'<cart:upperleft_corner_x unit="m">{10 * degree}</cart:upperleft_corner_x>'
        f'<cart:upperleft_corner_y unit="m">{6 * degree}</cart:upperleft_corner_y>',
    )
    place = read_grid(pair.write(tmp_path)).georeference
    assert place.step_x == pytest.approx(2.0)
    assert place.step_y == pytest.approx(1.0)
    assert place.x(0) == pytest.approx(180.0 + 20.0 + 1.0)
    assert place.y(0) == pytest.approx(5.5)


def test_the_units_tell_scale_from_resolution(tmp_path: Path) -> None:
    """Their names were exchanged between versions of the dictionary."""
    metres = '<cart:pixel_scale_x unit="m/pixel">240</cart:pixel_scale_x>'
    other = '<cart:pixel_resolution_x unit="pixel/deg">126</cart:pixel_resolution_x>'
    grid = read_grid(Pds4Pair(projection=POLAR, resolution=other + metres).write(tmp_path))
    assert grid.layout.cell_width == 240.0


def test_a_polar_map_is_in_metres(tmp_path: Path) -> None:
    pair = Pds4Pair(
        projection=POLAR,
        resolution='<cart:pixel_resolution_x unit="m/pixel">240</cart:pixel_resolution_x>',
        corner='<cart:upperleft_corner_x unit="m">-480</cart:upperleft_corner_x>'
        '<cart:upperleft_corner_y unit="km">0.48</cart:upperleft_corner_y>',
    )
    grid = read_grid(pair.write(tmp_path))
    assert (grid.layout.cell_width, grid.layout.cell_height) == (240.0, 240.0)
    place = grid.georeference
    assert (place.x(0), place.y(0)) == (-360.0, 360.0)
    found = place.longitude_latitude(0, 0)
    assert found is not None
    assert found[0] == pytest.approx(315.0)
    distance = math.hypot(360.0, 360.0)
    assert found[1] == pytest.approx(-90.0 + math.degrees(2.0 * math.atan(distance / 2.0 / RADIUS)), abs=1e-9)


PIXELS = '<cart:pixel_resolution_x unit="m/pixel">100000</cart:pixel_resolution_x>'
CORNER = (
    '<cart:upperleft_corner_x unit="m">-300000</cart:upperleft_corner_x>'
    '<cart:upperleft_corner_y unit="m">400000</cart:upperleft_corner_y>'
)


def stated_map(name: str, **numbers: float) -> Pds4Pair:
    elements = "".join(f"<cart:{field}>{number}</cart:{field}>" for field, number in numbers.items())
    projection = f"<cart:map_projection_name>{name}</cart:map_projection_name>{elements}"
    return Pds4Pair(projection=projection, resolution=PIXELS, corner=CORNER)


def test_an_origin_beside_the_pole_is_the_parallel_of_true_scale(tmp_path: Path) -> None:
    pair = stated_map("Polar Stereographic", latitude_of_projection_origin=-71)
    projection = read_grid(pair.write(tmp_path)).georeference.projection
    assert projection == PolarStereographic(latitude_of_origin=-90.0, standard_parallel_1=-71.0)


@pytest.mark.parametrize(
    ("name", "stated", "projection"),
    [
        (
            "Polar Stereographic",
            {"latitude_of_projection_origin": 90, "scale_factor_at_projection_origin": 0.994},
            PolarStereographic(scale_factor=0.994),
        ),
        (
            "Transverse Mercator",
            {"latitude_of_projection_origin": 10, "scale_factor_at_central_meridian": 0.9996},
            TransverseMercator(latitude_of_origin=10.0, scale_factor=0.9996),
        ),
        ("Mercator", {"standard_parallel_1": 30}, Mercator(standard_parallel_1=30.0)),
        ("Mercator", {"scale_factor_at_projection_origin": 0.9}, Mercator(scale_factor=0.9)),
        (
            "Lambert Conformal Conic",
            {"standard_parallel_1": 20, "standard_parallel_2": 50, "latitude_of_projection_origin": 30},
            LambertConformalConic(
                latitude_of_origin=30.0, standard_parallel_1=20.0, standard_parallel_2=50.0
            ),
        ),
        (
            "Lambert Conformal Conic",
            {"latitude_of_projection_origin": 30},
            LambertConformalConic(
                latitude_of_origin=30.0, standard_parallel_1=30.0, standard_parallel_2=30.0
            ),
        ),
    ],
)
def test_parallels_and_scale_factors_are_heeded(
    tmp_path: Path, name: str, stated: dict[str, float], projection: Projection
) -> None:
    grid = read_grid(stated_map(name, **stated).write(tmp_path))
    assert grid.georeference.projection == projection
    assert grid.notes == ()


@pytest.mark.parametrize("written", [0, -1])
def test_a_scale_factor_of_nothing_is_refused(tmp_path: Path, written: float) -> None:
    text = complaint(stated_map("Mercator", scale_factor_at_projection_origin=written).write(tmp_path))
    assert "scale_factor_at_projection_origin" in text


def test_another_projection_is_touched_in_metres(tmp_path: Path) -> None:
    projection = "<cart:map_projection_name>Bonne</cart:map_projection_name>"
    resolution = '<cart:pixel_resolution_x unit="m/pixel">60</cart:pixel_resolution_x>'
    grid = read_grid(Pds4Pair(projection=projection, resolution=resolution).write(tmp_path))
    assert grid.georeference.longitude_latitude(0, 0) is None
    assert "Bonne" in " ".join(grid.notes)


def test_a_void_written_as_bits(tmp_path: Path) -> None:
    largest = -3.4028226550889045e38
    pair = Pds4Pair(
        [[1, largest, 3], [4, 5, 6]],
        sample="<f",
        data_type="IEEE754LSBSingle",
        constants="<missing_constant>16#FF7FFFFB#</missing_constant>",
    )
    assert heights(read_grid(pair.write(tmp_path)))[0] == [1, None, 3]


@pytest.mark.parametrize("written", ["16#8000#", "0x8000", "16#FFFF8000#", "0xffffffffffff8000", "-32768"])
def test_a_void_of_whole_numbers_written_as_bits(tmp_path: Path, written: str) -> None:
    pair = Pds4Pair(constants=f"<missing_constant>{written}</missing_constant>")
    grid = read_grid(pair.write(tmp_path))
    assert heights(grid) == EXPECTED
    found = grid.open().range()
    assert found is not None
    assert found.minimum == -20


def test_bits_of_samples_without_a_sign(tmp_path: Path) -> None:
    rows = [[1, 0x8000, 3], [4, 5, 6]]
    constants = "<missing_constant>16#8000#</missing_constant>"
    pair = Pds4Pair(rows, sample=">H", data_type="UnsignedMSB2", constants=constants)
    assert heights(read_grid(pair.write(tmp_path)))[0] == [1, None, 3]


def test_the_bits_of_a_double(tmp_path: Path) -> None:
    rows: list[list[float]] = [[1, -1.7976931348623149e308, 3], [4, 5, 6]]
    constants = "<missing_constant>16#FFEFFFFFFFFFFFFB#</missing_constant>"
    pair = Pds4Pair(rows, sample=">d", data_type="IEEE754MSBDouble", constants=constants)
    assert heights(read_grid(pair.write(tmp_path)))[0] == [1, None, 3]


@pytest.mark.parametrize("written", ["16#18000#", "0xFFFF7FFF", f"0x{'F' * 5000}"])
def test_bits_that_no_sample_has_are_refused(tmp_path: Path, written: str) -> None:
    pair = Pds4Pair(constants=f"<missing_constant>{written}</missing_constant>")
    text = complaint(pair.write(tmp_path))
    for word in ("missing_constant", written[:20], "the 16 bits of a sample"):
        assert word in text


@pytest.mark.parametrize(
    "name", ["../grid.img", "/etc/passwd", "sub/grid.img", "C:grid.img", "..", "g" * 300]
)
def test_a_file_outside_the_folder_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path.parent / "grid.img").write_bytes(bytes(12))
    text = complaint(Pds4Pair(file_name=name).write(tmp_path))
    assert "grid.xml: file_name" in text
    assert "bare name" in text


BOMB = """<!DOCTYPE Product_Observational [
<!ENTITY a "aaaaaaaaaaaaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">
<!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;"><!ENTITY d "&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;">]>"""


@pytest.mark.parametrize(
    "head", [BOMB, '<!DOCTYPE a SYSTEM "file:///etc/passwd">', '<?xml version="1.0"?>\n<!DOCTYPE a>']
)
def test_entities_are_never_followed(tmp_path: Path, head: str) -> None:
    assert "document type" in complaint(Pds4Pair(head=head, element="<unit>&d;</unit>").write(tmp_path))


def test_a_label_of_megabytes_is_not_followed(tmp_path: Path) -> None:
    label = Pds4Pair(rest=f"<!--{'x' * (4 << 20)}-->").write(tmp_path)
    assert "more than 4,194,304 bytes" in complaint(label)


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"data_type": "ComplexMSB8"}, ["data_type", "ComplexMSB8", "SignedMSB2"]),
        ({"element": "<unit>DN</unit>"}, ["unit", "dn", "m or km"]),
        ({"element": "<scaling_factor>0</scaling_factor>"}, ["grid", "scale"]),
        ({"element": "<scaling_factor>1e400</scaling_factor>"}, ["scaling_factor", "1e400"]),
        ({"constants": "<missing_constant>many</missing_constant>"}, ["missing_constant", "many"]),
        ({"direction": "Positive West"}, ["longitude_direction", "Positive West"]),
        (
            {"axes": "<Axis_Array><axis_name>Line</axis_name><elements>2</elements></Axis_Array>"},
            ["Axis_Array"],
        ),
        ({"array": "Table_Binary"}, ["Array_2D_Image", "no array"]),
        ({"file_name": "missing.img"}, ["file_name", "missing.img"]),
        ({"projection": POLAR, "resolution": ""}, ["pixel_resolution_x"]),
        (
            {"projection": POLAR, "resolution": '<cart:pixel_scale_x unit="m/pixel">-1</cart:pixel_scale_x>'},
            ["pixel_scale_x", "above 0"],
        ),
    ],
)
def test_a_label_that_cannot_be_used(tmp_path: Path, change: dict[str, str], named: list[str]) -> None:
    text = complaint(Pds4Pair(**change).write(tmp_path))  # type: ignore[arg-type]
    for word in ("grid.xml", *named):
        assert word in text


@pytest.mark.parametrize(
    ("elements", "named"),
    [
        ("1", "at least 2"),
        ("-2", "whole"),
        ("1000000000000", "1,000,000,000,000"),
        ("1e300", "whole"),
        ("x", "a number"),
    ],
)
def test_absurd_sizes(tmp_path: Path, elements: str, named: str) -> None:
    axes = "".join(
        f"<Axis_Array><axis_name>{name}</axis_name><elements>{elements}</elements></Axis_Array>"
        for name in ("Line", "Sample")
    )
    assert named in complaint(Pds4Pair(axes=axes).write(tmp_path))


def test_data_cut_short(tmp_path: Path) -> None:
    label = Pds4Pair().write(tmp_path)
    label.with_suffix(".img").write_bytes(bytes(11))
    assert "grid.img: length: found 11 bytes, expected 12 bytes" in complaint(label)


@pytest.mark.parametrize("length", range(1, 1900, 61))
def test_a_label_cut_anywhere(tmp_path: Path, length: int) -> None:
    label = Pds4Pair().write(tmp_path)
    label.write_bytes(label.read_bytes()[:length])
    assert "grid.xml" in complaint(label)
