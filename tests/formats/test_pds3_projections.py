"""Places of PDS3 images that are no cylindrical maps from limits.

The polar catalogue files of both data sets (DSMAP_POLAR.CAT) state, for sample I and line J from 1,
X = I - N/2 - 0.5, Y = J - N/2 - 0.5, and latitudes from the distance: the oracle here.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from addon.formats import read_grid
from addon.formats.projections import LambertConformalConic
from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.reading import complaint, heights

POLAR = '"POLAR STEREOGRAPHIC"'


def polar(size: int, resolution: float, pole: int, **projection: object) -> MegdrPair:
    """A square map around a pole as MOLA has them."""
    return MegdrPair(
        rough(size, size),
        image={"SAMPLE_TYPE": "MSB_UNSIGNED_INTEGER", "SCALING_FACTOR": 0.25, "OFFSET": -8000},
        sample=">H",
        projection={
            "MAP_PROJECTION_TYPE": POLAR,
            "MAP_RESOLUTION": f"{resolution} <PIXEL/DEGREE>",
            "MAP_SCALE": None,
            "A_AXIS_RADIUS": "3396.0 <KM>",
            "C_AXIS_RADIUS": "3376.2 <KM>",
            "CENTER_LATITUDE": f"{pole} <DEGREE>",
            "CENTER_LONGITUDE": "0 <DEGREE>",
            "LINE_PROJECTION_OFFSET": size / 2 + 0.5,
            "SAMPLE_PROJECTION_OFFSET": size / 2 + 0.5,
            "MINIMUM_LATITUDE": 60 if pole > 0 else -90,
            "MAXIMUM_LATITUDE": 90 if pole > 0 else -60,
            "WESTERNMOST_LONGITUDE": 0,
            "EASTERNMOST_LONGITUDE": 360,
            **projection,
        },
    )


def unsigned(pair: MegdrPair) -> MegdrPair:
    """The same pair with samples of 0 to 4000."""
    return replace(pair, heights=[[value + 2000 for value in row] for row in pair.heights])


def catalogue(i: int, j: int, size: int, resolution: float, pole: int) -> tuple[float, float]:
    """Longitude and latitude of a sample as MOLA's DSMAP_POLAR.CAT computes them (I, J from 1)."""
    x, y = (i - size / 2 - 0.5) / resolution, (j - size / 2 - 0.5) / resolution
    latitude = 90.0 - math.degrees(2.0 * math.atan(math.hypot(x, y) * math.pi / 360.0))
    longitude = math.degrees(math.atan2(x, y if pole > 0 else -y)) % 360.0
    return longitude, latitude if pole > 0 else -latitude


@pytest.mark.parametrize("pole", [90, -90])
def test_polar_maps_agree_with_the_catalogue(tmp_path: Path, pole: int) -> None:
    grid = read_grid(unsigned(polar(6, 2.0, pole)).write(tmp_path))
    for column, row in ((0, 0), (5, 0), (0, 5), (3, 1), (2, 4)):
        found = grid.georeference.longitude_latitude(column, row)
        assert found == pytest.approx(catalogue(column + 1, row + 1, 6, 2.0, pole), abs=1e-9)


def test_polar_samples_are_unsigned_quarter_metres(tmp_path: Path) -> None:
    pair = replace(polar(2, 512.0, 90), heights=[[0, 32_000], [40_000, 65_535]])
    grid = read_grid(pair.write(tmp_path))
    assert heights(grid) == [[-8000, 0], [2000, 8383.75]]
    assert grid.decoding is None
    assert grid.layout.cell_width == pytest.approx(115.09, abs=0.005)  # as the catalogue says
    assert grid.layout.cell_width == grid.layout.cell_height


@pytest.mark.parametrize(
    ("size", "resolution", "latitude"), [(10_240, 128.0, -37.4532), (12_288, 512.0, -73.1519)]
)
def test_the_first_pixel_lies_where_the_labels_say(
    tmp_path: Path, size: int, resolution: float, latitude: float
) -> None:
    """MEGR_S_128.LBL: "The first pixel lies at 37.4532S, 315E."; MEGR_S_512.LBL: 73.1519S, 315E.

    By the catalogue's equations that is the pixel's outer corner.
    """
    label = unsigned(polar(2, resolution, -90)).write(tmp_path)
    text = label.read_text()
    for keyword in ("LINES = 2", "LINE_SAMPLES = 2"):
        text = text.replace(keyword, keyword.replace("2", str(size)))
    label.write_text(text.replace("OFFSET = 1.5", f"OFFSET = {size / 2 + 0.5}"))
    with label.with_suffix(".img").open("r+b") as file:
        file.truncate(2 * size * size)
    found = read_grid(label).georeference.longitude_latitude(-0.5, -0.5)
    assert found is not None
    assert found[0] == pytest.approx(315.0)
    assert found[1] == pytest.approx(latitude, abs=5e-5)


def test_a_map_of_lola_ends_where_its_catalogue_says(tmp_path: Path) -> None:
    """DSMAP_POLAR.CAT: the 60 degree map extends "to latitude 48.48755 degrees at the corners and to 59.996
    degrees at the edges"; at 240 m that is 7760 samples.
    """
    pair = polar(2, 1.0, 90, MAP_RESOLUTION="126.347 <pix/deg>", MAP_SCALE="240 <m/pix>")
    pair.projection = {**pair.projection, "A_AXIS_RADIUS": "1737.4 <km>", "C_AXIS_RADIUS": "1737.4 <km>"}
    label = unsigned(pair).write(tmp_path)
    text = label.read_text().replace("LINES = 2", "LINES = 7760").replace("SAMPLES = 2", "SAMPLES = 7760")
    label.write_text(text.replace("OFFSET = 1.5", "OFFSET = 3879.5"))
    with label.with_suffix(".img").open("r+b") as file:
        file.truncate(2 * 7760 * 7760)
    place = read_grid(label).georeference
    corner, edge = place.longitude_latitude(-0.5, -0.5), place.longitude_latitude(-0.5, 3879.5)
    assert corner is not None
    assert edge is not None
    assert corner[1] == pytest.approx(48.48755, abs=5e-6)
    assert edge[1] == pytest.approx(59.996, abs=5e-4)


@pytest.mark.parametrize("offset", [2.5, 3.0, 3.5, None])
def test_the_pole_is_in_the_middle_however_lines_are_counted(tmp_path: Path, offset: float | None) -> None:
    """MOLA counts lines from 1, LOLA from 0, and half a cell is disputed."""
    pair = polar(6, 2.0, 90, LINE_PROJECTION_OFFSET=offset, SAMPLE_PROJECTION_OFFSET=offset)
    place = read_grid(unsigned(pair).write(tmp_path)).georeference
    assert place.x(2.5) == pytest.approx(0.0, abs=1e-6)
    assert place.y(2.5) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(
    ("data_set", "offset"), [("MGS-M-MOLA-5-MEGDR-L3-V1.0", 100.5), ("LRO-L-LOLA-4-GDR-V1.0", 99.5)]
)
def test_a_tile_beside_the_pole_is_counted_as_its_team_does(
    tmp_path: Path, data_set: str, offset: float
) -> None:
    pair = polar(6, 2.0, 90, SAMPLE_PROJECTION_OFFSET=offset)
    pair.header = {"DATA_SET_ID": f'"{data_set}"'}
    place = read_grid(unsigned(pair).write(tmp_path)).georeference
    assert place.x(99.5) == pytest.approx(0.0, abs=1e-6)


def test_lolas_scale_is_exact_and_its_resolution_is_not(tmp_path: Path) -> None:
    pair = polar(
        6,
        126.3475,
        -90,
        MAP_SCALE="240. <METERS/PIXEL>",
        A_AXIS_RADIUS="1737.4 <km>",
        C_AXIS_RADIUS="1737.4 <km>",
        MAP_RESOLUTION="126.34754  <pix/deg>",
    )
    assert read_grid(unsigned(pair).write(tmp_path)).layout.cell_width == 240.0


@pytest.mark.parametrize(
    ("written", "metres"), [("0.24 <KM/PIX>", 240.0), ("0.24", 240.0), ("240 <M/PIXEL>", 240.0)]
)
def test_units_of_the_scale(tmp_path: Path, written: str, metres: float) -> None:
    pair = polar(6, 1.0, -90, MAP_RESOLUTION=None, MAP_SCALE=written)
    assert read_grid(unsigned(pair).write(tmp_path)).layout.cell_width == metres


def test_scale_and_resolution_that_contradict_are_refused(tmp_path: Path) -> None:
    text = complaint(unsigned(polar(6, 512.0, -90, MAP_SCALE="0.240 <KM/PIXEL>")).write(tmp_path))
    for word in ("MAP_SCALE", "240 m", "115.0"):
        assert word in text


def test_a_polar_map_of_real_numbers(tmp_path: Path) -> None:
    rows = [[3376200, 3376201], [3376202, 3376203]]
    image = {"SAMPLE_TYPE": "IEEE_REAL", "SAMPLE_BITS": 32, "NAME": "MEAN_SHAPE", "UNIT": "METER"}
    grid = read_grid(replace(polar(2, 512.0, -90), heights=rows, image=image, sample=">f").write(tmp_path))
    assert heights(grid) == rows
    assert grid.georeference.vertical_reference == "centre of the body"


@pytest.mark.parametrize(
    ("projection", "named"),
    [
        ({"CENTER_LATITUDE": 45}, ["CENTER_LATITUDE", "45", "90 or -90"]),
        ({"C_AXIS_RADIUS": -1}, ["C_AXIS_RADIUS", "above 0"]),
        ({"MAP_RESOLUTION": None}, ["MAP_SCALE"]),
        ({"MAP_RESOLUTION": -2}, ["MAP_RESOLUTION", "above 0"]),
        ({"MAP_SCALE": 0}, ["MAP_SCALE", "above 0"]),
        ({"MAP_SCALE": "1 <MILE>"}, ["MAP_SCALE", "MILE"]),
        ({"LINE_PROJECTION_OFFSET": "1e400"}, ["LINE_PROJECTION_OFFSET"]),
        ({"CENTER_LONGITUDE": "1 <HOUR>"}, ["CENTER_LONGITUDE", "HOUR"]),
    ],
)
def test_a_polar_map_that_cannot_be_used(
    tmp_path: Path, projection: dict[str, object], named: list[str]
) -> None:
    text = complaint(unsigned(polar(6, 2.0, 90, **projection)).write(tmp_path))
    for word in named:
        assert word in text


def equirectangular(**projection: object) -> MegdrPair:
    """A map as HiRISE's terrain models have them: true to scale at 60 degrees, placed by its offsets."""
    return MegdrPair(
        rough(4, 6),
        header={"DATA_SET_ID": '"MRO-M-HIRISE-5-DTM-V1.0"'},
        projection={
            "MAP_PROJECTION_TYPE": '"EQUIRECTANGULAR"',
            "MAP_RESOLUTION": "100.5 <PIX/DEG>",
            "MAP_SCALE": f"{math.radians(1 / 100.5) * 3396000.0!r} <METERS/PIXEL>",
            "CENTER_LATITUDE": "60.0 <DEG>",
            "CENTER_LONGITUDE": "180.0 <DEG>",
            "LINE_PROJECTION_OFFSET": "6029.5 <PIXEL>",
            "SAMPLE_PROJECTION_OFFSET": "-1000.0 <PIXEL>",
            "MAXIMUM_LATITUDE": 60.0,
            "MINIMUM_LATITUDE": 59.9,
            **projection,
        },
    )


def test_equirectangular_maps_are_placed_by_their_offsets(tmp_path: Path) -> None:
    """Offsets count from the first line (from 0); at 60 degrees a degree of longitude is half as long."""
    place = read_grid(equirectangular().write(tmp_path)).georeference
    assert place.y(0) == pytest.approx(6029.5 / 100.5)
    assert place.x(0) == pytest.approx(180.0 + 1000.0 * 2.0 / 100.5)
    assert place.step_x == pytest.approx(2.0 * place.step_y)
    assert place.cell_size(4, 4)[0] == pytest.approx(place.cell_size(4, 4)[1], rel=2e-3)


def test_a_rounded_scale_still_closes_a_planet(tmp_path: Path) -> None:
    pair = equirectangular(
        MAP_RESOLUTION=None,
        MAP_SCALE="148180 <METERS/PIXEL>",
        CENTER_LATITUDE=0,
        LINE_PROJECTION_OFFSET=1.5,
        SAMPLE_PROJECTION_OFFSET=71.5,
    )
    pair.heights = rough(4, 144)
    grid = read_grid(pair.write(tmp_path))
    assert grid.layout.wraps
    assert grid.georeference.x(0) == pytest.approx(1.25)


@pytest.mark.parametrize("field", ["CENTER_LATITUDE", "LINE_PROJECTION_OFFSET"])
def test_latitudes_beyond_the_poles_are_refused(tmp_path: Path, field: str) -> None:
    assert field in complaint(equirectangular(**{field: 90000}).write(tmp_path))


@pytest.mark.parametrize(("written", "told"), [("0.0", False), ("'N/A'", False), ("90.0 <DEG>", True)])
def test_a_turned_map_says_so(tmp_path: Path, written: str, told: bool) -> None:
    pair = MegdrPair(rough(4, 6), projection={"MAP_PROJECTION_ROTATION": written})
    assert ("turned by 90" in " ".join(read_grid(pair.write(tmp_path)).notes)) == told


def test_another_projection_is_touched_in_metres(tmp_path: Path) -> None:
    grid = read_grid(equirectangular(MAP_PROJECTION_TYPE="BONNE").write(tmp_path))
    assert grid.georeference.longitude_latitude(0, 0) is None
    assert "Bonne" in " ".join(grid.notes)


def test_a_sinusoidal_map(tmp_path: Path) -> None:
    """HRSC's terrain models: x = R (lon - lon0) cos(lat), y = R lat, offsets counted from 0."""
    pair = equirectangular(
        MAP_PROJECTION_TYPE='"SINUSOIDAL"',
        MAP_RESOLUTION=None,
        MAP_SCALE="0.1 <KM/PIXEL>",
        LINE_PROJECTION_OFFSET=20_000.0,
        SAMPLE_PROJECTION_OFFSET=-3000.0,
        CENTER_LATITUDE=0,
    )
    grid = read_grid(pair.write(tmp_path))
    found = grid.georeference.longitude_latitude(0, 0)
    assert found is not None
    latitude = math.degrees(2_000_000.0 / 3_396_000.0)
    longitude = 180.0 + math.degrees(300_000.0 / 3_396_000.0 / math.cos(math.radians(latitude)))
    assert found == pytest.approx((longitude, latitude), abs=1e-9)
    assert grid.layout.cell_width == 100.0


def test_a_cone_has_the_parallels_of_its_label(tmp_path: Path) -> None:
    pair = equirectangular(
        MAP_PROJECTION_TYPE='"LAMBERT CONFORMAL CONIC"',
        CENTER_LATITUDE=30,
        FIRST_STANDARD_PARALLEL="20 <DEG>",
        SECOND_STANDARD_PARALLEL="50 <DEG>",
    )
    assert read_grid(pair.write(tmp_path)).georeference.projection == LambertConformalConic(
        central_longitude=180.0,
        latitude_of_origin=30.0,
        standard_parallel_1=20.0,
        standard_parallel_2=50.0,
    )


@pytest.mark.parametrize(
    ("told", "kind"), [("PLANETOGRAPHIC", "planetographic"), ("PLANETOCENTRIC", "planetocentric")]
)
def test_the_kind_of_latitude_is_kept(tmp_path: Path, told: str, kind: str) -> None:
    pair = MegdrPair(rough(4, 6), projection={"COORDINATE_SYSTEM_NAME": f'"{told}"', "C_AXIS_RADIUS": 3376.2})
    place = read_grid(pair.write(tmp_path)).georeference
    assert place.latitude_kind == kind
    assert place.ellipsoid.is_sphere == (kind == "planetocentric")
