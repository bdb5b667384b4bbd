"""Readers of elevation grids: a header in, an ``ElevationGrid`` out. Nothing here imports bpy."""

from __future__ import annotations

from .detect import SUFFIXES, read_grid
from .elevation_grid import ElevationGrid
from .format_error import FormatError
from .georeference import Georeference
from .raw.hgt import HgtPosition
from .region import Region

__all__ = [
    "SUFFIXES",
    "ElevationGrid",
    "FormatError",
    "Georeference",
    "HgtPosition",
    "Region",
    "read_grid",
]
