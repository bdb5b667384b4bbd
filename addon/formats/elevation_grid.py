"""What every reader gives: where the samples lie, and where on its body."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from proxygraph import Grid, GridError, GridLayout

from .format_error import FormatError
from .georeference import Georeference


@dataclass(frozen=True)
class ElevationGrid:
    """A grid file as its header describes it; the samples stay in the file."""

    data_path: Path
    layout: GridLayout
    georeference: Georeference
    title: str
    synthetic: bool
    """Whether the heights were made up: shown wherever the grid is named."""

    @property
    def samples(self) -> int:
        """How many heights the grid has."""
        return self.layout.samples

    @property
    def triangles(self) -> int:
        """How many triangles touch has to do with."""
        return self.layout.triangles

    def open(self) -> Grid:
        """Map the samples where they lie."""
        try:
            return Grid.open(self.data_path, self.layout)
        except GridError as error:
            raise FormatError(
                self.data_path,
                "samples",
                found=error,
                expected=f"{self.layout.byte_length:,} readable bytes",
                way_out="Put the data file back where it was, or import the grid again.",
            ) from error
