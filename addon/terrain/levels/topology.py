"""The vertices, edges and triangles of nested levels: one surface, with no edge open between its levels.

Each cell is split as touch splits it, from north-west to south-east. Where a cell borders on the next finer
level, that level's line ends in the middle of its side: the triangle at that side is split there in two.

No cell of a level has finer ones at its north and its east, or at its south and its west: those would
split the same triangle twice. The finer level is a rectangle, and on the seam's two sides two of equal rows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from .level import Level, Lines, Mask

Numbers = npt.NDArray[np.int32]


@dataclass(frozen=True)
class Topology:
    """What is connected to what."""

    own: tuple[Mask, ...]
    """Of each level, rows x columns: which of its samples are vertices that no finer level has. Vertices
    are numbered level by level, rows from the north, columns from the west."""
    edges: Numbers
    """Vertices, edges x 2."""
    triangles: Numbers
    """Vertices, triangles x 3, counter-clockwise from above."""
    triangle_edges: Numbers
    """Edges, triangles x 3: each from the vertex of its place to the next one."""

    @property
    def vertices(self) -> int:
        """How many."""
        return sum(int(own.sum()) for own in self.own)


def topology(levels: Sequence[Level]) -> Topology:
    """Connect the levels, from the finest on."""
    builder = _Builder()
    finer: _Numbered | None = None
    for level in levels:
        finer = builder.add(level, finer)
    return Topology(
        tuple(builder.own),
        np.concatenate(builder.edges),
        np.concatenate(builder.triangles),
        np.concatenate(builder.triangle_edges),
    )


@dataclass(frozen=True)
class _Numbered:
    """A level with the numbers that its samples and edges have; -1 where they have none."""

    level: Level
    columns: Lines
    rows: Lines
    vertices: Numbers
    """Rows x columns."""
    across: Numbers
    """Edges to the next column, rows x cells."""
    along: Numbers
    """Edges to the next row, cells x columns."""


@dataclass
class _Builder:
    own: list[Mask] = field(default_factory=list)
    edges: list[Numbers] = field(default_factory=list)
    triangles: list[Numbers] = field(default_factory=list)
    triangle_edges: list[Numbers] = field(default_factory=list)
    vertex_count: int = 0
    edge_count: int = 0

    def add(self, level: Level, finer: _Numbered | None) -> _Numbered:
        """Add a level around the finer one."""
        columns, rows = level.column_lines, level.row_lines
        shown = np.ones((len(rows) - 1, len(columns) - 1), dtype=bool)
        if level.gap is not None:
            shown[:, level.gap] = False
        hole = np.zeros_like(shown)
        if finer is not None:
            hole = finer.level.covers_cells(columns, rows)
            shown &= ~hole
        here = _Numbered(level, columns, rows, *_numbers_of(finer, columns, rows))
        self._number_vertices(here, shown)
        splits = {} if finer is None else _splits(here, finer, hole, shown)
        self._number_edges(here, shown, splits)
        self._add_triangles(here, shown, splits)
        return here

    def _number_vertices(self, here: _Numbered, shown: Mask) -> None:
        used = np.zeros(here.vertices.shape, dtype=bool)
        for corner in (used[:-1, :-1], used[:-1, 1:], used[1:, :-1], used[1:, 1:]):
            corner |= shown
        own = used & (here.vertices < 0)
        self.own.append(own)
        self.vertex_count = _number(here.vertices, own, self.vertex_count)

    def _number_edges(self, here: _Numbered, shown: Mask, splits: dict[str, _Split]) -> None:
        """Number the edges of the shown cells, apart from those that the finer level has or splits."""
        across = np.zeros(here.across.shape, dtype=bool)
        across[:-1] |= shown
        across[1:] |= shown
        along = np.zeros(here.along.shape, dtype=bool)
        along[:, :-1] |= shown
        along[:, 1:] |= shown
        for side, split in splits.items():
            row, column = split.row, split.column
            if side in ("north", "south"):
                across[row + (side == "south"), column] = False
            else:
                along[row, column + (side == "east")] = False
        for numbers, mask, ends in (
            (here.across, across & (here.across < 0), (here.vertices[:, :-1], here.vertices[:, 1:])),
            (here.along, along & (here.along < 0), (here.vertices[:-1], here.vertices[1:])),
        ):
            self.edge_count = _number(numbers, mask, self.edge_count)
            self.edges.append(np.stack((ends[0][mask], ends[1][mask]), axis=-1))

    def _new_edges(self, first: Numbers, second: Numbers) -> Numbers:
        numbers = np.arange(self.edge_count, self.edge_count + len(first), dtype=np.int32)
        self.edge_count += len(first)
        self.edges.append(np.stack((first, second), axis=-1))
        return numbers

    def _add_triangles(self, here: _Numbered, shown: Mask, splits: dict[str, _Split]) -> None:
        corners, sides = _corners(here.vertices), _sides(here, np.full(shown.shape, -1, dtype=np.int32))
        sides.diagonal[shown] = self._new_edges(corners.north_west[shown], corners.south_east[shown])
        south, north = shown.copy(), shown.copy()
        for side, split in splits.items():
            (south if side in ("west", "south") else north)[split.row, split.column] = False
            self._add_halves(corners, sides, side, split)
        self._add(
            south,
            (corners.north_west, corners.south_west, corners.south_east),
            (sides.west, sides.south, sides.diagonal),
        )
        self._add(
            north,
            (corners.north_west, corners.south_east, corners.north_east),
            (sides.diagonal, sides.east, sides.north),
        )

    def _add(
        self, cells: Mask, corners: tuple[Numbers, Numbers, Numbers], sides: tuple[Numbers, Numbers, Numbers]
    ) -> None:
        """Add a triangle of each cell that is masked."""
        self.triangles.append(np.stack([of_cells[cells] for of_cells in corners], axis=-1))
        self.triangle_edges.append(np.stack([of_cells[cells] for of_cells in sides], axis=-1))

    def _add_halves(self, corners: _Corners, sides: _Sides, side: str, split: _Split) -> None:
        """Add both halves of the triangles at a side that the finer level splits.

        A triangle ``tip``, ``start``, ``end``, counter-clockwise, is split between the last two.
        """
        at = split.row, split.column
        tip, start, end, to_start, from_end = (
            of_cells[at]
            for of_cells in {
                "west": (
                    corners.south_east,
                    corners.north_west,
                    corners.south_west,
                    sides.diagonal,
                    sides.south,
                ),
                "south": (
                    corners.north_west,
                    corners.south_west,
                    corners.south_east,
                    sides.west,
                    sides.diagonal,
                ),
                "east": (
                    corners.north_west,
                    corners.south_east,
                    corners.north_east,
                    sides.diagonal,
                    sides.north,
                ),
                "north": (
                    corners.south_east,
                    corners.north_east,
                    corners.north_west,
                    sides.east,
                    sides.diagonal,
                ),
            }[side]
        )
        # Halves are in the order of columns and rows, which is the other way round on two sides.
        first, second = split.halves if side in ("west", "south") else split.halves[::-1]
        between = self._new_edges(tip, split.middle)
        self.triangles += [
            np.stack((tip, start, split.middle), axis=-1),
            np.stack((tip, split.middle, end), axis=-1),
        ]
        self.triangle_edges += [
            np.stack((to_start, first, between), axis=-1),
            np.stack((between, second, from_end), axis=-1),
        ]


@dataclass(frozen=True)
class _Split:
    """Cells at one side of which the finer level has a sample in the middle."""

    row: Lines
    column: Lines
    middle: Numbers
    """Vertices."""
    halves: tuple[Numbers, Numbers]
    """Edges of the finer level, the western or northern first."""


@dataclass(frozen=True)
class _Corners:
    """Vertices of cells, rows x columns."""

    north_west: Numbers
    north_east: Numbers
    south_west: Numbers
    south_east: Numbers


@dataclass(frozen=True)
class _Sides:
    """Edges of cells, rows x columns; -1 where one is split."""

    north: Numbers
    south: Numbers
    west: Numbers
    east: Numbers
    diagonal: Numbers


def _corners(vertices: Numbers) -> _Corners:
    return _Corners(vertices[:-1, :-1], vertices[:-1, 1:], vertices[1:, :-1], vertices[1:, 1:])


def _sides(here: _Numbered, diagonal: Numbers) -> _Sides:
    return _Sides(here.across[:-1], here.across[1:], here.along[:, :-1], here.along[:, 1:], diagonal)


def _numbers_of(finer: _Numbered | None, columns: Lines, rows: Lines) -> tuple[Numbers, Numbers, Numbers]:
    """Numbers that the finer level gave to vertices and edges of these lines; -1 for all others."""
    vertices = np.full((len(rows), len(columns)), -1, dtype=np.int32)
    across = np.full((len(rows), len(columns) - 1), -1, dtype=np.int32)
    along = np.full((len(rows) - 1, len(columns)), -1, dtype=np.int32)
    if finer is None:
        return vertices, across, along
    at_column, has_column = _places(finer.columns, columns)
    at_row, has_row = _places(finer.rows, rows)
    there = has_row[:, None] & has_column
    vertices[there] = finer.vertices[at_row[:, None], at_column][there]
    # An edge is the same where the finer level has no line between.
    same_column = has_column[:-1] & has_column[1:] & (at_column[1:] - at_column[:-1] == 1)
    if finer.level.gap is not None:
        same_column &= at_column[:-1] != finer.level.gap
    there = has_row[:, None] & same_column
    across[there] = finer.across[at_row[:, None], np.minimum(at_column[:-1], finer.across.shape[1] - 1)][
        there
    ]
    same_row = has_row[:-1] & has_row[1:] & (at_row[1:] - at_row[:-1] == 1)
    there = same_row[:, None] & has_column
    before = np.minimum(at_row[:-1], finer.along.shape[0] - 1)
    along[there] = finer.along[before[:, None], at_column][there]
    return vertices, across, along


def _splits(here: _Numbered, finer: _Numbered, hole: Mask, shown: Mask) -> dict[str, _Split]:
    """The cells around the finer level that have a sample of it in the middle of a side, by that side."""
    splits = {}
    for side, neighbour in _NEIGHBOURS.items():
        at_hole = np.zeros_like(shown)
        cells, beside = neighbour
        at_hole[cells] = shown[cells] & hole[beside]
        row, column = np.nonzero(at_hole)
        first_row, first_column = row + (side == "south"), column + (side == "east")
        at_row = np.searchsorted(finer.rows, here.rows[first_row])
        at_column = np.searchsorted(finer.columns, here.columns[first_column])
        if side in ("north", "south"):
            split = np.searchsorted(finer.columns, here.columns[first_column + 1]) - at_column == 2
        else:
            split = np.searchsorted(finer.rows, here.rows[first_row + 1]) - at_row == 2
        row, column, at_row, at_column = row[split], column[split], at_row[split], at_column[split]
        if side in ("north", "south"):
            middle = finer.vertices[at_row, at_column + 1]
            halves = finer.across[at_row, at_column], finer.across[at_row, at_column + 1]
        else:
            middle = finer.vertices[at_row + 1, at_column]
            halves = finer.along[at_row, at_column], finer.along[at_row + 1, at_column]
        splits[side] = _Split(row, column, middle, halves)
    return splits


_ALL = slice(None)
_FIRST, _LAST = slice(None, -1), slice(1, None)
_NEIGHBOURS = {
    "north": ((_LAST, _ALL), (_FIRST, _ALL)),
    "south": ((_FIRST, _ALL), (_LAST, _ALL)),
    "west": ((_ALL, _LAST), (_ALL, _FIRST)),
    "east": ((_ALL, _FIRST), (_ALL, _LAST)),
}
"""Cells that have a neighbour at a side, and those neighbours."""


def _places(lines: Lines, wanted: Lines) -> tuple[npt.NDArray[np.intp], Mask]:
    """Where wanted lines are among these, and whether they are."""
    places = np.minimum(np.searchsorted(lines, wanted), len(lines) - 1)
    return places, lines[places] == wanted


def _number(numbers: Numbers, mask: Mask, first: int) -> int:
    """Give the masked ones the next numbers; what comes after them is returned."""
    count = int(np.count_nonzero(mask))
    numbers[mask] = np.arange(first, first + count, dtype=np.int32)
    return first + count
