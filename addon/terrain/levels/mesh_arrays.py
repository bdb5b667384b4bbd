"""Everything that a mesh of nested levels is made of, prepared in a thread: Blender only has to copy it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from proxygraph import GridLayout

from ..frame import TerrainFrame
from .level import Level, Mask
from .nested_surface import NestedSurface
from .samples import SampleReader
from .topology import Topology, topology

Floats = npt.NDArray[np.float32]
Integers = npt.NDArray[np.int32]


@dataclass(frozen=True)
class MeshArrays:
    """A mesh of triangles with no vertex or edge that none of them has."""

    positions: Floats
    """Object coordinates, vertices x 3."""
    elevations: Floats
    """Metres."""
    slopes: Floats
    """Degrees."""
    filled: Floats | None
    """1 where there was a void; ``None`` where nothing was filled."""
    edges: Integers
    """Vertices, edges x 2."""
    triangles: Integers
    """Vertices, triangles x 3."""
    triangle_edges: Integers
    """Edges, triangles x 3."""
    surface: NestedSurface
    """The same, to be asked for heights."""


def mesh_arrays(
    levels: Sequence[Level], reader: SampleReader, frame: TerrainFrame, layout: GridLayout
) -> MeshArrays:
    """Read the levels and connect them; triangles with a void corner are left out."""
    samples = reader.read(levels)
    connected = topology(levels)
    heights = _of_own(connected, [of_level.heights for of_level in samples])
    owned = list(zip(levels, connected.own, strict=True))
    columns = [np.broadcast_to(level.column_lines, own.shape) for level, own in owned]
    rows = [np.broadcast_to(level.row_lines[:, None], own.shape) for level, own in owned]
    east = _of_own(connected, columns) * layout.cell_width
    north = _of_own(connected, rows) * -layout.cell_height
    slopes = _of_own(connected, [of_level.slopes for of_level in samples])
    filled = [of_level.filled for of_level in samples if of_level.filled is not None]
    made_up = _of_own(connected, filled) if filled else None
    kept = _without_voids(connected, np.isfinite(heights))
    shown = frame.shown(east[kept.vertices], north[kept.vertices], heights[kept.vertices])
    return MeshArrays(
        positions=np.stack(shown, axis=-1).astype(np.float32),
        elevations=heights[kept.vertices].astype(np.float32),
        slopes=slopes[kept.vertices].astype(np.float32),
        filled=None if made_up is None else made_up[kept.vertices].astype(np.float32),
        edges=kept.edges,
        triangles=kept.triangles,
        triangle_edges=kept.triangle_edges,
        surface=NestedSurface(layout, tuple(levels), tuple(samples)),
    )


@dataclass(frozen=True)
class _Kept:
    vertices: Mask | slice
    edges: Integers
    triangles: Integers
    triangle_edges: Integers


def _without_voids(connected: Topology, is_height: Mask) -> _Kept:
    """Leave out triangles with a void corner, and what only they had."""
    if is_height.all():
        return _Kept(slice(None), connected.edges, connected.triangles, connected.triangle_edges)
    whole = is_height[connected.triangles].all(axis=1)
    triangles, triangle_edges = connected.triangles[whole], connected.triangle_edges[whole]
    vertices, vertex_numbers = _used(triangles, len(is_height))
    edges, edge_numbers = _used(triangle_edges, len(connected.edges))
    return _Kept(
        vertices,
        vertex_numbers[connected.edges[edges]],
        vertex_numbers[triangles],
        edge_numbers[triangle_edges],
    )


def _used(numbers: Integers, count: int) -> tuple[Mask, Integers]:
    """Which of ``count`` things are named, and their new numbers."""
    used = np.zeros(count, dtype=bool)
    used[numbers] = True
    return used, (np.cumsum(used) - 1).astype(np.int32)


def _of_own(connected: Topology, values: Sequence[npt.NDArray[Any]]) -> npt.NDArray[Any]:
    """Values of the vertices, in their order, from those of whole levels."""
    return np.concatenate([of_level[own] for of_level, own in zip(values, connected.own, strict=True)])
