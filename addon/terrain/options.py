"""What a person chooses before an import; without Blender."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from .chosen_region import ChosenRegion
from .preview import VERTEX_BUDGET


class SceneScale(StrEnum):
    """What a Blender unit stands for."""

    FIT = "FIT"
    METRE = "METRE"
    KILOMETRE = "KILOMETRE"


@dataclass(frozen=True)
class ImportOptions:
    """A person's choices."""

    vertex_budget: int = VERTEX_BUDGET
    scale: SceneScale = SceneScale.FIT
    exaggeration: float = 0.0
    """Of heights; 0 chooses."""
    region: ChosenRegion | None = None
    """The part that is read; ``None`` is all of it."""
    fill_voids: bool = False
    position: tuple[float, float] | None = None
    """Latitude and longitude, degrees, of the lower left corner of an SRTM square with another name."""
