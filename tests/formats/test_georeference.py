"""Places of a grid and places of its body are taken into each other, across any seam."""

from __future__ import annotations

import math

import pytest

from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.georeference import Georeference
from addon.formats.georeference_properties import georeference_from, georeference_properties
from addon.formats.projections import (
    KINDS,
    Equirectangular,
    Geographic,
    PolarStereographic,
    Projection,
    TransverseMercator,
)

MOLA = Ellipsoid.sphere(3396000.0)
WGS84 = Ellipsoid.flattened(6378137.0, 298.257223563)


def placed(
    projection: Projection, first: tuple[float, float], step: float, ellipsoid: Ellipsoid = MOLA
) -> Georeference:
    """A grid whose sample (0, 0) has these coordinates."""
    return Georeference("Mars", ellipsoid, projection, *first, step, step, "areoid")


RADIAN = MOLA.semi_major * math.radians(1.0)
GLOBES = {
    "0 to 360": placed(Geographic(), (0.5, 89.5), 1.0),
    "-180 to 180": placed(Geographic(), (-179.5, 89.5), 1.0),
    "metres from 0": placed(Equirectangular(), (0.5 * RADIAN, 89.5 * RADIAN), RADIAN),
    "metres about 180": placed(Equirectangular(central_longitude=180.0), (-179.5 * RADIAN, 0.0), RADIAN),
}


@pytest.mark.parametrize("globe", GLOBES)
@pytest.mark.parametrize("column", [0.0, 0.25, 179.0, 179.5, 180.0, 358.75, 359.0])
def test_columns_on_either_side_of_the_seam_come_back(globe: str, column: float) -> None:
    georeference = GLOBES[globe]
    place = georeference.longitude_latitude(column, 40.0)
    assert place is not None
    assert 0.0 <= place[0] < 360.0
    for turn in (-360.0, 0.0, 360.0):
        assert georeference.column_row(place[0] + turn, place[1], 360) == pytest.approx((column, 40.0))


@pytest.mark.parametrize("globe", GLOBES)
def test_a_place_between_the_last_column_and_the_first_is_half_a_cell_from_both(globe: str) -> None:
    georeference = GLOBES[globe]
    seam = georeference.longitude_latitude(359.5, 10.0)
    assert seam is not None
    found = georeference.column_row(*seam, 360)
    assert found is not None
    assert found[0] % 360.0 == pytest.approx(359.5)


@pytest.mark.parametrize(
    ("projection", "ellipsoid"),
    [
        (TransverseMercator.utm(10, north=True), WGS84),
        (PolarStereographic(), MOLA),
        (PolarStereographic(latitude_of_origin=-90.0, standard_parallel_1=-71.0), WGS84),
    ],
)
def test_grids_in_metres_come_back(projection: Projection, ellipsoid: Ellipsoid) -> None:
    first = (550_000.0, 5_100_000.0) if isinstance(projection, TransverseMercator) else (-1e6, 1e6)
    georeference = placed(projection, first, 30.0, ellipsoid)
    for column, row in ((0.0, 0.0), (10.5, 300.25), (40000.0, 20000.0)):
        place = georeference.longitude_latitude(column, row)
        assert place is not None
        found = georeference.column_row(*place, 1000)
        assert found == pytest.approx((column, row), abs=1e-5)


@pytest.mark.parametrize("name", KINDS)
def test_every_projection_is_kept_with_its_georeference(name: str) -> None:
    georeference = placed(KINDS[name](), (1.0, 2.0), 3.0)
    assert georeference_from(georeference_properties(georeference)) == georeference


def test_cells_of_planetocentric_degrees_are_measured_on_the_ellipsoid() -> None:
    """Against the places themselves, on the ellipse of a meridian."""
    mars = Ellipsoid(3_396_190.0, 3_376_200.0)
    step, middle = 1e-3, 60.0
    place = Georeference("Mars", mars, Geographic(), 0.0, middle + step, step, step, "areoid")
    assert place.latitude_kind == "planetocentric"

    def on_ellipse(latitude: float) -> tuple[float, float]:
        radius = 1.0 / math.hypot(
            math.cos(math.radians(latitude)) / mars.semi_major,
            math.sin(math.radians(latitude)) / mars.semi_minor,
        )
        return radius * math.cos(math.radians(latitude)), radius * math.sin(math.radians(latitude))

    width, height = place.cell_size(3, 8)
    assert width == pytest.approx(math.radians(step) * on_ellipse(middle)[0], rel=1e-9)
    ends = on_ellipse(middle + step), on_ellipse(middle - step)
    assert height == pytest.approx(math.dist(*ends) / 2.0, rel=1e-7)
