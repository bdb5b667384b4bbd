"""Room for meshes of changing shape in one of fixed size: what Blender cannot change quickly stays as it is.

How many corners come before each face is the one thing that Blender's Python sets slowly (75 ms for 500,000
faces, everything else together 5). So a mesh that is refreshed keeps its number of faces, and those that are
not needed are folded into one point, where nobody sees them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .mesh_arrays import Floats, Integers, MeshArrays

FOLDED = 3
"""Vertices that all folded triangles have."""


@dataclass(frozen=True)
class Room:
    """How large the mesh is. Of ``n`` vertices a surface in the plane has fewer than ``2 n`` triangles."""

    most_vertices: int
    """It begins with fewer, and gets one more at each refresh: see ``levels_mesh``."""

    @property
    def refreshes(self) -> int:
        """How often it can be refreshed."""
        return min(4096, self.most_vertices // 16)

    @property
    def vertices(self) -> int:
        """At the beginning."""
        return self.most_vertices - self.refreshes

    @property
    def budget(self) -> int:
        """Vertices that there is room for."""
        return self.vertices - FOLDED

    @property
    def edges(self) -> int:
        """How many."""
        return 3 * self.vertices

    @property
    def triangles(self) -> int:
        """How many."""
        return 2 * self.vertices


@dataclass(frozen=True)
class Filling:
    """What is written into the mesh; arrays of vertices are as long as they can ever be, to be cut."""

    positions: Floats
    """Vertices x 3."""
    numbers: dict[str, Floats]
    """Of vertices, by the attribute's name."""
    edges: Integers
    triangles: Integers
    triangle_edges: Integers
    used: int
    """Triangles that are seen; they come first."""


def filling(arrays: MeshArrays, numbers: dict[str, Floats], room: Room) -> Filling:
    """Fill a mesh of that size, and fold what is left over.

    Args:
        numbers: of the vertices of ``arrays``, by the attribute's name.
    """
    corners = np.arange(room.vertices - FOLDED, room.vertices, dtype=np.int32)
    sides = np.arange(room.edges - FOLDED, room.edges, dtype=np.int32)
    edges = _filled_up(arrays.edges, room.edges, np.array([corners[0], corners[1]]))
    edges[-FOLDED:] = np.stack((corners, np.roll(corners, -1)), axis=-1)
    somewhere = arrays.positions[0] if len(arrays.positions) else np.zeros(3, dtype=np.float32)
    return Filling(
        positions=_filled_up(arrays.positions, room.most_vertices, somewhere),
        numbers={
            name: _filled_up(values, room.most_vertices, np.float32(0.0)) for name, values in numbers.items()
        },
        edges=edges,
        triangles=_filled_up(arrays.triangles, room.triangles, corners),
        triangle_edges=_filled_up(arrays.triangle_edges, room.triangles, sides),
        used=len(arrays.triangles),
    )


def _filled_up(values: npt.NDArray[Any], length: int, rest: object) -> npt.NDArray[Any]:
    filled = np.empty((length, *values.shape[1:]), dtype=values.dtype)
    filled[: len(values)] = values
    filled[len(values) :] = rest
    return filled
