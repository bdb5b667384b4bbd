"""What a terrain object remembers of its grid, as ID properties.

ID properties keep doubles, where Blender's own float properties have 32 bits; but integers stop at
2^31, so counts that may be larger are kept as text.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import bpy

from ..formats import ElevationGrid
from ..formats.decoding_properties import decoding_from, decoding_text
from ..formats.georeference_properties import finite, georeference_from, georeference_properties, restored
from ..formats.layout_properties import layout_from, layout_properties
from ..formats.source_stamp import SourceStamp
from .bend import Bend
from .chosen_region import ChosenRegion, region_from, region_properties
from .frame import TerrainFrame

KEY = "haptic_terrain_grid"
"""Of the ID property group on a terrain object."""

FRAME = "frame"
"""How the grid is shown."""

SOURCE, SOURCE_BESIDE = "source", "source_beside"
"""Where the data file is: its whole path, and (once there is one) its path from the .blend file's folder."""


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
    filled: bool = False
    """Whether voids were filled, for eye and hand."""
    stamp: SourceStamp | None = None
    """Of the data file when it was imported."""
    region: ChosenRegion | None = None
    """The part of the file that was chosen, as it was chosen; ``None`` is all of it."""
    position: tuple[float, float] | None = None
    """Latitude and longitude of an SRTM square that was placed by hand."""

    def has_ground_of(self, other: KeptTerrain) -> bool:
        """Whether the same samples lie in the same places, however they are shown."""
        return self._ground == other._ground

    @property
    def _ground(self) -> tuple[object, ...]:
        return self.grid.layout, self.grid.georeference, self.filled, self.stamp


def keep(terrain: bpy.types.Object, kept: KeptTerrain) -> None:
    """Write what the object has to remember."""
    grid = kept.grid
    terrain[KEY] = {
        "title": grid.title,
        "synthetic": grid.synthetic,
        SOURCE: str(grid.data_path),
        "path": str(grid.path),
        "format": grid.format,
        "notes": "\n".join(grid.notes),
        "layout": layout_properties(grid.layout),
        "georeference": georeference_properties(grid.georeference),
        **({} if grid.decoding is None else {"decoding": decoding_text(grid.decoding)}),
        FRAME: _frame_properties(kept.frame),
        "vertex_budget": kept.vertex_budget,
        "minimum": kept.minimum,
        "maximum": kept.maximum,
        "filled": kept.filled,
        **({} if kept.stamp is None else {"stamp": json.dumps(asdict(kept.stamp))}),
        **({} if kept.region is None else {"region": region_properties(kept.region)}),
        **({} if kept.position is None else {"position": list(kept.position)}),
    }


def is_terrain(thing: bpy.types.Object | None) -> bool:
    """Whether an object was made from a grid."""
    return thing is not None and thing.get(KEY) is not None


def recall(terrain: bpy.types.Object) -> KeptTerrain:
    """Read what the object remembers.

    Raises:
        KeptError: its ID properties were changed.
    """
    with _changes_told(terrain):
        return _recall(terrain, terrain[KEY])


def recall_frame(terrain: bpy.types.Object) -> TerrainFrame:
    """Read only how the grid is shown, which is quick.

    Raises:
        KeptError: its ID properties were changed.
    """
    with _changes_told(terrain):
        return _frame(terrain[KEY])


def keep_frame(terrain: bpy.types.Object, frame: TerrainFrame) -> None:
    """Show the grid in another way from now on."""
    terrain[KEY][FRAME] = _frame_properties(frame)


@contextmanager
def _changes_told(terrain: bpy.types.Object) -> Iterator[None]:
    try:
        yield
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError) as error:
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


def find_beside(terrain: bpy.types.Object, blend: Path) -> None:
    """Look for the data file from the .blend file that a terrain was appended from, and note where it is."""
    kept = terrain.get(KEY)
    try:
        if kept is None or Path(kept[SOURCE]).is_file():
            return
        moved = (blend.parent / kept[SOURCE_BESIDE]).resolve()
        if moved.is_file():
            kept[SOURCE] = str(moved)
    except (KeyError, TypeError, ValueError, AttributeError):
        return  # what was changed by hand is told when it is used


def _recall(terrain: bpy.types.Object, kept: Mapping[str, Any]) -> KeptTerrain:
    decoding, stamp = kept.get("decoding"), kept.get("stamp")
    region, position = kept.get("region"), kept.get("position")
    grid = ElevationGrid(
        path=Path(kept["path"]),
        data_path=_data_path(terrain, kept),
        layout=layout_from(kept["layout"]),
        georeference=georeference_from(kept["georeference"].to_dict()),
        title=str(kept["title"]),
        format=str(kept["format"]),
        synthetic=bool(kept["synthetic"]),
        decoding=None if decoding is None else decoding_from(decoding),
        notes=tuple(str(kept["notes"]).splitlines()),
    )
    return KeptTerrain(
        grid,
        _frame(kept),
        int(kept["vertex_budget"]),
        finite(kept["minimum"]),
        finite(kept["maximum"]),
        filled=bool(kept.get("filled", False)),
        stamp=None if stamp is None else _stamp(json.loads(stamp)),
        region=None if region is None else region_from(region.to_dict()),
        position=None if position is None else (finite(position[0]), finite(position[1])),
    )


def _stamp(kept: Mapping[str, Any]) -> SourceStamp:
    return SourceStamp(int(kept["size"]), int(kept["modified"]), str(kept["digest"]))


def _frame(kept: Mapping[str, Any]) -> TerrainFrame:
    properties = {"turn": None, "bend": None, **kept[FRAME].to_dict()}
    if properties["bend"] is not None:
        bend = {"latitude": None, "parallel": None, **properties["bend"]}
        properties["bend"] = restored(Bend, bend)
        if properties["bend"].radius <= 0.0:
            raise ValueError("a radius is not above 0")
    frame = restored(TerrainFrame, properties)
    if not (frame.units_per_metre > 0.0 and frame.exaggeration > 0.0):
        raise ValueError("a scale is not above 0")
    return frame


def _frame_properties(frame: TerrainFrame) -> dict[str, Any]:
    return _without_none(asdict(frame))


def _without_none(properties: Mapping[str, Any]) -> dict[str, Any]:
    """ID properties have no way to say nothing."""
    return {
        name: _without_none(value) if isinstance(value, dict) else value
        for name, value in properties.items()
        if value is not None
    }


def _data_path(terrain: bpy.types.Object, kept: Mapping[str, Any]) -> Path:
    """Find the data file where it was, else beside the .blend file as before: both may have moved."""
    source = Path(kept[SOURCE])
    beside = kept.get(SOURCE_BESIDE)
    if beside is None or source.is_file():
        return source
    moved = Path(bpy.path.abspath(f"//{beside}", library=terrain.library)).resolve()
    return moved if moved.is_file() else source
