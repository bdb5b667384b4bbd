"""What a take would be felt on, were it felt on a terrain of this scene."""

from __future__ import annotations

from typing import Any

import bpy
from proxygraph import GridLayout

from ..terrain.kept import KeptTerrain
from .take_data import TakeAbout


def terrain_about(terrain: bpy.types.Object, kept: KeptTerrain) -> TakeAbout:
    """Describe a terrain, to compare it with what a take was felt on."""
    return TakeAbout(
        terrain=terrain.name,
        source=kept.grid.data_path.name,
        digest=kept.stamp.digest if kept.stamp is not None else "",
        georeference=kept.grid.georeference,
        workspace_width=1.0,
        **grid_of(kept.grid.layout),
    )


def grid_of(layout: GridLayout) -> dict[str, Any]:
    """What ``TakeAbout`` says of a grid's samples."""
    return {
        "rows": layout.rows,
        "columns": layout.columns,
        "cell_width": layout.cell_width,
        "cell_height": layout.cell_height,
        "wraps": layout.wraps,
    }
