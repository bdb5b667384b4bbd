"""What a person wants of a take."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    import bpy

TrailKind = Literal["TUBE", "CURVE", "POINTS"]

DEFAULT_TRAILS: frozenset[TrailKind] = frozenset({"TUBE"})

BOUND_MM = 1.0
"""Millimetres of the hand's motion: less than a hand can place."""


@dataclass(frozen=True)
class TakeOptions:
    """How a take is written."""

    start_frame: int
    """Of the first tick."""
    reduced: bool = False
    """Whether keys are left out where the point stays within ``bound_mm`` without them."""
    bound_mm: float = BOUND_MM
    """Millimetres of the hand's motion, as far as the window had them at each tick."""
    trails: frozenset[TrailKind] = DEFAULT_TRAILS
    markers: bool = True
    """Whether the timeline tells where the hand panned and zoomed."""
    nla: bool = False
    """Whether the action is pushed down onto an NLA track."""
    keep_ticks: bool = True
    """Whether the take carries its ticks in the .blend file, for export and for more to be appended."""
    onto: bpy.types.Object | None = None
    """A take that gets these ticks; ``None`` makes a new one."""
    append: bool = False
    """Whether ``onto`` keeps what it has outside the time of these ticks; otherwise all is replaced."""
