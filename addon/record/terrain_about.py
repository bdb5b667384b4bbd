"""What a take would be felt on, were it felt on a terrain of this scene."""

from __future__ import annotations

from ..terrain.kept import KeptTerrain
from .take_data import TakeAbout


def terrain_about(name: str, kept: KeptTerrain) -> TakeAbout:
    """Describe a terrain object of that name, to compare it with what a take was felt on."""
    layout = kept.grid.layout
    return TakeAbout(
        terrain=name,
        source=kept.grid.data_path.name,
        digest=kept.stamp.digest if kept.stamp is not None else "",
        georeference=kept.grid.georeference,
        workspace_width=1.0,
        rows=layout.rows,
        columns=layout.columns,
        cell_width=layout.cell_width,
        cell_height=layout.cell_height,
        wraps=layout.wraps,
    )
