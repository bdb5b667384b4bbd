"""Methods and parameters of projections in well-known text; places and coordinates are PROJ's (9.8)."""

from __future__ import annotations

import re

import pytest

from addon.formats.frames.stated_frame import StatedFrame, stated_frame
from addon.formats.projections import Unknown

GRS_80 = "6378137,298.257222101"
WGS_84 = "6378137,298.257223563"
FALSE_0 = "False_Easting=0 False_Northing=0"
WEB = (
    ',EXTENSION["PROJ4","+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +lon_0=0 +x_0=0 +y_0=0 +k=1 +units=m '
    '+nadgrids=@null +wktext +no_defs"]'
)

LAMBERT_93 = "{}=46.5 {}=3 standard_parallel_1=49 standard_parallel_2=44 {}=700000 {}=6600000"
OGC = ("latitude_of_origin", "central_meridian", "false_easting", "false_northing")
ESRI = ("Latitude_Of_Origin", "Central_Meridian", "False_Easting", "False_Northing")
CENTER = ("latitude_of_center", "longitude_of_center", "false_easting", "false_northing")
EUROPE = "{}=52 {}=10 {}=4321000 {}=3210000"
CONUS = "{}=23 {}=-96 Standard_Parallel_1=29.5 Standard_Parallel_2=45.5 {}=0 {}=0"
CALIFORNIA = (
    "latitude_of_origin=36.5 central_meridian=-120.5 standard_parallel_1=38.4333333333333 "
    "standard_parallel_2=37.0666666666667 false_easting=6561666.667 false_northing=1640416.667"
)

SYSTEMS = [
    ("Lambert_Conformal_Conic_2SP", LAMBERT_93.format(*OGC), GRS_80, (3.5, 47), (737992.994, 6655651.149)),
    ("Lambert_Conformal_Conic", LAMBERT_93.format(*ESRI), GRS_80, (3.5, 47), (737992.994, 6655651.149)),
    ("Lambert_Azimuthal_Equal_Area", EUROPE.format(*CENTER), GRS_80, (12, 50), (4464387.479, 2989464.315)),
    ("Lambert_Azimuthal_Equal_Area", EUROPE.format(*ESRI), GRS_80, (12, 50), (4464387.479, 2989464.315)),
    ("Albers_Conic_Equal_Area", CONUS.format(*CENTER), GRS_80, (-100, 40), (-338390.588, 1894100.140)),
    ("Albers", CONUS.format(*ESRI), GRS_80, (-100, 40), (-338390.588, 1894100.140)),
    (
        "Mercator_1SP",
        f"central_meridian=0 scale_factor=1 {FALSE_0}",
        WGS_84,
        (10, 45),
        (1113194.908, 5591295.919),
    ),
    (
        "Mercator",
        f"Central_Meridian=0 Standard_Parallel_1=0 {FALSE_0}",
        WGS_84,
        (10, 45),
        (1113194.908, 5591295.919),
    ),
    (
        "Mercator_2SP",
        f"standard_parallel_1=-41 central_meridian=100 {FALSE_0}",
        WGS_84,
        (110, -30),
        (841351.851, -2631835.820),
    ),
    (
        "Mercator_Auxiliary_Sphere",
        f"Central_Meridian=0 Standard_Parallel_1=0 Auxiliary_Sphere_Type=0 {FALSE_0}",
        WGS_84,
        (10, 45),
        (1113194.908, 5621521.486),
    ),
    ("Sinusoidal", f"longitude_of_center=0 {FALSE_0}", WGS_84, (10, 45), (788468.351, 4984944.378)),
    ("Sinusoidal", f"Central_Meridian=0 {FALSE_0}", WGS_84, (10, 45), (788468.351, 4984944.378)),
    (
        "Equirectangular",
        f"standard_parallel_1=0 central_meridian=0 {FALSE_0}",
        WGS_84,
        (10, 45),
        (1113194.908, 4984944.378),
    ),
    (
        "Equirectangular",
        f"latitude_of_origin=0 central_meridian=0 {FALSE_0}",
        WGS_84,
        (10, 45),
        (1113194.908, 4984944.378),
    ),
    (
        "Equidistant_Cylindrical",
        f"Standard_Parallel_1=0 Central_Meridian=0 {FALSE_0}",
        WGS_84,
        (10, 45),
        (1113194.908, 4984944.378),
    ),
    ("Plate_Carree", f"Central_Meridian=0 {FALSE_0}", WGS_84, (10, 45), (1113194.908, 4984944.378)),
]


def system(method: str, parameters: str, shape: str = WGS_84, unit: str = "1", rest: str = "") -> str:
    listed = ",".join('PARAMETER["{}",{}]'.format(*word.split("=")) for word in parameters.split())
    return (
        f'PROJCS["p",GEOGCS["g",DATUM["d",SPHEROID["s",{shape}]],PRIMEM["Greenwich",0],'
        f'UNIT["degree",0.0174532925199433]],PROJECTION["{method}"],{listed},UNIT["u",{unit}]{rest}]'
    )


def frame_of(text: str) -> StatedFrame:
    frame = stated_frame(text)
    assert frame is not None
    return frame


@pytest.mark.parametrize(("method", "parameters", "shape", "place", "coordinates"), SYSTEMS)
def test_places_are_where_proj_has_them(
    method: str,
    parameters: str,
    shape: str,
    place: tuple[float, float],
    coordinates: tuple[float, float],
) -> None:
    frame = frame_of(system(method, parameters, shape))
    assert frame.projection.forward(*place, frame.ellipsoid) == pytest.approx(coordinates, abs=2e-3)
    assert frame.notes == ()


@pytest.mark.parametrize(("method", "parameters", "shape", "place", "coordinates"), SYSTEMS)
def test_a_parameter_that_is_missing_is_not_guessed(
    method: str,
    parameters: str,
    shape: str,
    place: tuple[float, float],
    coordinates: tuple[float, float],
) -> None:
    for word in parameters.split():
        if re.match("false", word, re.IGNORECASE):
            continue
        frame = frame_of(system(method, parameters.replace(word, "").strip(), shape))
        told = frame.projection.forward(*place, frame.ellipsoid)
        if told is not None:
            # On a sphere as the web has it, the equator is the parallel anyway.
            assert (method, word) == ("Mercator_Auxiliary_Sphere", "Standard_Parallel_1=0")
            assert told == pytest.approx(coordinates, abs=2e-3)
        else:
            assert isinstance(frame.projection, Unknown)
            assert any(method in note for note in frame.notes)


@pytest.mark.parametrize("rest", [WEB, ',AUTHORITY["EPSG","3857"]'])
def test_web_mercator_is_told_from_mercator(rest: str) -> None:
    parameters = f"central_meridian=0 scale_factor=1 {FALSE_0}"
    frame = frame_of(system("Mercator_1SP", parameters, rest=rest))
    assert frame.projection.name == "web Mercator"
    frame = frame_of(system("Mercator_1SP", parameters).replace('"p"', '"WGS 84 / Pseudo-Mercator"'))
    assert frame.projection.name == "web Mercator"


@pytest.mark.parametrize(
    ("method", "parameters", "rest"),
    [
        ("Mercator_Auxiliary_Sphere", f"Central_Meridian=0 Auxiliary_Sphere_Type=3 {FALSE_0}", ""),
        ("Mercator_1SP", f"central_meridian=0 scale_factor=1 {FALSE_0}", WEB.replace("=6378137", "=6371000")),
        ("Mercator_1SP", f"central_meridian=0 scale_factor=1 {FALSE_0}", WEB.replace("=6378137", "=x")),
        ("Mercator_1SP", f"central_meridian=0 scale_factor=1 latitude_of_origin=10 {FALSE_0}", ""),
        ("Sinusoidal", f"central_meridian=0 azimuth=10 {FALSE_0}", ""),
        ("Sinusoidal", f"central_meridian=0 longitude_of_center=10 {FALSE_0}", ""),
        ("Sinusoidal", f"central_meridian=nan {FALSE_0}", ""),
        ("Krovak", f"central_meridian=0 {FALSE_0}", ""),
    ],
)
def test_what_is_not_known_or_contradicts_itself_tells_no_places(
    method: str, parameters: str, rest: str
) -> None:
    frame = frame_of(system(method, parameters, rest=rest))
    assert isinstance(frame.projection, Unknown)
    assert any(method in note for note in frame.notes)


def test_a_cone_in_feet_has_its_false_origin_in_feet() -> None:
    text = system("Lambert_Conformal_Conic_2SP", CALIFORNIA, GRS_80, unit="0.304800609601219")
    frame = frame_of(text)
    place = frame.projection.forward(-121.0, 37.0, frame.ellipsoid)
    assert place == pytest.approx((1955493.733, 555610.015), abs=2e-3)


@pytest.mark.parametrize(
    ("method", "parallel"),
    [("Lambert_Conformal_Conic_1SP", ""), ("Lambert_Conformal_Conic", " Standard_Parallel_1=52")],
)
@pytest.mark.parametrize("paris", ["2.33722917", "2.5969213"])
def test_a_cone_of_one_parallel_in_grads_from_paris(method: str, parallel: str, paris: str) -> None:
    parameters = (
        "latitude_of_origin=52 central_meridian=0 scale_factor=0.99987742 false_easting=600000 "
        f"false_northing=2200000{parallel}"
    )
    text = system(method, parameters, "6378249.2,293.466021293627")
    text = text.replace('"Greenwich",0', f'"Paris",{paris}').replace(
        "0.0174532925199433", "0.01570796326794897"
    )
    frame = frame_of(text)
    place = frame.projection.forward(4.0, 47.0, frame.ellipsoid)
    assert place == pytest.approx((726445.458, 2223568.537), abs=1e-2)
