"""A cut through the terrain between two places of a grid: distance along the ground, height and slope.

The line is straight in the grid. Its points are where it crosses the edges of the triangulated surface,
so the ground between two of them is straight and nothing is left out. A line with more crossings than
points are wanted is sampled evenly instead, and ``Profile.exact`` says so.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ..body.distance import distance
from ..body.latitudes import to_planetographic
from ..georeference import Georeference
from ..projections import Coordinates
from .triangle_plane import ON_AN_EDGE, Heights, Place, plane_under

MOST_POINTS = 20_000
"""Of a profile, unless the caller wants fewer."""

_Ends = tuple[float | None, float | None]
"""Heights at both ends of the line; ``None`` where there is no ground."""


@dataclass(frozen=True)
class ProfilePoint:
    """A place on the way."""

    column: float
    row: float
    distance: float
    """True metres from the first point along the body's surface at elevation 0, not the map's metres."""
    elevation: float | None
    """Metres; ``None`` in a void or off the map."""
    slope: float | None
    """Degrees of the ground that led here from the point before, above 0 uphill; ``None`` over a void."""


@dataclass(frozen=True)
class Profile:
    """The points in order, and what they come to."""

    points: tuple[ProfilePoint, ...]
    exact: bool
    """Whether every bend of the surface is a point; else the line was sampled evenly."""
    length: float
    """Metres along the ground, voids included."""
    void_length: float
    """Metres of it over voids or off the map."""
    rise: float
    """Metres climbed in all."""
    fall: float
    """Metres descended in all, above 0."""
    steepest_slope: float
    """Degrees, up or down, above 0; 0 where there is no ground."""
    mean_slope: float
    """Degrees whose tangent is all rise and fall over the length that has ground; 0 where there is none."""


@dataclass(frozen=True)
class _Stretch:
    """From one point of the line to the next."""

    start: Place
    end: Place
    metres: float
    """Along the ground."""
    heights: tuple[float, float] | None
    """At start and end; ``None`` over a void."""

    @property
    def middle(self) -> Place:
        return (self.start[0] + self.end[0]) / 2.0, (self.start[1] + self.end[1]) / 2.0

    @property
    def slope(self) -> float | None:
        """Degrees; 90 where a height changes over no distance at all."""
        if self.heights is None:
            return None
        return math.degrees(math.atan2(self.heights[1] - self.heights[0], self.metres))


def profile(
    georeference: Georeference, grid: Heights, start: Place, end: Place, most_points: int = MOST_POINTS
) -> Profile:
    """Cut the terrain along a straight line of the grid; around a globe the shorter way.

    Args:
        grid: a ``proxygraph.Grid``.
        start, end: fractional column and row; what lies off the map is a void.
        most_points: at least 2; a void narrower than a cell may add a point in its middle.

    Raises:
        ValueError: a place is not finite, or ``most_points`` is below 2.
    """
    if not all(math.isfinite(number) for number in (*start, *end)):
        raise ValueError(f"profile: found {start} to {end}, expected finite columns and rows")
    if most_points < 2:
        raise ValueError(f"profile: found {most_points} points at most, expected 2 or more")
    if grid.layout.wraps:
        end = start[0] + math.remainder(end[0] - start[0], grid.layout.columns), end[1]
    ends = _height(grid, start), _height(grid, end)
    if start == end:
        return _summed(start, [], ends, exact=True)
    exact = _most_crossings(start, end) + 2 <= most_points
    places = _bends(start, end) if exact else _evenly(start, end, most_points)
    stretches = _stretches(georeference, grid, places, exact)
    return _summed(start, stretches, ends, exact)


def _most_crossings(start: Place, end: Place) -> float:
    """How many edges of triangles a line may cross: columns, rows and diagonals."""
    across, down = end[0] - start[0], end[1] - start[1]
    return abs(across) + abs(down) + abs(across - down) + 3.0


def _bends(start: Place, end: Place) -> list[Place]:
    """The ends of a line, and where it crosses edges of triangles."""
    directions = (
        (start[0], end[0]),
        (start[1], end[1]),
        (start[0] - start[1], end[0] - end[1]),  # whole numbers on the cells' diagonals
    )
    shares = sorted(share for first, last in directions for share in _shares_of_whole_numbers(first, last))
    cells = math.hypot(end[0] - start[0], end[1] - start[1])
    kept = [0.0]
    for share in shares:
        # At a sample three edges meet, and rounding sets them apart.
        if (share - kept[-1]) * cells > ON_AN_EDGE and (1.0 - share) * cells > ON_AN_EDGE:
            kept.append(share)
    return [*(_between(start, end, share) for share in kept), end]


def _shares_of_whole_numbers(first: float, last: float) -> list[float]:
    """How far along from one number to another the whole numbers lie, from 0 to 1."""
    if first == last:
        return []
    low, high = min(first, last), max(first, last)
    return [(whole - first) / (last - first) for whole in range(math.ceil(low), math.floor(high) + 1)]


def _evenly(start: Place, end: Place, points: int) -> list[Place]:
    return [*(_between(start, end, number / (points - 1)) for number in range(points - 1)), end]


def _between(start: Place, end: Place, share: float) -> Place:
    return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])


def _stretches(
    georeference: Georeference, grid: Heights, places: Sequence[Place], exact: bool
) -> list[_Stretch]:
    """The ways from each place to the next."""
    on_body = [_on_body(georeference, place) for place in places]
    heights = [None if exact else _height(grid, place) for place in places]
    stretches = []
    for number, (start, end) in enumerate(pairwise(places)):
        metres = _ground(georeference, grid, start, end, on_body[number], on_body[number + 1])
        plane = plane_under(grid, ((start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0))
        ends: tuple[float, float] | None = None
        if plane is not None and exact:
            ends = plane.height(start), plane.height(end)
        elif plane is not None:
            first, last = heights[number], heights[number + 1]
            ends = None if first is None or last is None else (first, last)
        stretches.append(_Stretch(start, end, metres, ends))
    return stretches


def _height(grid: Heights, place: Place) -> float | None:
    plane = plane_under(grid, place)
    return None if plane is None else plane.height(place)


def _on_body(georeference: Georeference, place: Place) -> Coordinates | None:
    """Longitude and planetographic latitude, which distances are measured by."""
    found = georeference.longitude_latitude(*place)
    # A map in degrees has latitudes as the file means them; projections in metres give planetographic ones.
    if found is None or not georeference.projection.in_degrees:
        return found
    if georeference.latitude_kind == "planetographic":
        return found
    return found[0], to_planetographic(found[1], georeference.ellipsoid)


def _ground(
    georeference: Georeference,
    grid: Heights,
    start: Place,
    end: Place,
    from_place: Coordinates | None,
    to_place: Coordinates | None,
) -> float:
    """Metres on the body; the map's own where the place on the body is not known."""
    if from_place is not None and to_place is not None:
        metres = distance(from_place, to_place, georeference.ellipsoid)
        if metres is not None:
            return metres
    layout = grid.layout
    return math.hypot((end[0] - start[0]) * layout.cell_width, (end[1] - start[1]) * layout.cell_height)


def _summed(start: Place, stretches: Sequence[_Stretch], ends: _Ends, exact: bool) -> Profile:
    """Points and totals."""
    solid = [stretch for stretch in stretches if stretch.heights is not None]
    climbs = [stretch.heights[1] - stretch.heights[0] for stretch in solid if stretch.heights is not None]
    rise = math.fsum(climb for climb in climbs if climb > 0.0)
    fall = -math.fsum(climb for climb in climbs if climb < 0.0)
    length = math.fsum(stretch.metres for stretch in stretches)
    solid_length = math.fsum(stretch.metres for stretch in solid)
    slopes = [abs(stretch.slope) for stretch in solid if stretch.slope is not None]
    return Profile(
        points=tuple(_points(start, stretches, ends)),
        exact=exact,
        length=length,
        void_length=math.fsum(stretch.metres for stretch in stretches if stretch.heights is None),
        rise=rise,
        fall=abs(fall),  # not -0
        steepest_slope=max(slopes, default=0.0),
        mean_slope=math.degrees(math.atan2(rise + fall, solid_length)),
    )


def _points(start: Place, stretches: Sequence[_Stretch], ends: _Ends) -> list[ProfilePoint]:
    """The line's places; a void between two places that have ground gets a point of its own."""
    points = [ProfilePoint(*start, distance=0.0, elevation=ends[0], slope=None)]
    travelled = 0.0
    # What the ground begins with after each stretch.
    onward = [None if stretch.heights is None else stretch.heights[0] for stretch in stretches[1:]]
    for stretch, following in zip(stretches, [*onward, ends[1]][: len(stretches)], strict=True):
        elevation = following if stretch.heights is None else stretch.heights[1]
        if stretch.heights is None and points[-1].elevation is not None and elevation is not None:
            halfway = travelled + stretch.metres / 2.0
            points.append(ProfilePoint(*stretch.middle, distance=halfway, elevation=None, slope=None))
        travelled += stretch.metres
        points.append(
            ProfilePoint(*stretch.end, distance=travelled, elevation=elevation, slope=stretch.slope)
        )
    return points
