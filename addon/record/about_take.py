"""The text about a take that its file has: on what it was recorded, and how; without Blender."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from ..formats import ElevationGrid
from ..formats.georeference_properties import georeference_properties
from ..formats.layout_properties import layout_properties

UNITS = "metres (terrain: east, north, up; workspace: right, away, up), newtons, seconds, radians"


@dataclass(frozen=True)
class AboutTake:
    """What a take's file says of it."""

    terrain: str
    """Of the terrain's object."""
    title: str
    """Of its grid."""
    source: str
    """The data file."""
    grid: dict[str, Any]
    """Layout and georeference: the same for a terrain on which the take can be shown."""
    model: str
    """The contact model that answered first."""
    start_frame: int
    """Of the scene, when the take began."""

    def text(self) -> str:
        """Write it down."""
        return json.dumps({"units": UNITS, **vars(self)})

    @staticmethod
    def read(text: str) -> AboutTake:
        """Read it again.

        Raises:
            ValueError: what is missing, or is something else.
        """
        kinds = {"terrain": str, "title": str, "source": str, "grid": dict, "model": str, "start_frame": int}
        told = json.loads(text)
        if not isinstance(told, dict):
            raise ValueError(f"found {type(told).__name__}, expected an object")
        for name, kind in kinds.items():
            if not isinstance(told.get(name), kind):
                raise ValueError(f"{name} is {told.get(name)!r}, expected {kind.__name__}")
        return AboutTake(**{name: told[name] for name in kinds})


def told_of(grid: ElevationGrid) -> dict[str, Any]:
    """Write down what tells a grid from others, wherever its file is."""
    told = {
        "layout": layout_properties(grid.layout),
        "georeference": georeference_properties(grid.georeference),
    }
    restored: dict[str, Any] = json.loads(json.dumps(told))  # tuples become lists, as they will
    return restored
