"""Filling voids, and what it takes; without Blender."""

from __future__ import annotations

from proxygraph import DecodeError, Grid, GridLayout, Progress

from ..formats import ElevationGrid
from ..formats.native_refusal import native_refusal
from ..formats.region import SAMPLE_BYTES
from .whole import refuse_damaged

WORKING_BYTES = 12
"""A sample, while voids are filled: heights, and what is known, on all grids from coarse to fine."""


def copy_bytes(layout: GridLayout) -> int:
    """Bytes of memory that the filled copy keeps."""
    return layout.samples * SAMPLE_BYTES[layout.sample]


def working_bytes(layout: GridLayout) -> int:
    """Bytes of memory more that are needed while voids are filled."""
    return layout.samples * WORKING_BYTES


def filled(grid: ElevationGrid, samples: Grid, progress: Progress | None = None) -> Grid:
    """Make a copy of a grid's opened samples whose voids are filled.

    Raises:
        FormatError: the file was cut meanwhile, or there is not enough memory.
        CancelledError: ``progress`` was asked to end.
    """
    try:
        return samples.filled(progress)
    except DecodeError as error:
        refuse_damaged(grid, samples)
        way_out = "Import a smaller region, or leave the voids unfilled."
        raise native_refusal(grid.data_path, error, way_out) from error
