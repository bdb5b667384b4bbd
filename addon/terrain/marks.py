"""Two marked places of a terrain, A and B, and what lies between them, kept as its ID properties."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal

import bpy

from ..formats.georeference_properties import restored

KEY = "haptic_terrain_marks"
"""Of the ID property group on a terrain object."""

MarkName = Literal["A", "B"]

BETWEEN = "between"

Place = tuple[float, float]
"""Fractional column and row."""


@dataclass(frozen=True)
class Between:
    """From A to B."""

    length: float
    """Metres along the ground at elevation 0."""
    difference: float | None
    """Metres that B is higher than A; ``None`` where one of them is in a void."""
    rise: float
    fall: float
    """Metres climbed and descended in all."""
    mean_slope: float
    steepest_slope: float
    """Degrees."""
    void_length: float
    """Metres of the way that have no data."""

    @property
    def slope(self) -> float | None:
        """Degrees of the straight line from A to B, above 0 uphill."""
        if self.difference is None or self.length <= 0.0:
            return None
        return math.degrees(math.atan2(self.difference, self.length))


@dataclass(frozen=True)
class Marks:
    """What is marked."""

    a: Place | None = None
    b: Place | None = None
    between: Between | None = None


def set_mark(terrain: bpy.types.Object, name: MarkName, place: Place) -> None:
    """Mark a place; what was between the marks before is forgotten."""
    marks = _kept(terrain)
    terrain[KEY] = {
        **{other: list(marks[other]) for other in ("A", "B") if other in marks},
        name: [float(number) for number in place],
    }


def set_between(terrain: bpy.types.Object, between: Between) -> None:
    """Keep what lies between the marks."""
    terrain[KEY][BETWEEN] = {name: value for name, value in asdict(between).items() if value is not None}


def marks_of(terrain: bpy.types.Object) -> Marks:
    """Read the marks; what was changed by hand is no mark."""
    kept = _kept(terrain)
    try:
        between = kept.get(BETWEEN)
        return Marks(
            a=_place(kept.get("A")),
            b=_place(kept.get("B")),
            between=restored(Between, {"difference": None, **between}) if between is not None else None,
        )
    except (KeyError, TypeError, ValueError):
        return Marks()


def nearest_turn(marks: Marks, columns: int, *, wraps: bool) -> tuple[Place, Place] | None:
    """A and B as the shorter way around the planet has them, where the map goes around."""
    if marks.a is None or marks.b is None:
        return None
    column, row = marks.b
    if wraps:
        half = columns / 2.0
        column = marks.a[0] + (column - marks.a[0] + half) % columns - half
    return marks.a, (column, row)


def _kept(terrain: bpy.types.Object) -> Mapping[str, Any]:
    kept = terrain.get(KEY)
    return kept.to_dict() if hasattr(kept, "to_dict") else {}


def _place(kept: Any) -> Place | None:
    if kept is None:
        return None
    column, row = (float(number) for number in kept)
    if not (math.isfinite(column) and math.isfinite(row)):
        raise ValueError("a mark is not finite")
    return column, row
