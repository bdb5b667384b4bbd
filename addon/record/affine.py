"""Affine matrices in doubles; without Blender, whose own are of 32 bits.

Sums are written out, in one order: what is baked must have the same bits on every machine, and a library's
product may add in any order.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

Point = tuple[float, float, float]
Rows = tuple[Point, Point, Point]


@dataclass(frozen=True)
class Affine:
    """Takes a point to ``linear`` times it, plus ``shift``."""

    linear: Rows
    shift: Point

    @staticmethod
    def of(matrix: Any) -> Affine:
        """Take the three upper rows of a 4 x 4 matrix of Blender's."""
        (a, b, c, x), (d, e, f, y), (g, h, i, z), _last = matrix
        return Affine(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))

    @property
    def is_finite(self) -> bool:
        """Whether all its numbers are."""
        return all(map(math.isfinite, (*self.linear[0], *self.linear[1], *self.linear[2], *self.shift)))

    def point(self, place: Iterable[float]) -> Point:
        """Where a point comes to."""
        x, y, z = self.direction(place)
        return x + self.shift[0], y + self.shift[1], z + self.shift[2]

    def direction(self, vector: Iterable[float]) -> Point:
        """What becomes of a vector."""
        a, b, c = vector
        x, y, z = (row[0] * a + row[1] * b + row[2] * c for row in self.linear)
        return x, y, z

    def column(self, number: int) -> Point:
        """What becomes of an axis."""
        return self.linear[0][number], self.linear[1][number], self.linear[2][number]

    def inverse(self) -> Affine:
        """The way back.

        Raises:
            ZeroDivisionError: it flattens space.
        """
        (a, b, c), (d, e, f), (g, h, i) = self.linear
        one, two, three = e * i - f * h, f * g - d * i, d * h - e * g
        whole = a * one + b * two + c * three
        linear = (
            (one / whole, (c * h - b * i) / whole, (b * f - c * e) / whole),
            (two / whole, (a * i - c * g) / whole, (c * d - a * f) / whole),
            (three / whole, (b * g - a * h) / whole, (a * e - b * d) / whole),
        )
        x, y, z = Affine(linear, (0.0, 0.0, 0.0)).direction(self.shift)
        return Affine(linear, (-x, -y, -z))
