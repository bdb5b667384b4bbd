"""Maps that are not true to scale."""

from __future__ import annotations

import math

import pytest

from addon.formats.body.datums import WGS84
from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.georeference import Georeference
from addon.formats.projections import (
    Equirectangular,
    Mercator,
    PolarStereographic,
    Projection,
    TransverseMercator,
    Unknown,
)
from addon.formats.projections.map_scale import map_scale

MARS = Ellipsoid.sphere(3_396_190.0)


def scale_at(
    projection: Projection, longitude: float, latitude: float, body: Ellipsoid
) -> tuple[float, float]:
    place = projection.forward(longitude, latitude, body)
    assert place is not None
    return map_scale(projection, body, place)


@pytest.mark.parametrize("latitude", [-75.0, -30.0, 45.0, 60.0, 80.0])
def test_mercator_stretches_both_axes_and_equirectangular_one(latitude: float) -> None:
    stretch = 1.0 / math.cos(math.radians(latitude))
    assert scale_at(Mercator(), 20.0, latitude, MARS) == pytest.approx((stretch, stretch), rel=1e-6)
    assert scale_at(Equirectangular(), 20.0, latitude, MARS) == pytest.approx((stretch, 1.0), rel=1e-6)


def test_mercator_on_an_ellipsoid_has_its_own_scale() -> None:
    latitude = math.radians(60.0)
    expected = math.sqrt(1.0 - WGS84.eccentricity_squared * math.sin(latitude) ** 2) / math.cos(latitude)
    assert scale_at(Mercator(), 5.0, 60.0, WGS84) == pytest.approx((expected, expected), rel=1e-6)


def test_a_cell_of_a_utm_map_is_called_what_it_is_called() -> None:
    assert scale_at(TransverseMercator.utm(32, True), 11.9, 47.0, WGS84) == (1.0, 1.0)


def test_the_pole_of_a_polar_map_is_true_and_its_rim_is_not() -> None:
    polar = PolarStereographic(latitude_of_origin=90.0)
    assert map_scale(polar, MARS, (0.0, 0.0)) == (1.0, 1.0)
    rim = 2.0 / (1.0 + math.sin(math.radians(55.0)))
    assert scale_at(polar, 40.0, 55.0, MARS) == pytest.approx((rim, rim), rel=1e-5)


def test_where_nobody_can_tell_the_maps_metres_are_the_grounds() -> None:
    assert map_scale(Unknown(), WGS84, (0.0, 0.0)) == (1.0, 1.0)
    assert map_scale(Mercator(), MARS, (math.nan, 0.0)) == (1.0, 1.0)
    assert map_scale(Mercator(), MARS, (0.0, 1e300)) == (1.0, 1.0)


def test_cells_are_metres_of_ground_in_the_middle_of_the_map() -> None:
    middle = Mercator().forward(0.0, 60.0, MARS)
    assert middle is not None
    place = Georeference(
        body="Mars",
        ellipsoid=MARS,
        projection=Mercator(),
        first_x=middle[0] - 50.0 * 100.0,
        first_y=middle[1] + 20.0 * 100.0,
        step_x=100.0,
        step_y=100.0,
        vertical_reference="sphere",
    )
    assert place.cell_size(41, 101) == pytest.approx((50.0, 50.0), rel=1e-6)
