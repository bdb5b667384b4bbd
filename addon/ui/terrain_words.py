"""What panels say of a terrain's file."""

from __future__ import annotations

from ..terrain.kept import KeptTerrain


def missing(kept: KeptTerrain) -> str:
    """What is to be done about a file that is not there: the preview is in the .blend file."""
    return f"{kept.grid.data_path.name} is not where it was. The terrain is shown; to touch it, use Relink."
