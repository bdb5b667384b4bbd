"""The hand's script of the benches: a wandering hand that presses, slides and now and then lifts."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

Place = tuple[float, float, float]
"""Columns, rows, and height in cells."""

Height = Callable[[float, float], float]
"""Height of the surface in cells, exaggeration included, at (columns, rows)."""

JUST_ABOVE, DEEPEST = -0.2, 3.0
"""The hand's depth under the surface wanders between these, in cells."""


@dataclass(frozen=True)
class Field:
    """Where the hand wanders: cells; on a planet the columns have no end."""

    west: float
    east: float
    north: float
    south: float

    @property
    def middle(self) -> tuple[float, float]:
        """Column and row; of a field without ends, column 0."""
        columns = 0.0 if math.isinf(self.west) else (self.west + self.east) / 2
        return columns, (self.north + self.south) / 2


def wander(field: Field, height: Height, speed: float, updates: int, seed: int) -> Iterator[Place]:
    """Goals ``speed`` cells apart over the ground, from just above to a few cells under a smoothed surface.

    A hand cannot follow every bump: its height follows the surface by half in each update. How deep it
    presses changes slowly against the updates, as a hand of a few hertz does in a loop of 1 kHz.
    """
    chance = random.Random(seed)
    columns, rows = field.middle
    heading = chance.uniform(0.0, math.tau)
    turn = 0.0
    press = chance.random()
    smoothed = height(columns, rows)
    for _ in range(updates):
        turn = 0.98 * turn + chance.gauss(0.0, 0.004)
        heading += turn
        columns += speed * math.cos(heading)
        rows += speed * math.sin(heading)
        if not field.west <= columns <= field.east:
            columns = reflect(columns, field.west, field.east)
            heading = math.pi - heading
        if not field.north <= rows <= field.south:
            rows = reflect(rows, field.north, field.south)
            heading = -heading
        press = min(max(press + chance.gauss(0.0, 0.01), 0.0), 1.0)
        smoothed += 0.5 * (height(columns, rows) - smoothed)
        # Squared, so that light pressing is more common than deep.
        yield columns, rows, smoothed - (JUST_ABOVE + (DEEPEST - JUST_ABOVE) * press * press)


def above(field: Field, height: Height, speed: float, updates: int, seed: int) -> Iterator[Place]:
    """The same way over the ground, ten cells above it."""
    for columns, rows, _ in wander(field, height, speed, updates, seed):
        yield columns, rows, height(columns, rows) + 10.0


def reflect(place: float, low: float, high: float) -> float:
    """``place`` thrown back at both ends."""
    place = (place - low) % (2 * (high - low))
    return low + min(place, 2 * (high - low) - place)
