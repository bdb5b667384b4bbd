"""Places come out where published examples and PROJ put them; hostile numbers come to nothing."""

from __future__ import annotations

import math
from dataclasses import asdict, fields
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.projections import (
    KINDS,
    Albers,
    Equirectangular,
    Geographic,
    LambertAzimuthalEqualArea,
    LambertConformalConic,
    Mercator,
    ObliqueStereographic,
    PolarStereographic,
    Projection,
    Sinusoidal,
    TransverseMercator,
    Unknown,
    WebMercator,
)
from addon.formats.projections.meridian import latitude_at, meridian_distance

CLARKE_1866 = Ellipsoid(6378206.4, 6356583.8)
INTERNATIONAL = Ellipsoid.flattened(6378388.0, 297.0)
WGS84 = Ellipsoid.flattened(6378137.0, 298.257223563)
MARS = Ellipsoid(3396190.0, 3376200.0)
MOLA = Ellipsoid.sphere(3396000.0)
BODIES = {"Earth": WGS84, "Mars": MARS, "MOLA's sphere": MOLA}

SNYDER = (
    (Mercator(central_longitude=-180.0), CLARKE_1866, (-75.0, 35.0), (11688673.7, 4139145.6)),
    (
        TransverseMercator(central_longitude=-75.0, scale_factor=0.9996),
        CLARKE_1866,
        (-73.5, 40.5),
        (127106.5, 4484124.4),
    ),
    (
        Albers(
            central_longitude=-96.0,
            latitude_of_origin=23.0,
            standard_parallel_1=29.5,
            standard_parallel_2=45.5,
        ),
        CLARKE_1866,
        (-75.0, 35.0),
        (1885472.7, 1535925.0),
    ),
    (
        LambertConformalConic(
            central_longitude=-96.0,
            latitude_of_origin=23.0,
            standard_parallel_1=33.0,
            standard_parallel_2=45.0,
        ),
        CLARKE_1866,
        (-75.0, 35.0),
        (1894410.9, 1564649.5),
    ),
    (
        ObliqueStereographic(central_longitude=-100.0, latitude_of_origin=40.0, scale_factor=0.9999),
        CLARKE_1866,
        (-90.0, 30.0),
        (971630.8, -1063049.3),
    ),
    (
        PolarStereographic(central_longitude=-100.0, latitude_of_origin=-90.0, standard_parallel_1=-71.0),
        INTERNATIONAL,
        (150.0, -75.0),
        (-1540033.6, -560526.4),
    ),
    (
        LambertAzimuthalEqualArea(central_longitude=-100.0, latitude_of_origin=40.0),
        CLARKE_1866,
        (-110.0, 30.0),
        (-965932.1, -1056814.9),
    ),
    (
        LambertAzimuthalEqualArea(central_longitude=-100.0, latitude_of_origin=90.0),
        INTERNATIONAL,
        (5.0, 80.0),
        (1077459.7, 288704.5),
    ),
    (Sinusoidal(central_longitude=-90.0), CLARKE_1866, (-75.0, -50.0), (1075471.5, -5540628.0)),
)
"""J. P. Snyder, "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), Appendix A, the
numerical examples with the ellipsoid: printed to 0.1 m, and worked by hand with rounded steps."""

# Each with its PROJ parameters (without the ellipsoid), and the places (west, south, east, north from the
# central meridian) at which both are asked.
CASES: dict[str, tuple[Projection, str, tuple[float, float, float, float]]] = {
    "utm north": (
        TransverseMercator.utm(33, north=True),
        "+proj=tmerc +lon_0=15 +k=0.9996 +x_0=500000",
        (-40.0, -80.0, 40.0, 89.0),
    ),
    "utm south": (
        TransverseMercator.utm(60, north=False),
        "+proj=tmerc +lon_0=177 +k=0.9996 +x_0=500000 +y_0=10000000",
        (-10.0, -89.0, 10.0, 10.0),
    ),
    "transverse": (
        TransverseMercator(central_longitude=300.0, latitude_of_origin=49.0, scale_factor=0.9996012717),
        "+proj=tmerc +lon_0=300 +lat_0=49 +k=0.9996012717",
        (-40.0, -89.0, 40.0, 89.0),
    ),
    "north pole": (
        PolarStereographic(central_longitude=-45.0, standard_parallel_1=70.0, false_easting=2e6),
        "+proj=stere +lat_0=90 +lat_ts=70 +lon_0=-45 +x_0=2000000",
        (-180.0, -60.0, 180.0, 89.9999),
    ),
    "north pole by scale": (
        PolarStereographic(scale_factor=0.994, false_easting=2e6, false_northing=2e6),
        "+proj=stere +lat_0=90 +k=0.994 +x_0=2000000 +y_0=2000000",
        (-180.0, -60.0, 180.0, 89.9999),
    ),
    "south pole": (
        PolarStereographic(central_longitude=10.0, latitude_of_origin=-90.0, standard_parallel_1=71.0),
        "+proj=stere +lat_0=-90 +lat_ts=-71 +lon_0=10",
        (-180.0, -89.9999, 180.0, 60.0),
    ),
    "oblique stereographic": (
        ObliqueStereographic(central_longitude=20.0, latitude_of_origin=-33.0, scale_factor=0.99),
        "+proj=stere +lat_0=-33 +lon_0=20 +k=0.99",
        (-80.0, -85.0, 80.0, 60.0),
    ),
    "conic, two parallels": (
        LambertConformalConic(
            central_longitude=10.0,
            latitude_of_origin=52.0,
            standard_parallel_1=35.0,
            standard_parallel_2=65.0,
            false_easting=4e6,
            false_northing=2.8e6,
        ),
        "+proj=lcc +lat_0=52 +lon_0=10 +lat_1=35 +lat_2=65 +x_0=4000000 +y_0=2800000",
        (-179.0, -60.0, 179.0, 89.9),
    ),
    "conic, one parallel": (
        LambertConformalConic(
            latitude_of_origin=46.8,
            standard_parallel_1=46.8,
            standard_parallel_2=46.8,
            scale_factor=0.99987742,
        ),
        "+proj=lcc +lat_0=46.8 +lat_1=46.8 +k_0=0.99987742",
        (-179.0, -60.0, 179.0, 89.9),
    ),
    "conic to the south": (
        LambertConformalConic(latitude_of_origin=-30.0, standard_parallel_1=-20.0, standard_parallel_2=-50.0),
        "+proj=lcc +lat_0=-30 +lat_1=-20 +lat_2=-50",
        (-179.0, -89.9, 179.0, 60.0),
    ),
    "Albers": (
        Albers(
            central_longitude=-96.0,
            latitude_of_origin=23.0,
            standard_parallel_1=29.5,
            standard_parallel_2=45.5,
        ),
        "+proj=aea +lat_0=23 +lon_0=-96 +lat_1=29.5 +lat_2=45.5",
        (-179.0, -80.0, 179.0, 89.0),
    ),
    "Albers to the south": (
        Albers(latitude_of_origin=-10.0, standard_parallel_1=-20.0, standard_parallel_2=-20.0),
        "+proj=aea +lat_0=-10 +lat_1=-20 +lat_2=-20",
        (-179.0, -89.0, 179.0, 80.0),
    ),
    "Mercator A": (
        Mercator(central_longitude=110.0, scale_factor=0.997, false_easting=3.9e6),
        "+proj=merc +lon_0=110 +k=0.997 +x_0=3900000",
        (-180.0, -89.0, 179.9, 89.0),
    ),
    "Mercator B": (
        Mercator(central_longitude=51.0, standard_parallel_1=-42.0),
        "+proj=merc +lon_0=51 +lat_ts=-42",
        (-180.0, -89.0, 179.9, 89.0),
    ),
    "web Mercator": (WebMercator(), "+proj=webmerc", (-180.0, -85.0, 179.9, 85.0)),
    "equirectangular": (
        Equirectangular(central_longitude=180.0, standard_parallel_1=30.0, latitude_of_origin=10.0),
        "+proj=eqc +lon_0=180 +lat_ts=30 +lat_0=10",
        (-180.0, -90.0, 179.9, 90.0),
    ),
    "sinusoidal": (
        Sinusoidal(central_longitude=60.0),
        "+proj=sinu +lon_0=60",
        (-179.0, -89.99, 179.0, 89.99),
    ),
    "azimuthal": (
        LambertAzimuthalEqualArea(
            central_longitude=10.0, latitude_of_origin=52.0, false_easting=4321000.0, false_northing=3210000.0
        ),
        "+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000",
        (-90.0, -40.0, 90.0, 90.0),
    ),
    "azimuthal from the equator": (
        LambertAzimuthalEqualArea(),
        "+proj=laea +lat_0=0 +lon_0=0",
        (-150.0, -80.0, 150.0, 80.0),
    ),
    "azimuthal from a pole": (
        LambertAzimuthalEqualArea(latitude_of_origin=-90.0),
        "+proj=laea +lat_0=-90 +lon_0=0",
        (-180.0, -89.99, 179.0, 60.0),  # nearer to the pole PROJ loses digits
    ),
}

METRES = 1e-6
"""How near forward and inverse come back."""


def places(limits: tuple[float, float, float, float], centre: float) -> list[tuple[float, float]]:
    """A lattice of places that avoids round numbers, and its corners."""
    west, south, east, north = limits
    steps = [0.0, 0.01, 0.137, 0.2931, 0.4999, 0.5, 0.6173, 0.8419, 0.993, 1.0]
    return [
        (centre + west + across * (east - west), south + up * (north - south))
        for across in steps
        for up in steps
    ]


@pytest.mark.parametrize(
    ("projection", "ellipsoid", "place", "printed"), SNYDER, ids=lambda value: getattr(value, "name", "")
)
def test_snyders_examples_come_out_within_a_unit_of_the_last_digit(
    projection: Projection, ellipsoid: Ellipsoid, place: tuple[float, float], printed: tuple[float, float]
) -> None:
    assert projection.forward(*place, ellipsoid) == pytest.approx(printed, abs=0.1)
    back = projection.inverse(*printed, ellipsoid)
    assert back is not None
    assert math.remainder(back[0] - place[0], 360.0) == pytest.approx(0.0, abs=3e-6)
    assert back[1] == pytest.approx(place[1], abs=3e-6)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("case", CASES)
def test_inverse_takes_back_what_forward_gave(case: str, body: str) -> None:
    projection, _, limits = CASES[case]
    ellipsoid = BODIES[body]
    for longitude, latitude in places(limits, getattr(projection, "central_longitude", 0.0)):
        there = projection.forward(longitude, latitude, ellipsoid)
        assert there is not None, (longitude, latitude)
        back = projection.inverse(*there, ellipsoid)
        assert back is not None, (longitude, latitude)
        around = math.radians(math.remainder(back[0] - longitude, 360.0)) * math.cos(math.radians(latitude))
        along = math.radians(back[1] - latitude)
        assert ellipsoid.semi_major * math.hypot(around, along) < METRES, (
            longitude,
            latitude,
            back,
        )


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("case", CASES)
def test_proj_puts_places_at_the_same_metres(case: str, body: str) -> None:
    pyproj = pytest.importorskip("pyproj", reason="pyproj is not installed: nothing to compare with")
    projection, text, limits = CASES[case]
    ellipsoid = BODIES[body]
    axes = f"+a={ellipsoid.semi_major!r} +b={ellipsoid.semi_minor!r}"
    version = tuple(int(part) for part in pyproj.proj_version_str.split(".")[:2])
    if case == "equirectangular" and not ellipsoid.is_sphere and version < (9, 5):
        pytest.skip("older PROJ takes ellipsoids for spheres in eqc")
    if case.startswith("utm") and ellipsoid.is_sphere:
        pytest.skip("PROJ refuses UTM on a sphere")
    if case == "web Mercator" and body != "Earth":
        text, axes = "+proj=merc", f"+R={ellipsoid.semi_major!r}"
    theirs = pyproj.Proj(f"{text} {axes} +units=m +no_defs")
    for longitude, latitude in places(limits, getattr(projection, "central_longitude", 0.0)):
        ours = projection.forward(longitude, latitude, ellipsoid)
        assert ours is not None
        x, y = theirs(longitude, latitude)
        turn = projection.turn(ellipsoid)
        miss = math.remainder(ours[0] - x, turn) if turn else ours[0] - x
        # Relative far out, where a metre on the ground is kilometres on the map.
        allowed = 1e-3 if case in ("utm north", "transverse") else 1e-5 + 1e-11 * math.hypot(x, y)
        assert math.hypot(miss, ours[1] - y) < allowed, (longitude, latitude, ours, (x, y))


def test_the_meridian_is_as_long_as_its_radii_of_curvature_add_up_to() -> None:
    """On a body flatter than Mars, so that an error in any of the series would be seen."""
    ellipsoid = Ellipsoid(1.0, 0.98)
    steps = 2000
    for end in (10.0, 37.0, 53.0, 71.0, 90.0):
        # Simpson's rule; a degree's length is the radius of curvature times a degree.
        nodes = [ellipsoid.degree_of_latitude(end * number / steps) for number in range(steps + 1)]
        weighted = nodes[0] + nodes[-1] + 4.0 * math.fsum(nodes[1:-1:2]) + 2.0 * math.fsum(nodes[2:-1:2])
        along = weighted * end / steps / 3.0
        assert meridian_distance(math.radians(end), ellipsoid) == pytest.approx(along, abs=2e-13)
        back = latitude_at(along, ellipsoid)
        assert back is not None
        assert math.degrees(back) == pytest.approx(end, abs=5e-11)


def test_utm_zone_1_begins_at_the_date_line() -> None:
    assert TransverseMercator.utm(1, north=True).central_longitude == -177.0
    assert TransverseMercator.utm(60, north=True).central_longitude == 177.0
    at_the_equator = TransverseMercator.utm(1, north=False).forward(-177.0, 0.0, WGS84)
    assert at_the_equator == pytest.approx((500_000.0, 10_000_000.0))


@pytest.mark.parametrize("zone", [0, 61, -1])
def test_there_are_sixty_zones(zone: int) -> None:
    with pytest.raises(ValueError, match="1 to 60"):
        TransverseMercator.utm(zone, north=True)


@pytest.mark.parametrize("latitude", [90.0, -90.0])
@pytest.mark.parametrize(
    "projection", [PolarStereographic(), LambertAzimuthalEqualArea(latitude_of_origin=90.0)]
)
def test_the_pole_itself_is_the_origin(projection: Projection, latitude: float) -> None:
    there = projection.forward(123.0, latitude, WGS84)
    if latitude > 0.0:
        assert there == pytest.approx((0.0, 0.0), abs=1e-8)
        assert projection.inverse(0.0, 0.0, WGS84) == (0.0, 90.0)
    else:
        assert there is None or math.hypot(*there) > 1e7


def test_south_polar_maps_have_the_central_longitude_up() -> None:
    projection = PolarStereographic(latitude_of_origin=-90.0, standard_parallel_1=-90.0)
    there = projection.forward(0.0, -80.0, MOLA)
    assert there is not None
    assert there[0] == 0.0
    assert there[1] > 0.0
    east = projection.forward(90.0, -80.0, MOLA)
    assert east is not None
    assert east[0] > 0.0


def test_the_corner_beside_a_sinusoidal_outline_is_nowhere() -> None:
    edge = Sinusoidal().forward(179.999, 60.0, MOLA)
    assert edge is not None
    assert Sinusoidal().inverse(*edge, MOLA) == pytest.approx((179.999, 60.0))
    assert Sinusoidal().inverse(edge[0] * 1.01, edge[1], MOLA) is None
    assert Sinusoidal().inverse(0.0, 1.01 * MOLA.semi_major * math.pi / 2.0, MOLA) is None


def test_longitudes_of_any_turn_are_the_same_place() -> None:
    for projection, _, _ in CASES.values():
        centre = getattr(projection, "central_longitude", 0.0)
        once = projection.forward(centre + 5.0, 20.0, WGS84)
        assert projection.forward(centre + 365.0, 20.0, WGS84) == pytest.approx(once, rel=1e-12)
        assert projection.forward(centre - 715.0, 20.0, WGS84) == pytest.approx(once, rel=1e-12)


def test_a_cylindrical_map_that_runs_beyond_half_a_turn_is_read() -> None:
    projection = Equirectangular()
    turn = projection.turn(MOLA)
    assert turn is not None
    assert turn == pytest.approx(math.tau * 3396000.0)
    found = projection.inverse(0.75 * turn, 0.0, MOLA)
    assert found is not None
    assert found[0] % 360.0 == pytest.approx(270.0)


@pytest.mark.parametrize("name", KINDS)
def test_a_projection_is_kept_by_its_name_and_numbers(name: str) -> None:
    kind = KINDS[name]
    projection = kind()
    assert projection.name == name
    numbers: dict[str, Any] = asdict(projection)  # type: ignore[call-overload]
    assert all(type(number) is float for number in numbers.values())
    assert all(str(field.type) == "float" for field in fields(kind))  # type: ignore[arg-type]
    assert kind(**numbers) == projection


def test_a_cone_of_no_opening_is_no_map() -> None:
    for kind in (Albers, LambertConformalConic):
        cylinder = kind(standard_parallel_1=30.0, standard_parallel_2=-30.0)
        assert cylinder.forward(1.0, 1.0, WGS84) is None
        assert cylinder.inverse(1.0, 1.0, WGS84) is None


HOSTILE = st.one_of(
    st.sampled_from(
        (
            *(0.0, -0.0, 1e-300, 1.0, 45.0, 90.0, -90.0, 180.0, -180.0, 360.0, 1e7, 1e300, -1e300, 5e-324),
            *(math.nan, math.inf, -math.inf, math.nextafter(90.0, 0.0), math.nextafter(90.0, 91.0)),
        )
    ),
    st.floats(-400.0, 400.0),
    st.floats(-3e7, 3e7),
    st.floats(),
)
AXES = st.one_of(st.sampled_from([6378137.0, 3396190.0, 1.0]), HOSTILE)


@pytest.mark.parametrize("name", KINDS)
@settings(deadline=None, max_examples=300)
@given(data=st.data())
def test_hostile_numbers_give_a_finite_place_or_none(name: str, data: st.DataObject) -> None:
    kind = KINDS[name]
    numbers = {field.name: data.draw(HOSTILE, field.name) for field in fields(kind)}  # type: ignore[arg-type]
    projection = kind(**numbers)
    ellipsoid = data.draw(
        st.one_of(st.sampled_from(list(BODIES.values())), st.builds(Ellipsoid, AXES, AXES)), "ellipsoid"
    )
    first, second = data.draw(HOSTILE, "first"), data.draw(HOSTILE, "second")
    for answer in (
        projection.forward(first, second, ellipsoid),
        projection.inverse(first, second, ellipsoid),
    ):
        assert answer is None or (math.isfinite(answer[0]) and math.isfinite(answer[1]))
    found = projection.inverse(first, second, ellipsoid)
    assert found is None or abs(found[1]) <= 90.0
    turn = projection.turn(ellipsoid)
    assert turn is None or 0.0 < turn < math.inf


@settings(deadline=None, max_examples=300)
@given(
    case=st.sampled_from(sorted(CASES)),
    x=st.floats(-4e7, 4e7),
    y=st.floats(-4e7, 4e7),
    body=st.sampled_from(sorted(BODIES)),
)
def test_a_place_found_is_where_it_was_looked_for(case: str, x: float, y: float, body: str) -> None:
    projection, ellipsoid = CASES[case][0], BODIES[body]
    found = projection.inverse(x, y, ellipsoid)
    if found is None:
        return
    there = projection.forward(*found, ellipsoid)
    assert there is not None
    turn = projection.turn(ellipsoid)
    miss = math.remainder(there[0] - x, turn) if turn else there[0] - x
    assert math.hypot(miss, there[1] - y) < 0.7


def test_degrees_and_unknown_maps_refuse_what_is_no_number() -> None:
    assert Geographic().forward(math.nan, 0.0, WGS84) is None
    assert Geographic().inverse(math.inf, 0.0, WGS84) is None
    assert Geographic().inverse(0.0, 90.1, WGS84) is None
    assert Unknown().turn(WGS84) is None
