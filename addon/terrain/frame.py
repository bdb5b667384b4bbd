"""Between the terrain frame (metres) and the terrain object's own coordinates (Blender units)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

from proxygraph import GridLayout

from .bend import Bend

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

Point = tuple[float, float, float]

Metres = TypeVar("Metres", float, "npt.NDArray[np.float64]")
"""One place, or many at once."""

LONGEST_SIDE = 10.0
"""Blender units: large enough to work with, small enough for the default clip distances."""

RELIEF_SHARE = 0.05
"""Of the longest side: relief that eye and hand notice, and that still looks like land."""


@dataclass(frozen=True)
class TerrainFrame:
    """The terrain frame's place inside the terrain object; what is seen is centred on its origin."""

    east: float
    north: float
    up: float
    """Terrain metres at the object's origin."""
    units_per_metre: float
    exaggeration: float
    """Of heights."""
    turn: float | None
    """Metres once around the planet; ``None`` on a map with edges."""
    bend: Bend | None = None
    """The sphere that the map is shown on; ``None`` shows it flat."""

    def to_object(self, east: Metres, north: Metres, up: Metres) -> tuple[Metres, Metres, Metres]:
        """Object coordinates of a terrain place; east runs on beyond the map and is brought back."""
        return self.shown(self.on_map(east), north, up)

    def shown(self, east: Metres, north: Metres, up: Metres) -> tuple[Metres, Metres, Metres]:
        """Object coordinates of a terrain place on the map, from its western to its eastern edge."""
        if self.bend is not None:
            x, y, z = self.bend.bent(east - self.east, north - self.north, (up - self.up) * self.exaggeration)
            return x * self.units_per_metre, y * self.units_per_metre, z * self.units_per_metre
        return (
            (east - self.east) * self.units_per_metre,
            (north - self.north) * self.units_per_metre,
            (up - self.up) * self.units_per_metre * self.exaggeration,
        )

    def to_terrain(self, x: float, y: float, z: float) -> Point:
        """Terrain metres of a place in object coordinates."""
        east, north = x / self.units_per_metre, y / self.units_per_metre
        up = z / self.units_per_metre
        if self.bend is not None:
            east, north, up = self.bend.flat(east, north, up)
        return self.east + east, self.north + north, self.up + up / self.exaggeration

    def on_map(self, east: Metres) -> Metres:
        """Terrain metres east, brought back onto a map that wraps."""
        return east if self.turn is None else east % self.turn

    def turns(self, east: float) -> int:
        """How many times around the planet a place lies; a change means that the seam was crossed."""
        return 0 if self.turn is None else math.floor(east / self.turn)


def map_size(layout: GridLayout) -> tuple[float, float]:
    """Metres east-west and north-south from the first sample to the last; once around where it wraps."""
    across = layout.columns if layout.wraps else layout.columns - 1
    return across * layout.cell_width, (layout.rows - 1) * layout.cell_height


def nearest_on_map(layout: GridLayout, place: Point) -> Point:
    """Bring a terrain place that is beside the map to its nearest edge; east runs on where the map wraps."""
    width, height = map_size(layout)
    east, north, up = place
    if not layout.wraps:
        east = min(max(east, 0.0), width)
    return east, max(min(north, 0.0), -height), up


def place_in_grid(layout: GridLayout, east: float, north: float) -> tuple[float, float]:
    """Fractional column and row of a terrain place."""
    return east / layout.cell_width, -north / layout.cell_height


def is_on_map(layout: GridLayout, east: float, north: float) -> bool:
    """Whether a terrain place is over the map; east runs on where the map wraps."""
    width, height = map_size(layout)
    return -height <= north <= 0.0 and (layout.wraps or 0.0 <= east <= width)


def map_centre(layout: GridLayout) -> tuple[float, float]:
    """Terrain metres east and north of the middle of the map."""
    width, height = map_size(layout)
    return width / 2.0, -height / 2.0


def terrain_frame(
    layout: GridLayout, minimum: float, maximum: float, *, units_per_metre: float, exaggeration: float
) -> TerrainFrame:
    """Centre the map; elevation 0 is at z = 0 where the map has it, else its lowest place is."""
    east, north = map_centre(layout)
    return TerrainFrame(
        east=east,
        north=north,
        up=0.0 if minimum <= 0.0 <= maximum else minimum,
        units_per_metre=units_per_metre,
        exaggeration=exaggeration,
        turn=map_size(layout)[0] if layout.wraps else None,
    )


def fitting_scale(layout: GridLayout) -> float:
    """Blender units per metre that make the longest side ``LONGEST_SIDE``."""
    return LONGEST_SIDE / max(map_size(layout))


def rounded_exaggeration(layout: GridLayout, minimum: float, maximum: float) -> float:
    """Choose 1, 2, 5, 10, 20, 50 ... so that relief is about ``RELIEF_SHARE`` of the longest side."""
    relief = maximum - minimum
    if relief <= 0.0:
        return 1.0
    wanted = RELIEF_SHARE * max(map_size(layout)) / relief
    if wanted <= 1.0:
        return 1.0
    decade = 10.0 ** math.floor(math.log10(wanted))
    return min(
        (step * decade for step in (1.0, 2.0, 5.0, 10.0)), key=lambda step: abs(math.log(step / wanted))
    )
