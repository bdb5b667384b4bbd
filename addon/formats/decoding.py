"""How samples that cannot be used where they lie are brought into memory, or into a cache file."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from proxygraph import GridLayout

from .layout_properties import layout_properties
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
    def of_raw(layout: GridLayout) -> Decoding:
        """Copy samples out of a file that could be mapped."""
        return Decoding("raw", options={"layout": layout_properties(layout)})

    def cut(self, region: Region) -> Decoding:
        """A region of what this one decodes."""
        return replace(
            self,
            first_column=self.first_column + region.first_column,
            first_row=self.first_row + region.first_row,
        )
