"""What a terrain object remembers of its grid, as ID properties.

ID properties keep doubles, where Blender's own float properties have 32 bits; but integers stop at
2^31, so counts that may be larger are kept as text.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any, TypeVar

import bpy
from proxygraph import GridLayout

from ..formats import ElevationGrid, Georeference
from .frame import TerrainFrame

KEY = "haptic_terrain_grid"
"""Of the ID property group on a terrain object."""

SOURCE, SOURCE_BESIDE = "source", "source_beside"
"""Where the data file is: its whole path, and (once there is one) its path from the .blend file's folder."""

Kept = TypeVar("Kept", Georeference, TerrainFrame)


class KeptError(ValueError):
    """A terrain object does not remember its grid as it should; the text says what to do."""


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
        SOURCE: str(grid.data_path),
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
    """Read what the object remembers.

    Raises:
        KeptError: its ID properties were changed.
    """
    try:
        return _recall(terrain, terrain[KEY])
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        raise KeptError(
            f"{terrain.name} does not remember its grid any more: its custom property {KEY} was changed "
            f"({type(error).__name__}: {error}). Import the grid again."
        ) from error


def remember_places(blend: Path) -> None:
    """Note where every terrain's data file is from a .blend file that is about to be written."""
    for terrain in bpy.data.objects:
        if not is_terrain(terrain) or terrain.library is not None:
            continue
        kept = terrain[KEY]
        try:
            source = _data_path(terrain, kept)
            kept[SOURCE] = str(source)
            kept[SOURCE_BESIDE] = os.path.relpath(source, blend.parent)
        except (KeyError, TypeError, ValueError, AttributeError):
            continue  # another drive has no relative path; and what was changed is told when it is used


def _recall(terrain: bpy.types.Object, kept: Mapping[str, Any]) -> KeptTerrain:
    grid = ElevationGrid(
        data_path=_data_path(terrain, kept),
        layout=_layout(kept["layout"]),
        georeference=_restored(Georeference, kept["georeference"]),
        title=str(kept["title"]),
        synthetic=bool(kept["synthetic"]),
    )
    frame = _restored(TerrainFrame, {"turn": None, **kept["frame"].to_dict()})
    if not (frame.units_per_metre > 0.0 and frame.exaggeration > 0.0):
        raise ValueError("a scale is not above 0")
    return KeptTerrain(
        grid, frame, int(kept["vertex_budget"]), _finite(kept["minimum"]), _finite(kept["maximum"])
    )


def _data_path(terrain: bpy.types.Object, kept: Mapping[str, Any]) -> Path:
    """Find the data file where it was, else beside the .blend file as before: both may have moved."""
    source = Path(kept[SOURCE])
    beside = kept.get(SOURCE_BESIDE)
    if beside is None or source.is_file():
        return source
    moved = Path(bpy.path.abspath(f"//{beside}", library=terrain.library)).resolve()
    return moved if moved.is_file() else source


def _restored(kind: type[Kept], kept: Any) -> Kept:
    """Make a dataclass of numbers and texts again; every number must be finite."""
    values = {field.name: kept[field.name] for field in fields(kind)}
    numbers = {field.name for field in fields(kind) if str(field.type).startswith("float")}
    checked: dict[str, Any] = {
        name: _finite(value) if name in numbers and value is not None else value
        for name, value in values.items()
    }
    return kind(**checked)


def _finite(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{number} is not a finite number")
    return number


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
