"""What a terrain object remembers of its grid, as ID properties.

ID properties keep doubles, where Blender's own float properties have 32 bits; but integers stop at
2^31, so counts that may be larger are kept as text.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import bpy
from proxygraph import GridLayout

from ..formats import ElevationGrid, Georeference
from .frame import TerrainFrame

KEY = "haptic_terrain_grid"
"""Of the ID property group on a terrain object."""


@dataclass(frozen=True)
class KeptTerrain:
    """A terrain object's grid, and how it is shown."""

    grid: ElevationGrid
    frame: TerrainFrame
    vertex_budget: int
    minimum: float
    maximum: float
    """Metres, of the whole grid."""


def keep(terrain: bpy.types.Object, kept: KeptTerrain) -> None:
    """Write what the object has to remember."""
    grid, layout = kept.grid, kept.grid.layout
    terrain[KEY] = {
        "title": grid.title,
        "synthetic": grid.synthetic,
        "source": str(grid.data_path),
        "layout": {
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
        },
        "georeference": asdict(grid.georeference),
        "frame": {name: value for name, value in asdict(kept.frame).items() if value is not None},
        "vertex_budget": kept.vertex_budget,
        "minimum": kept.minimum,
        "maximum": kept.maximum,
    }


def is_terrain(thing: bpy.types.Object | None) -> bool:
    """Whether an object was made from a grid."""
    return thing is not None and thing.get(KEY) is not None


def recall(terrain: bpy.types.Object) -> KeptTerrain:
    """Read what the object remembers."""
    kept = terrain[KEY]
    grid = ElevationGrid(
        data_path=Path(bpy.path.abspath(kept["source"])),
        layout=_layout(kept["layout"]),
        georeference=Georeference(**kept["georeference"].to_dict()),
        title=kept["title"],
        synthetic=bool(kept["synthetic"]),
    )
    frame = TerrainFrame(**{"turn": None, **kept["frame"].to_dict()})
    return KeptTerrain(
        grid, frame, int(kept["vertex_budget"]), float(kept["minimum"]), float(kept["maximum"])
    )


def _layout(kept: Mapping[str, Any]) -> GridLayout:
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
