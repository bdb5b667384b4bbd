"""Distances are right for places that are near, opposite, across the seam, and at poles."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from addon.formats.body.distance import distance
from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.body.latitudes import planetographic_degrees, to_planetographic
from addon.formats.projections.meridian import meridian_distance

SPHERE = Ellipsoid.sphere(1000.0)
WGS84 = Ellipsoid.flattened(6378137.0, 298.257223563)
MARS = Ellipsoid(3396190.0, 3376200.0)
BESSEL = Ellipsoid.flattened(6377397.155, 299.1528128)


def test_vincentys_example_comes_out() -> None:
    """Line (a) of his table II, on Bessel's ellipsoid: 14,110,526.170 m."""
    start = (0.0, 55 + 45 / 60)
    end = (108 + 13 / 60, -(33 + 26 / 60))
    assert distance(start, end, BESSEL) == pytest.approx(14110526.170, abs=0.001)


@pytest.mark.parametrize("ellipsoid", [SPHERE, WGS84, MARS])
def test_a_place_is_nowhere_from_itself(ellipsoid: Ellipsoid) -> None:
    for place in ((0.0, 0.0), (10.0, 90.0), (200.0, -45.0), (-180.0, -90.0)):
        assert distance(place, place, ellipsoid) == pytest.approx(0.0, abs=1e-9)
        assert distance(place, (place[0] + 360.0, place[1]), ellipsoid) == pytest.approx(0.0, abs=1e-6)


def test_a_sphere_is_measured_in_quarters() -> None:
    quarter = 1000.0 * math.pi / 2.0
    assert distance((0.0, 0.0), (90.0, 0.0), SPHERE) == pytest.approx(quarter)
    assert distance((0.0, 0.0), (77.0, 90.0), SPHERE) == pytest.approx(quarter)
    assert distance((350.0, 0.0), (-100.0, 0.0), SPHERE) == pytest.approx(quarter)
    assert distance((10.0, 20.0), (190.0, -20.0), SPHERE) == pytest.approx(2.0 * quarter)


@pytest.mark.parametrize("latitude", [0.0, 45.0, 89.0])
def test_near_places_keep_their_digits(latitude: float) -> None:
    for ellipsoid in (Ellipsoid.sphere(6371000.0), WGS84, MARS):
        step = 1e-6
        north = distance((5.0, latitude), (5.0, latitude + step), ellipsoid)
        assert north == pytest.approx(step * ellipsoid.degree_of_latitude(latitude), rel=1e-6)
        east = distance((5.0, latitude), (5.0 + step, latitude), ellipsoid)
        assert east == pytest.approx(step * ellipsoid.degree_of_longitude(latitude), rel=1e-6)


@pytest.mark.parametrize("ellipsoid", [WGS84, MARS])
def test_opposite_places_are_joined_over_a_pole(ellipsoid: Ellipsoid) -> None:
    half = 2.0 * meridian_distance(math.pi / 2.0, ellipsoid)
    assert distance((0.0, 0.0), (180.0, 0.0), ellipsoid) == pytest.approx(half, abs=0.001)
    assert distance((0.0, 30.0), (180.0, -30.0), ellipsoid) == pytest.approx(half, abs=0.001)
    assert distance((0.0, 90.0), (50.0, -90.0), ellipsoid) == pytest.approx(half, abs=0.001)


def test_nearly_opposite_places_are_as_another_library_has_them() -> None:
    """C. F. F. Karney, "Algorithms for geodesics", Journal of Geodesy 87 (2013), table 5."""
    assert distance((0.0, -30.0), (179.8, 29.9), WGS84) == pytest.approx(19989832.827610, abs=0.001)


def test_geographiclib_finds_the_same_distances() -> None:
    pyproj = pytest.importorskip("pyproj", reason="pyproj is not installed: nothing to compare with")
    chance = random.Random(5)
    for ellipsoid in (WGS84, MARS):
        geod = pyproj.Geod(a=ellipsoid.semi_major, b=ellipsoid.semi_minor)
        for turn in range(400):
            start = (chance.uniform(-180.0, 180.0), chance.uniform(-90.0, 90.0))
            end = (chance.uniform(-180.0, 180.0), chance.uniform(-90.0, 90.0))
            if turn % 4 == 0:  # nearly opposite
                end = (start[0] + 180.0 + chance.uniform(-0.7, 0.7), -start[1] * 0.99)
            if turn % 4 == 1:  # near
                end = (start[0] + chance.uniform(-1e-4, 1e-4), start[1] * 0.999999)
            theirs = geod.inv(*start, *end)[2]
            assert distance(start, end, ellipsoid) == pytest.approx(theirs, abs=0.001), (start, end)


NUMBERS = st.one_of(st.floats(), st.floats(-400.0, 400.0), st.sampled_from([90.0, -90.0, 180.0, 0.0, 1e-9]))


@settings(deadline=None, max_examples=400)
@given(start=st.tuples(NUMBERS, NUMBERS), end=st.tuples(NUMBERS, NUMBERS), axes=st.tuples(NUMBERS, NUMBERS))
def test_hostile_numbers_give_metres_or_none(
    start: tuple[float, float], end: tuple[float, float], axes: tuple[float, float]
) -> None:
    for ellipsoid in (SPHERE, MARS, Ellipsoid(*axes)):
        metres = distance(start, end, ellipsoid)
        assert metres is None or 0.0 <= metres < math.inf


def test_latitudes_of_mars_differ_by_a_third_of_a_degree() -> None:
    assert to_planetographic(44.6618, MARS) == pytest.approx(45.0, abs=1e-4)
    assert to_planetographic(45.0, MARS) == pytest.approx(45.3382, abs=1e-4)
    assert to_planetographic(-45.0, MARS) == pytest.approx(-45.3382, abs=1e-4)


@pytest.mark.parametrize("latitude", [-89.0, -30.0, 0.0, 45.0, 72.5])
def test_latitudes_grow_as_they_differ(latitude: float) -> None:
    apart = to_planetographic(latitude + 1e-4, MARS) - to_planetographic(latitude - 1e-4, MARS)
    assert planetographic_degrees(latitude, MARS) == pytest.approx(apart / 2e-4, rel=1e-7)


@pytest.mark.parametrize("latitude", [-90.0, 0.0, 90.0])
def test_equator_and_poles_are_the_same_in_either_kind(latitude: float) -> None:
    assert to_planetographic(latitude, MARS) == latitude


def test_a_sphere_has_one_kind_of_latitude() -> None:
    assert to_planetographic(33.3, SPHERE) == 33.3
    assert planetographic_degrees(33.3, SPHERE) == pytest.approx(1.0)
