"""What a contact should be, by brute force in plain Python: it shares nothing with the native models but the
samples and the diagonal of a cell.

Places are (columns, rows, height), all in cells, exaggeration included.
"""

from __future__ import annotations

import math
from collections.abc import Callable

Vector = tuple[float, float, float]

Sample = Callable[[int, int], float]
"""Height in cells of the sample at (column, row)."""

ROUNDING = 1e-9
"""Of a cell, and of the relief around: what is this near is the same."""

AHEAD = 1e-3
"""Cells over the ground that a way has to be free."""


class Oracle:
    """Judges contacts on a grid whose cells are ``cell_height`` widths of a cell high."""

    def __init__(self, sample: Sample, cell_height: float = 1.0) -> None:
        self.sample = sample
        self.cell_height = cell_height

    def height(self, columns: float, rows: float) -> float:
        """Height of the surface."""
        column, row = math.floor(columns), math.floor(rows)
        u, v = columns - column, rows - row
        corner, opposite = self.sample(column, row), self.sample(column + 1, row + 1)
        if u >= v:
            beside = self.sample(column + 1, row)
            return corner + u * (beside - corner) + v * (opposite - beside)
        below = self.sample(column, row + 1)
        return corner + v * (below - corner) + u * (opposite - below)

    def depth(self, proxy: Vector) -> float:
        """How far the proxy is under the surface; above it, less than 0."""
        return self.height(proxy[0], proxy[1]) - proxy[2]

    def relief(self, proxy: Vector) -> float:
        """The largest height around the proxy against its own, for what rounding may do."""
        column, row = math.floor(proxy[0]), math.floor(proxy[1])
        corners = [self.sample(column + u, row + v) for u in (0, 1) for v in (0, 1)]
        return max(abs(proxy[2]), *(abs(corner) for corner in corners))

    def is_minimum(self, proxy: Vector, goal: Vector) -> bool:
        """Whether a proxy in contact can come no nearer to the goal where it is."""
        distance = self.distance(proxy, goal)
        nearer = distance - ROUNDING * (distance + 1.0)
        here, there = self._even(proxy), self._even(goal)
        for triangle in self._triangles_holding(proxy):
            closest = closest_on_triangle(there, tuple(self._even(corner) for corner in triangle))
            if math.dist(closest, there) < nearer:
                return False
        return not self._is_free(proxy, goal, math.dist(here, there))

    def distance(self, one: Vector, other: Vector) -> float:
        """As the hand measures it, in widths of a cell."""
        return math.dist(self._even(one), self._even(other))

    def _even(self, place: Vector) -> Vector:
        return place[0], place[1] * self.cell_height, place[2]

    def _triangles_holding(self, proxy: Vector) -> list[tuple[Vector, Vector, Vector]]:
        """Those whose shadow on the ground holds the proxy's, borders included."""
        near_column, near_row = math.floor(proxy[0]), math.floor(proxy[1])
        holding = []
        for column in range(near_column - 1, near_column + 2):
            for row in range(near_row - 1, near_row + 2):
                u, v = proxy[0] - column, proxy[1] - row
                if not (-ROUNDING <= u <= 1 + ROUNDING and -ROUNDING <= v <= 1 + ROUNDING):
                    continue
                corner, opposite = self._corner(column, row), self._corner(column + 1, row + 1)
                if u - v >= -ROUNDING:
                    holding.append((corner, self._corner(column + 1, row), opposite))
                if v - u >= -ROUNDING:
                    holding.append((corner, opposite, self._corner(column, row + 1)))
        return holding

    def _corner(self, column: int, row: int) -> Vector:
        return float(column), float(row), self.sample(column, row)

    def _is_free(self, proxy: Vector, goal: Vector, distance: float) -> bool:
        """Whether a short step straight toward the goal leads above the surface."""
        across = max(abs(goal[0] - proxy[0]), abs(goal[1] - proxy[1]), 1e-300)
        share = min(AHEAD / across, 1.0)
        ahead = [start + share * (end - start) for start, end in zip(proxy, goal, strict=True)]
        rounding = max(ROUNDING * (distance + 1.0), 1e-7 * share * distance)
        return ahead[2] > self.height(ahead[0], ahead[1]) + rounding


def closest_on_triangle(point: Vector, triangle: tuple[Vector, ...]) -> Vector:
    """The foot on the plane where that is inside, else the closest of the edges' closest points."""
    a, b, c = triangle
    ab, ac, ap = minus(b, a), minus(c, a), minus(point, a)
    bb, bc, cc = dot(ab, ab), dot(ab, ac), dot(ac, ac)
    pb, pc = dot(ap, ab), dot(ap, ac)
    determinant = bb * cc - bc * bc
    if determinant > 0.0:
        s, t = (pb * cc - pc * bc) / determinant, (pc * bb - pb * bc) / determinant
        if s >= 0.0 and t >= 0.0 and s + t <= 1.0:
            return (
                a[0] + s * ab[0] + t * ac[0],
                a[1] + s * ab[1] + t * ac[1],
                a[2] + s * ab[2] + t * ac[2],
            )
    candidates = [closest_on_edge(point, *edge) for edge in ((a, b), (b, c), (c, a))]
    return min(candidates, key=lambda candidate: math.dist(candidate, point))


def closest_on_edge(point: Vector, start: Vector, end: Vector) -> Vector:
    """The closest point of a straight line between two points."""
    way = minus(end, start)
    share = min(max(dot(minus(point, start), way) / dot(way, way), 0.0), 1.0)
    return start[0] + share * way[0], start[1] + share * way[1], start[2] + share * way[2]


def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a: Vector, b: Vector) -> float:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
