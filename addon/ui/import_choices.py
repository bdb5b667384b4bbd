"""What a person chooses before an import, as operator properties."""

from __future__ import annotations

from enum import StrEnum
from typing import Any

import bpy

from ..terrain.chosen_region import ChosenRegion, LongitudeLatitudeBox, RowsAndColumns
from ..terrain.options import ImportOptions, SceneScale
from ..terrain.preview import VERTEX_BUDGET


class RegionBy(StrEnum):
    """How a part of the grid is named."""

    WHOLE = "WHOLE"
    DEGREES = "DEGREES"
    SAMPLES = "SAMPLES"


REGION_FIELDS = {
    RegionBy.WHOLE: (),
    RegionBy.DEGREES: ("west", "east", "south", "north"),
    RegionBy.SAMPLES: ("first_column", "first_row", "columns", "rows"),
}
"""The properties that each way needs."""


class ImportChoices:
    """Properties of the import operator."""

    vertex_budget: bpy.props.IntProperty(
        name="Vertices",
        description="How many samples to show at the most; touch always has all of them",
        default=VERTEX_BUDGET,
        min=4,
        soft_min=1_000,
        soft_max=10_000_000,
    )
    scale: bpy.props.EnumProperty(
        name="Scale",
        items=[
            (SceneScale.FIT, "Fit", "The longest side is 10 units"),
            (SceneScale.KILOMETRE, "1 unit = 1 km", "One Blender unit is one kilometre"),
            (SceneScale.METRE, "1 unit = 1 m", "One Blender unit is one metre"),
        ],
    )
    exaggeration: bpy.props.FloatProperty(
        name="Heights x (0 = auto)",
        description="Exaggeration of heights, for eye and hand; 0 chooses a round one that shows the relief",
        default=0.0,
        min=0.0,
        max=10_000.0,
    )
    # A region belongs to one grid: kept from one call to the next, it would cut others.
    region: bpy.props.EnumProperty(
        name="Region",
        description="The part that is read: of the rest not one sample is",
        items=[
            (RegionBy.WHOLE, "Whole", "The whole grid"),
            (RegionBy.DEGREES, "Degrees", "A box of longitude and latitude"),
            (RegionBy.SAMPLES, "Samples", "Rows and columns"),
        ],
        options={"SKIP_SAVE"},
    )
    west: bpy.props.FloatProperty(
        name="West",
        description="Degrees east, +-180 or 0 to 360",
        default=0.0,
        min=-720.0,
        max=720.0,
        precision=5,
    )
    east: bpy.props.FloatProperty(
        name="East",
        description="Degrees east, +-180 or 0 to 360; beyond 360 where the box lies over the meridian",
        default=360.0,
        min=-720.0,
        max=720.0,
        precision=5,
    )
    south: bpy.props.FloatProperty(
        name="South", description="Degrees north", default=-90.0, min=-90.0, max=90.0, precision=5
    )
    north: bpy.props.FloatProperty(
        name="North", description="Degrees north", default=90.0, min=-90.0, max=90.0, precision=5
    )
    first_column: bpy.props.IntProperty(name="First Column", description="Counted from 0 in the west", min=0)
    first_row: bpy.props.IntProperty(name="First Row", description="Counted from 0 in the north", min=0)
    columns: bpy.props.IntProperty(name="Columns (0 = rest)", min=0)
    rows: bpy.props.IntProperty(name="Rows (0 = rest)", min=0)
    fill_voids: bpy.props.BoolProperty(
        name="Fill Voids",
        description="Give holes heights from around them, for eye and hand; they are coloured violet",
        default=False,
    )
    placed: bpy.props.BoolProperty(
        name="Place by Hand",
        description="For a renamed SRTM square (.hgt), whose name does not say where it lies",
        default=False,
        options={"SKIP_SAVE"},
    )
    latitude: bpy.props.FloatProperty(
        name="Latitude", description="Degrees north of the lower left corner", min=-90.0, max=89.0
    )
    longitude: bpy.props.FloatProperty(
        name="Longitude", description="Degrees east of the lower left corner", min=-360.0, max=360.0
    )


def chosen_options(choices: ImportChoices) -> ImportOptions:
    """Read the properties."""
    return ImportOptions(
        vertex_budget=choices.vertex_budget,
        scale=SceneScale(choices.scale),
        exaggeration=choices.exaggeration,
        region=_region(choices),
        fill_voids=choices.fill_voids,
        position=(choices.latitude, choices.longitude) if choices.placed else None,
    )


def draw_choices(choices: ImportChoices, layout: Any, *, unplaced: bool) -> None:
    """Show the properties.

    Args:
        unplaced: whether the chosen file does not say where it lies.
    """
    for name in (
        "vertex_budget",
        "scale",
        "exaggeration",
        "region",
        *REGION_FIELDS[RegionBy(choices.region)],
    ):
        layout.prop(choices, name)
    layout.prop(choices, "fill_voids")
    if unplaced or choices.placed:
        for name in ("placed", *(("latitude", "longitude") if choices.placed else ())):
            layout.prop(choices, name)


def _region(choices: ImportChoices) -> ChosenRegion | None:
    match RegionBy(choices.region):
        case RegionBy.DEGREES:
            return LongitudeLatitudeBox(choices.west, choices.east, choices.south, choices.north)
        case RegionBy.SAMPLES:
            return RowsAndColumns(choices.first_column, choices.first_row, choices.columns, choices.rows)
        case RegionBy.WHOLE:
            return None
