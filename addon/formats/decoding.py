"""How samples that cannot be used where they lie are brought into memory, or into a cache file."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from proxygraph import GridLayout

from .raw.raw_samples import RawSamples
from .region import Region


@dataclass(frozen=True)
class Decoding:
    """Which decoder, and which part of the file."""

    kind: str
    """A key of ``DECODERS``."""
    first_column: int = 0
    first_row: int = 0
    """Of the region in the file's own grid; its size is the layout's."""
    options: dict[str, Any] = field(default_factory=dict)
    """What else the decoder needs to know: texts, numbers, and more such dictionaries."""

    @staticmethod
    def of_raw(samples: RawSamples | GridLayout) -> Decoding:
        """Copy raw samples: of any type and order, or a region out of a layout that could be mapped.

        The grid's layout is ``samples.decoded(...)``, or packed in the layout's own type.
        """
        raw = samples if isinstance(samples, RawSamples) else RawSamples.of(samples)
        return Decoding("raw", options={"samples": raw.properties()})

    def cut(self, region: Region) -> Decoding:
        """A region of what this one decodes."""
        return replace(
            self,
            first_column=self.first_column + region.first_column,
            first_row=self.first_row + region.first_row,
        )
