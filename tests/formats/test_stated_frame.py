"""What ``.prj`` files state."""

from __future__ import annotations

import pytest

from addon.formats.body.datums import CLARKE_1866, WGS84
from addon.formats.frames.stated_frame import stated_frame
from addon.formats.frames.wkt import WktError, parse_wkt
from addon.formats.projections import KINDS, Geographic, Unknown

GEOGRAPHIC = (
    'GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],'
    'PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]]'
)

MERCATOR = (
    f'PROJCS["NAD_UTM_10N",{GEOGRAPHIC},PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],'
    'PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",-123.0],PARAMETER["Scale_Factor",0.9996],'
    'PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]]'
)

needs_mercator = pytest.mark.skipif(
    "transverse Mercator" not in KINDS, reason="transverse Mercator is not there yet"
)
needs_stereographic = pytest.mark.skipif(
    "polar stereographic" not in KINDS, reason="polar stereographic is not there yet"
)


@pytest.mark.parametrize(
    "text", [GEOGRAPHIC, GEOGRAPHIC.replace(",", ",\r\n  "), GEOGRAPHIC.lower(), GEOGRAPHIC + "\0"]
)
def test_longitude_and_latitude(text: str) -> None:
    frame = stated_frame(text)
    assert frame is not None
    assert isinstance(frame.projection, Geographic)
    assert frame.ellipsoid == WGS84
    assert (frame.body, frame.unit, frame.shift_x) == ("Earth", 1.0, 0.0)


def test_round_brackets_and_compound_systems() -> None:
    frame = stated_frame(
        f'COMPD_CS("both",{GEOGRAPHIC.replace("[", "(").replace("]", ")")},VERT_CS("heights"))'
    )
    assert frame is not None
    assert frame.name == "GCS_WGS_1984"


@pytest.mark.parametrize(
    ("name", "axis", "body"),
    [
        ("GCS_Mars_2000", 3_396_190.0, "Mars"),
        ("D_Moon_2000", 1_737_400.0, "Moon"),
        ("nameless", 3_396_000.0, "Mars"),
        ("nameless", 6_370_000.0, "Earth"),
        ("nameless", 1000.0, ""),
    ],
)
def test_bodies(name: str, axis: float, body: str) -> None:
    frame = stated_frame(f'GEOGCS["{name}",DATUM["d",SPHEROID["s",{axis},0.0]],UNIT["degree",0.0174532925]]')
    assert frame is not None
    assert frame.body == body
    assert frame.ellipsoid.is_sphere
    assert frame.unit == 1.0


def test_grads_from_paris() -> None:
    text = GEOGRAPHIC.replace("0.0174532925199433", "0.01570796326794897").replace(
        '"Greenwich",0.0', '"Paris",2.5969213'
    )
    frame = stated_frame(text)
    assert frame is not None
    assert frame.unit == pytest.approx(0.9, rel=1e-12)
    assert frame.shift_x == pytest.approx(2.33722917, abs=1e-8)


@needs_mercator
def test_transverse_mercator() -> None:
    frame = stated_frame(MERCATOR)
    assert frame is not None
    assert frame.name == "NAD_UTM_10N"
    place = frame.projection.inverse(500_000.0, 0.0, frame.ellipsoid)
    assert place == pytest.approx((-123.0, 0.0), abs=1e-9)


@needs_mercator
def test_a_map_in_feet() -> None:
    text = MERCATOR.replace('UNIT["Meter",1.0]', 'UNIT["Foot_US",0.3048006096012192]').replace(
        "500000.0", "1640416.667"
    )
    frame = stated_frame(text)
    assert frame is not None
    assert frame.unit == 0.3048006096012192
    place = frame.projection.inverse(500_000.0, 0.0, frame.ellipsoid)
    assert place == pytest.approx((-123.0, 0.0), abs=1e-6)


@needs_stereographic
@pytest.mark.parametrize(
    ("method", "parameter", "side"),
    [
        ("Polar_Stereographic", '"latitude_of_origin",71', 90.0),
        ("Polar_Stereographic", '"latitude_of_origin",-90', -90.0),
        ("Stereographic_North_Pole", '"Standard_Parallel_1",70', 90.0),
        ("Stereographic_South_Pole", '"Standard_Parallel_1",-71', -90.0),
    ],
)
def test_polar_stereographic(method: str, parameter: str, side: float) -> None:
    frame = stated_frame(
        f'PROJCS["p",{GEOGRAPHIC},PROJECTION["{method}"],PARAMETER[{parameter}],'
        'PARAMETER["central_meridian",0],UNIT["m",1]]'
    )
    assert frame is not None
    place = frame.projection.inverse(0.0, 0.0, frame.ellipsoid)
    assert place is not None
    assert place[1] == side


def test_a_projection_that_is_not_known_is_told() -> None:
    frame = stated_frame(MERCATOR.replace("Transverse_Mercator", "Krovak"))
    assert frame is not None
    assert isinstance(frame.projection, Unknown)
    assert any("Krovak" in note for note in frame.notes)


def test_keywords_as_of_gtopo30() -> None:
    frame = stated_frame(
        "Projection    GEOGRAPHIC\r\nDatum         WGS84\r\nZunits        METERS\r\nUnits         DD\r\n"
        "Spheroid      WGS84\r\nXshift        0.0000000000\r\nYshift        0.0000000000\r\nParameters\r\n"
    )
    assert frame is not None
    assert isinstance(frame.projection, Geographic)
    assert (frame.ellipsoid, frame.unit, frame.vertical_unit) == (WGS84, 1.0, 1.0)


def test_keywords_of_other_datums() -> None:
    frame = stated_frame("Projection GEOGRAPHIC\nDatum ED50\nUnits DD\n")
    assert frame is not None
    assert frame.ellipsoid.semi_major == 6_378_388.0
    assert stated_frame("Projection GEOGRAPHIC\nDatum ARRAKIS\nUnits DD\n") is None


def test_keywords_of_utm_in_feet() -> None:
    frame = stated_frame(
        "projection utm\nzone 10\nspheroid clarke1866\nunits feet\nzunits feet\nparameters\n"
    )
    assert frame is not None
    assert frame.ellipsoid == CLARKE_1866
    assert frame.unit == pytest.approx(0.3048006096)
    assert frame.vertical_unit == 0.3048


@pytest.mark.parametrize(
    "text",
    [
        "",
        "hello",
        "<html>",
        "GEOGCS",
        'GEOGCS["x"]',
        GEOGRAPHIC[:-1],
        GEOGRAPHIC + "]",
        GEOGRAPHIC * 2,
        GEOGRAPHIC.replace("6378137.0", "nan"),
        GEOGRAPHIC.replace("6378137.0", "-1"),
        GEOGRAPHIC.replace("6378137.0", "1e300"),
        GEOGRAPHIC.replace("298.257223563", "0.5"),
        GEOGRAPHIC.replace("0.0174532925199433", "0"),
        GEOGRAPHIC.replace("0.0174532925199433", "inf"),
        GEOGRAPHIC.replace('"Greenwich",0.0', '"Greenwich",1e300'),
        'GEOGCS["an end that is not there',
        "A[" * 5000,
        "A[" * 5000 + "]" * 5000,
        "[]",
        '"text"',
        "A" * 100_000,
        'LOCAL_CS["x",UNIT["m",1]]',
        "Projection UTM\nZone 10\nDatum NOWHERE\n",
        "Projection GEOGRAPHIC\nUnits FURLONGS\n",
    ],
)
def test_what_is_not_understood(text: str) -> None:
    assert stated_frame(text) is None


def test_parameters_that_are_absurd_make_a_map_without_places() -> None:
    text = MERCATOR.replace("-123.0", "1e300").replace("0.9996", "nan")
    frame = stated_frame(text)
    assert frame is not None
    frame.projection.inverse(500_000.0, 0.0, frame.ellipsoid)


def test_the_tree_of_a_text() -> None:
    node = parse_wkt('A["say ""so""",1.5,B[-2e3],c,D["d"]]')
    assert node.text() == 'say "so"'
    assert node.number(1) == 1.5
    child = node.child("B")
    assert child is not None
    assert child.number(0) == -2000.0
    assert [each.name for each in node.children("C", "D")] == ["C", "D"]


@pytest.mark.parametrize("text", ["A[", "A]", "[A]", 'A["x', "A B", "1", "A[[1]]"])
def test_texts_that_are_none(text: str) -> None:
    with pytest.raises(WktError):
        parse_wkt(text)
