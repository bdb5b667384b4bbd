"""Small grounds to touch."""

from __future__ import annotations

import math
import struct
from array import array
from collections.abc import Sequence

from proxygraph import Grid, GridLayout

SIDE = 64
"""Samples along each side of the flat and of the hilly ground."""


def ground(heights: Sequence[Sequence[float]], *, cell: float = 1.0, wraps: bool = False) -> Grid:
    """Heights in metres by row, north first."""
    rows, columns = len(heights), len(heights[0])
    samples = array("d", [height for row in heights for height in row])
    layout = GridLayout(
        rows, columns, cell_width=cell, cell_height=cell, sample="f64", byte_order="little", wraps=wraps
    )
    return Grid.from_buffer(struct.pack(f"<{len(samples)}d", *samples), layout)


def flat() -> Grid:
    """Height 0 everywhere."""
    return ground([[0.0] * SIDE for _ in range(SIDE)])


def hills() -> Grid:
    """Rolling hills, up to 2 m high."""
    return ground(
        [[math.sin(0.7 * column) + math.cos(0.9 * row) for column in range(SIDE)] for row in range(SIDE)]
    )
