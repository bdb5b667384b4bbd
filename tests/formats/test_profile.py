"""A profile follows the triangulated surface, measures true metres, and stops at voids."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Sequence
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from proxygraph import Grid, GridLayout

from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.georeference import Georeference
from addon.formats.profiles.profile import profile
from addon.formats.projections import (
    Equirectangular,
    Geographic,
    PolarStereographic,
    Projection,
    TransverseMercator,
    Unknown,
)

VOID = -9999.0
MOON = Ellipsoid.sphere(1737400.0)
MARS = Ellipsoid(3396190.0, 3376200.0)


def grid_of(rows: Sequence[Sequence[float]], *, wraps: bool = False) -> Grid:
    """A grid of 100 m cells with these heights."""
    layout = GridLayout(
        len(rows),
        len(rows[0]),
        cell_width=100.0,
        cell_height=100.0,
        sample="f64",
        byte_order="little",
        void=VOID,
        wraps=wraps,
    )
    return Grid.from_buffer(array("d", [height for row in rows for height in row]), layout)


def shaped(rows: int, columns: int, height: Callable[[int, int], float]) -> list[list[float]]:
    """Heights by column and row."""
    return [[height(column, row) for column in range(columns)] for row in range(rows)]


def at(
    projection: Projection | None = None,
    first: tuple[float, float] = (0.0, 0.0),
    step: float = 100.0,
    ellipsoid: Ellipsoid = MOON,
) -> Georeference:
    """A place on a body; by default a map in metres of an unknown projection."""
    return Georeference("Moon", ellipsoid, projection or Unknown(), *first, step, step, "reference sphere")


def test_a_plane_rises_evenly() -> None:
    grid = grid_of(shaped(6, 6, lambda column, row: 30.0 * column + 40.0 * row))
    cut = profile(at(), grid, (0.5, 0.25), (3.5, 4.25))
    assert cut.exact
    assert cut.length == pytest.approx(500.0)
    assert cut.rise == pytest.approx(90.0 + 160.0)
    assert cut.fall == 0.0
    slope = math.degrees(math.atan2(250.0, 500.0))
    assert cut.steepest_slope == pytest.approx(slope)
    assert cut.mean_slope == pytest.approx(slope)
    assert all(point.slope == pytest.approx(slope) for point in cut.points[1:])
    assert cut.points[0].slope is None
    back = profile(at(), grid, (3.5, 4.25), (0.5, 0.25))
    assert back.rise == 0.0
    assert back.fall == pytest.approx(250.0)
    assert back.points[1].slope == pytest.approx(-slope)


def test_every_column_row_and_diagonal_is_a_point() -> None:
    grid = grid_of(shaped(3, 3, lambda column, row: float(column * row)))
    cut = profile(at(), grid, (0.0, 0.5), (2.0, 0.5))
    assert [point.column for point in cut.points] == [0.0, 0.5, 1.0, 1.5, 2.0]
    assert [point.elevation for point in cut.points] == [0.0, 0.5, 0.5, 1.0, 1.0]


@settings(deadline=None, max_examples=100)
@given(
    start=st.tuples(st.floats(0.0, 7.0), st.floats(0.0, 5.0)),
    end=st.tuples(st.floats(0.0, 7.0), st.floats(0.0, 5.0)),
    share=st.floats(0.0, 1.0),
)
def test_the_ground_between_two_points_is_straight(
    start: tuple[float, float], end: tuple[float, float], share: float
) -> None:
    grid = grid_of(shaped(6, 8, lambda column, row: float((column * 37 + row * 91) % 23)))
    points = profile(at(), grid, start, end).points
    assert (points[0].column, points[0].row) == start
    assert (points[-1].column, points[-1].row) == end
    for first, last in pairwise(points):
        column = first.column + share * (last.column - first.column)
        row = first.row + share * (last.row - first.row)
        surface = grid.elevation_at(min(column, 7.0) * 100.0, -min(row, 5.0) * 100.0)
        assert first.elevation is not None
        assert last.elevation is not None
        between = first.elevation + share * (last.elevation - first.elevation)
        assert surface == pytest.approx(between, abs=1e-6)


def test_a_cliff_is_as_steep_as_it_is() -> None:
    grid = grid_of(shaped(3, 4, lambda column, row: 5000.0 if column >= 2 else 0.0))
    cut = profile(at(), grid, (0.0, 1.0), (3.0, 1.0))
    assert [point.elevation for point in cut.points] == [0.0, 0.0, 5000.0, 5000.0]
    assert cut.steepest_slope == pytest.approx(math.degrees(math.atan(50.0)))
    assert cut.mean_slope == pytest.approx(math.degrees(math.atan2(5000.0, 300.0)))


def test_a_void_is_no_ground() -> None:
    rows = shaped(3, 6, lambda column, row: float(column))
    rows[1][2] = VOID
    cut = profile(at(), grid_of(rows), (0.0, 1.0), (5.0, 1.0))
    assert [(point.column, point.elevation) for point in cut.points] == [
        (0.0, 0.0),
        (1.0, 1.0),
        (2.0, None),
        (3.0, 3.0),
        (4.0, 4.0),
        (5.0, 5.0),
    ]
    assert [point.slope is None for point in cut.points] == [True, False, True, True, False, False]
    assert cut.void_length == pytest.approx(200.0)
    assert cut.length == pytest.approx(500.0)
    assert cut.rise == pytest.approx(3.0)


def test_a_hole_between_two_edges_with_ground_is_not_bridged() -> None:
    rows = shaped(3, 5, lambda column, row: 0.0)
    rows[0][2] = VOID
    cut = profile(at(), grid_of(rows), (1.0, 0.5), (3.0, 0.5))
    # Cell 1 has lost what is north-east of its diagonal, cell 2 all but the far side of its own: nothing.
    assert [(point.column, point.elevation) for point in cut.points] == [
        (1.0, 0.0),
        (1.5, 0.0),
        (2.0, None),
        (2.5, None),
        (3.0, 0.0),
    ]
    assert cut.void_length == pytest.approx(150.0)


@pytest.mark.parametrize("most_points", [20000, 4])
def test_a_void_between_two_places_with_ground_gets_a_point_of_its_own(most_points: int) -> None:
    rows = shaped(4, 4, lambda column, row: 7.0)
    rows[0][1] = rows[2][2] = VOID  # on either side of the edge from (1, 1) to (2, 1)
    cut = profile(at(), grid_of(rows), (0.0, 1.0), (3.0, 1.0), most_points)
    assert cut.exact == (most_points > 4)
    assert [(point.column, point.elevation) for point in cut.points] == [
        (0.0, 7.0),
        (1.0, 7.0),
        (1.5, None),
        (2.0, 7.0),
        (3.0, 7.0),
    ]
    assert [point.slope for point in cut.points] == [None, 0.0, None, None, 0.0]
    assert cut.void_length == pytest.approx(100.0)


def test_beside_the_map_is_a_void() -> None:
    grid = grid_of(shaped(3, 3, lambda column, row: 1.0))
    cut = profile(at(), grid, (-2.0, 1.0), (4.0, 1.0))
    assert cut.length == pytest.approx(600.0)
    assert cut.void_length == pytest.approx(400.0)
    nowhere = profile(at(), grid, (10.0, 10.0), (12.0, 10.0))
    assert all(point.elevation is None for point in nowhere.points)
    assert (nowhere.rise, nowhere.steepest_slope, nowhere.mean_slope) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("start", "end"),
    [
        ((0.0, 0.0), (4.0, 0.0)),
        ((0.0, 3.0), (4.0, 3.0)),
        ((0.0, 0.0), (0.0, 3.0)),
        ((4.0, 0.0), (4.0, 3.0)),
        ((0.0, 0.0), (3.0, 3.0)),
    ],
)
def test_the_maps_edges_and_diagonals_have_ground(
    start: tuple[float, float], end: tuple[float, float]
) -> None:
    grid = grid_of(shaped(4, 5, lambda column, row: float(column + row)))
    cut = profile(at(), grid, start, end)
    assert cut.void_length == 0.0
    assert cut.rise == pytest.approx(end[0] + end[1] - start[0] - start[1])


def test_a_profile_of_no_length_is_a_point() -> None:
    grid = grid_of(shaped(3, 3, lambda column, row: 12.0))
    cut = profile(at(), grid, (1.3, 1.7), (1.3, 1.7))
    assert [point.elevation for point in cut.points] == [12.0]
    assert (cut.length, cut.rise, cut.fall, cut.steepest_slope, cut.mean_slope) == (0.0,) * 5


def test_a_globe_is_crossed_at_its_seam_the_shorter_way() -> None:
    rows = shaped(18, 36, lambda column, row: float(column % 36))
    georeference = at(Geographic(), (5.0, 85.0), 10.0)
    cut = profile(georeference, grid_of(rows, wraps=True), (34.0, 8.5), (1.0, 8.5))
    assert cut.length == pytest.approx(1737400.0 * math.radians(30.0))
    assert cut.void_length == 0.0
    assert [point.elevation for point in cut.points if point.column == int(point.column)] == [
        34.0,
        35.0,
        0.0,
        1.0,
    ]


def test_metres_are_those_of_the_body_and_not_of_the_map() -> None:
    rows = shaped(11, 11, lambda column, row: 0.0)
    radius = MOON.semi_major
    north = radius * math.radians(60.0)
    stretched = profile(at(Equirectangular(), (0.0, north)), grid_of(rows), (0.0, 0.0), (10.0, 0.0))
    assert stretched.length == pytest.approx(1000.0 * math.cos(math.radians(60.0)), rel=1e-6)
    scaled = profile(at(TransverseMercator(scale_factor=0.5)), grid_of(rows), (0.0, 0.0), (0.0, 10.0))
    assert scaled.length == pytest.approx(2000.0, rel=1e-6)
    pole = profile(at(PolarStereographic(), (-500.0, 500.0)), grid_of(rows), (0.0, 5.0), (10.0, 5.0))
    assert pole.length == pytest.approx(1000.0, rel=1e-6)


def test_planetocentric_latitudes_of_an_ellipsoid_are_taken_as_such() -> None:
    rows = shaped(11, 11, lambda column, row: 0.0)
    georeference = at(Geographic(), (0.0, 45.0), 0.1, MARS)
    cut = profile(georeference, grid_of(rows), (0.0, 0.0), (0.0, 10.0))
    # In polar coordinates: r(theta) = a b / hypot(a sin, b cos), integrated along the degree.
    a, b = MARS.semi_major, MARS.semi_minor

    def place(angle: float) -> tuple[float, float]:
        radius = a * b / math.hypot(a * math.sin(angle), b * math.cos(angle))
        return radius * math.cos(angle), radius * math.sin(angle)

    steps = [place(math.radians(44.0 + number / 10000.0)) for number in range(10001)]
    along = math.fsum(math.dist(first, last) for first, last in pairwise(steps))
    assert cut.length == pytest.approx(along, rel=1e-7)


def test_a_long_line_is_sampled_evenly_and_says_so() -> None:
    grid = grid_of(shaped(3, 3000, lambda column, row: float(column)))
    cut = profile(at(), grid, (0.0, 0.5), (2999.0, 0.5), most_points=101)
    assert not cut.exact
    assert len(cut.points) == 101
    assert cut.length == pytest.approx(299900.0)
    assert cut.rise == pytest.approx(2999.0)
    endless = profile(at(), grid, (-1e300, 0.5), (1e300, 0.5), most_points=11)
    assert len(endless.points) <= 12


@pytest.mark.parametrize("place", [(math.nan, 0.0), (0.0, math.inf)])
def test_places_that_are_no_numbers_are_refused(place: tuple[float, float]) -> None:
    grid = grid_of(shaped(2, 2, lambda column, row: 0.0))
    with pytest.raises(ValueError, match="finite"):
        profile(at(), grid, place, (1.0, 1.0))
    with pytest.raises(ValueError, match="2 or more"):
        profile(at(), grid, (0.0, 0.0), (1.0, 1.0), most_points=1)
