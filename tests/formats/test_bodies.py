"""Shapes are found by the names that headers write."""

from __future__ import annotations

import pytest

from addon.formats.body.bodies import BODIES, ELLIPSOIDS, body_in, body_of, body_told, ellipsoid_named
from addon.formats.body.ellipsoid import Ellipsoid


@pytest.mark.parametrize(
    ("name", "semi_major"),
    [
        ("D_WGS_1984", 6378137.0),
        ("wgs84", 6378137.0),
        ("WGS 72", 6378135.0),
        ("North_American_1983", 6378137.0),
        ("NAD27", 6378206.4),
        ("Clarke_1866", 6378206.4),
        ("International 1924", 6378388.0),
        ("Bessel_1841", 6377397.155),
        ("airy_1830", 6377563.396),
        ("D_Mars_2000", 3396190.0),
        ("MOLA sphere", 3396000.0),
    ],
)
def test_datums_are_found_however_they_are_written(name: str, semi_major: float) -> None:
    shape = ellipsoid_named(name)
    assert shape is not None
    assert shape.ellipsoid.semi_major == semi_major


def test_bodies_are_found_in_any_case() -> None:
    mars = body_in(" MARS")
    assert mars is not None
    assert mars.ellipsoid == Ellipsoid(3396190.0, 3376200.0)
    moon = body_in("moon")
    assert moon is not None
    assert moon.ellipsoid.is_sphere


def test_what_is_not_known_is_not_guessed() -> None:
    for name in ("", "D_", "Arrakis", "WGS"):
        assert body_in(name) is None
        assert ellipsoid_named(name) is None


def test_no_name_is_given_twice() -> None:
    for shapes, find in ((BODIES, body_in), (ELLIPSOIDS, ellipsoid_named)):
        for shape in shapes:
            assert shape.source
            assert shape.ellipsoid.semi_minor <= shape.ellipsoid.semi_major
            for name in (shape.name, *shape.other_names):
                assert find(name) is shape


def test_a_radius_tells_the_body() -> None:
    assert body_of(Ellipsoid.sphere(3396000.0)) == "Mars"
    assert body_of(Ellipsoid.sphere(6371000.0)) == "Earth"
    assert body_of(Ellipsoid.sphere(1737400.0)) == "Moon"
    assert body_of(Ellipsoid.sphere(1.0)) == ""
    assert body_of(Ellipsoid.sphere(2425000.0)) == ""  # between Callisto and Mercury


def test_names_are_believed_before_sizes() -> None:
    assert body_told("GCS_Moon_2000", Ellipsoid.sphere(3396000.0)) == "Moon"
    assert body_told("lunar sphere", Ellipsoid.sphere(1.0)) == "Moon"
    assert body_told("D_Vesta", Ellipsoid.sphere(255000.0)) == "Vesta"
    assert body_told("Marseille", Ellipsoid.sphere(1.0)) == ""
    assert body_told("ratio of Io2000", Ellipsoid.sphere(1.0)) == "Io"
    assert body_told("nameless", Ellipsoid.sphere(2575000.0)) == "Titan"
