"""Readers of elevation grids: a header in, an ``ElevationGrid`` out. Nothing here imports bpy."""

from __future__ import annotations

from pathlib import Path

from .elevation_grid import ElevationGrid
from .format_error import FormatError
from .georeference import Georeference
from .megdr import read_megdr
from .region import Region

__all__ = ["SUFFIXES", "ElevationGrid", "FormatError", "Georeference", "Region", "read_grid"]

SUFFIXES = (".lbl", ".img")
"""Endings of the files that ``read_grid`` takes."""


def read_grid(path: Path) -> ElevationGrid:
    """Read the header of a grid file: what it describes and where its samples lie, not the samples."""
    if path.suffix.lower() not in SUFFIXES:
        raise FormatError(
            path,
            "file name",
            found=path.suffix or "no ending",
            expected=" or ".join(SUFFIXES),
            way_out="Choose the label (.lbl) or the data file (.img) of a MOLA grid.",
        )
    return read_megdr(path)
