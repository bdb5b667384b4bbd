"""A grid's layout as texts and numbers, and back.

Whoever keeps them (Blender's ID properties) may stop whole numbers at 2^31: counts are kept as text.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from proxygraph import GridLayout


def layout_properties(layout: GridLayout) -> dict[str, Any]:
    """Write a layout down."""
    return {
        "rows": str(layout.rows),
        "columns": str(layout.columns),
        "cell_width": layout.cell_width,
        "cell_height": layout.cell_height,
        "sample": layout.sample,
        "byte_order": layout.byte_order,
        "offset": str(layout.offset),
        "row_stride": str(layout.row_stride),
        "scale": layout.scale,
        "value_offset": layout.value_offset,
        "wraps": layout.wraps,
        **({} if layout.void is None else {"void": layout.void}),
    }


def layout_from(kept: Mapping[str, Any]) -> GridLayout:
    """Make the layout again.

    Raises:
        KeyError, TypeError, ValueError: what was kept was changed.
    """
    return GridLayout(
        int(kept["rows"]),
        int(kept["columns"]),
        cell_width=kept["cell_width"],
        cell_height=kept["cell_height"],
        sample=kept["sample"],
        byte_order=kept["byte_order"],
        offset=int(kept["offset"]),
        row_stride=int(kept["row_stride"]),
        scale=kept["scale"],
        value_offset=kept["value_offset"],
        void=kept.get("void"),
        wraps=bool(kept["wraps"]),
    )
