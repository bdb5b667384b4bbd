"""What every reader gives: where the samples lie, what they mean, and where on its body they are."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from proxygraph import DecodeError, Grid, GridError, GridLayout, Progress

from .cache import CacheError, cached_file, is_full, refused_by_system
from .decoders import DECODERS
from .decoding import Decoding
from .format_error import FormatError
from .georeference import Georeference
from .native_refusal import native_refusal
from .region import Region


@dataclass(frozen=True)
class ElevationGrid:
    """A grid file as its header describes it; the samples stay in the file."""

    path: Path
    """What was read: the label or header, or the file that has its own."""
    data_path: Path
    """The file with the samples."""
    layout: GridLayout
    """Of the samples that are touched: in ``data_path`` where they are mapped, else as they are decoded."""
    georeference: Georeference
    title: str
    format: str
    """As people know it, ``MOLA (PDS3)``."""
    synthetic: bool = False
    """Whether the heights were made up: shown wherever the grid is named."""
    decoding: Decoding | None = None
    """How the samples are decoded; ``None`` where they are mapped in place."""
    notes: tuple[str, ...] = ()
    """What a person should know of this file: what was missing, what was assumed."""
    range: tuple[float, float] | None = field(default=None, compare=False)
    """Lowest and highest elevation, metres, where the reader had to look at all; ``None`` where it did not,
    and where all are void."""
    voids: int | None = field(default=None, compare=False)
    """How many samples are void, where the reader had to look at all; else ``None``."""

    @property
    def samples(self) -> int:
        """How many heights the grid has."""
        return self.layout.samples

    @property
    def triangles(self) -> int:
        """How many triangles touch has to do with."""
        return self.layout.triangles

    def region(self, region: Region) -> ElevationGrid:
        """The same file, of which only a region is ever read.

        Raises:
            ValueError: the region is not on the grid, or has less than 2 rows or columns.
        """
        if region == Region.whole(self.layout.columns, self.layout.rows):
            return self
        region.check_on(self.layout)
        georeference = self.georeference.cut(region)
        width, height = georeference.cell_size(region.rows, region.columns)
        cut = replace(self, georeference=georeference, range=None, voids=None)
        # A region across the seam has its columns in two places of each row: they are brought together.
        if self.decoding is None and region.first_column + region.columns <= self.layout.columns:
            return replace(cut, layout=region.mapped(self.layout, width, height))
        decoding = (self.decoding or Decoding.of_raw(self.layout)).cut(region)
        return replace(cut, layout=region.packed(self.layout, width, height), decoding=decoding)

    def open(self, progress: Progress | None = None) -> Grid:
        """Map the samples where they lie, or decode them.

        Raises:
            FormatError: naming what cannot be read.
            CancelledError: ``progress`` was asked to end.
        """
        try:
            if self.decoding is None:
                return Grid.open(self.data_path, self.layout)
            decoded = cached_file(self.data_path, self.layout, self.decoding)
            if decoded is not None:
                return Grid.open(decoded, self.layout)
            return DECODERS[self.decoding.kind](self.data_path, self.layout, self.decoding, progress)
        except DecodeError as error:
            raise native_refusal(
                self.data_path, error, "The file has changed since: import the grid again."
            ) from error
        except CacheError as error:
            raise self._cache_refusal(error) from error
        except (GridError, OSError) as error:
            if isinstance(error, OSError) and is_full(error):
                raise self._cache_refusal(refused_by_system(error, self.layout.byte_length)) from error
            raise FormatError(
                self.data_path,
                "samples",
                found=error,
                expected=f"{self.layout.samples:,} readable samples",
                way_out="Put the data file back where it was, or import the grid again.",
            ) from error

    def _cache_refusal(self, error: CacheError) -> FormatError:
        """The data file is whole: what is wrong is where its samples were to be written."""
        return FormatError(
            self.data_path, "cache", found=error.found, expected=error.expected, way_out=error.way_out
        )
