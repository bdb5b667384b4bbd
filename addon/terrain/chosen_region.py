"""The part of a grid that is wanted: by longitude and latitude, or by rows and columns; without Blender."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass

from ..formats import ElevationGrid, FormatError, Region

ROUNDING = 0.02
"""Cells that a limit may miss a sample by at the least: limits are written with some decimals only."""

MOST_ROUNDING = 0.5
"""Cells: a sample further away than that is not the one that was meant."""

SINGLE_BITS = 24
"""Of a number's digits in Blender's properties, which limits come through."""

LATTICE = 65
"""Places along each side of a box that are looked up on a map in metres, where a box has curved sides."""


@dataclass(frozen=True)
class LongitudeLatitudeBox:
    """Degrees; longitudes of any turn, eastward from ``west`` to ``east``; latitudes of the grid's kind."""

    west: float
    east: float
    south: float
    north: float

    @property
    def width(self) -> float:
        """Degrees of longitude, above 0 and up to 360; the same west and east is all around."""
        return (self.east - self.west) % 360.0 or 360.0

    def __str__(self) -> str:
        return f"{self.west:g} to {self.east:g} E, {self.south:g} to {self.north:g} N"


@dataclass(frozen=True)
class RowsAndColumns:
    """Samples, counted from 0 in the north-west corner; 0 columns or rows are all that follow."""

    first_column: int
    first_row: int
    columns: int
    rows: int

    def __str__(self) -> str:
        return (
            f"{self.columns or 'all'} columns from {self.first_column}, "
            f"{self.rows or 'all'} rows from {self.first_row}"
        )


ChosenRegion = LongitudeLatitudeBox | RowsAndColumns


def region_properties(region: ChosenRegion) -> dict[str, float]:
    """Write a choice out as doubles, which hold every number of samples that a file can have."""
    return {name: float(value) for name, value in asdict(region).items()}


def region_from(kept: Mapping[str, float]) -> ChosenRegion:
    """Read a choice.

    Raises:
        KeyError, TypeError, ValueError: it was changed by hand.
    """
    if "west" in kept:
        return LongitudeLatitudeBox(**{name: float(value) for name, value in kept.items()})
    return RowsAndColumns(**{name: int(value) for name, value in kept.items()})


def cut_grid(grid: ElevationGrid, chosen: ChosenRegion | None) -> ElevationGrid:
    """The same file, of which only the chosen part is ever read.

    Raises:
        FormatError: the grid has no such part.
    """
    if chosen is None:
        return grid
    region = _region(grid, chosen)
    if region is not None:
        try:
            return grid.region(region)
        except ValueError:
            pass
    raise FormatError(
        grid.path,
        "region",
        found=chosen,
        expected=f"at least 2 rows and 2 columns within {_extent(grid)}",
        way_out="Choose another region, or the whole grid.",
    )


def _region(grid: ElevationGrid, chosen: ChosenRegion) -> Region | None:
    if isinstance(chosen, RowsAndColumns):
        return Region(
            chosen.first_column,
            chosen.first_row,
            chosen.columns or grid.layout.columns - chosen.first_column,
            chosen.rows or grid.layout.rows - chosen.first_row,
        )
    if not all(map(math.isfinite, (chosen.west, chosen.east, chosen.south, chosen.north))):
        return None
    if chosen.south >= chosen.north:
        return None
    if grid.georeference.projection.in_degrees:
        return _region_in_degrees(grid, chosen)
    return _region_on_projection(grid, chosen)


def _region_in_degrees(grid: ElevationGrid, box: LongitudeLatitudeBox) -> Region | None:
    """The samples within the box."""
    place, layout = grid.georeference, grid.layout
    north, south = _reach(box.north, place.step_y), _reach(box.south, place.step_y)
    first_row = max(0, math.ceil((place.first_y - box.north) / place.step_y - north))
    last_row = min(layout.rows - 1, math.floor((place.first_y - box.south) / place.step_y + south))
    if layout.wraps:
        # Columns may run on beyond the last one, which is how a region crosses the seam.
        west = (box.west - place.first_x) % 360.0
        first, last = _columns(west, box, place.step_x)
        count = min(last - first + 1, layout.columns)
        return Region(first % layout.columns, first_row, count, last_row - first_row + 1)
    east_edge = (layout.columns - 1) * place.step_x
    # The turn of longitude in which most of the box is on the map.
    west_edges = [(box.west - place.first_x) % 360.0 - turn for turn in (0.0, 360.0)]
    west_edge = max(west_edges, key=lambda edge: min(edge + box.width, east_edge) - max(edge, 0.0))
    first, last = _columns(west_edge, box, place.step_x)
    first, last = max(0, first), min(layout.columns - 1, last)
    return Region(first, first_row, last - first + 1, last_row - first_row + 1)


def _region_on_projection(grid: ElevationGrid, box: LongitudeLatitudeBox) -> Region | None:
    """The smallest rectangle of samples around what the map shows of the box."""
    layout = grid.layout
    places = [
        place
        for longitude, latitude in _lattice(box)
        if (place := grid.georeference.column_row(longitude, latitude, layout.columns)) is not None
    ]
    if not places:
        return None
    columns, rows = zip(*places, strict=True)
    first, last = max(0, math.floor(min(columns))), min(layout.columns - 1, math.ceil(max(columns)))
    first_row, last_row = max(0, math.floor(min(rows))), min(layout.rows - 1, math.ceil(max(rows)))
    return Region(first, first_row, last - first + 1, last_row - first_row + 1)


def _lattice(box: LongitudeLatitudeBox) -> Iterator[tuple[float, float]]:
    for across in range(LATTICE):
        for up in range(LATTICE):
            yield (
                box.west + box.width * across / (LATTICE - 1),
                box.south + (box.north - box.south) * up / (LATTICE - 1),
            )


def _columns(west: float, box: LongitudeLatitudeBox, step: float) -> tuple[int, int]:
    """The first and the last column within a box that begins ``west`` degrees from column 0."""
    first = math.ceil(west / step - _reach(box.west, step))
    return first, math.floor((west + box.width) / step + _reach(box.east, step))


def _reach(limit: float, step: float) -> float:
    """Cells of ``step`` degrees that a limit may miss a sample by: what 32 bits lose, or a little more."""
    _mantissa, exponent = math.frexp(limit)
    spacing = math.ldexp(1.0, exponent - SINGLE_BITS)
    return min(max(ROUNDING, spacing / step), MOST_ROUNDING)


def _extent(grid: ElevationGrid) -> str:
    """The whole grid in words."""
    layout, place = grid.layout, grid.georeference
    size = f"{layout.columns:,} columns and {layout.rows:,} rows"
    if not place.projection.in_degrees:
        return size
    west, east = place.x(0), place.x(layout.columns - 1)
    return f"{size}, {west:g} to {east:g} E, {place.y(layout.rows - 1):g} to {place.y(0):g} N"
