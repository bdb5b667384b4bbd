"""The terrain in the properties editor, under Object Data."""

from __future__ import annotations

import bpy

from ...terrain.byte_size import in_bytes
from ...terrain.kept import KeptError, KeptTerrain, is_terrain, recall
from ...touch.live import live
from ..import_description import memory
from ..sidebar import draw_message
from ..terrain_operators import HAPTIC_TERRAIN_OT_rebuild, HAPTIC_TERRAIN_OT_relink
from ..terrain_words import missing

VERTEX_BYTES = 12 + 4 + 4 + 6 * 4 + 3 * 8 + 2 * 4
"""Of a preview: place, elevation, slope; and about 6 corners, 3 edges and 2 faces that belong to a vertex."""


class HAPTIC_TERRAIN_PT_data(bpy.types.Panel):
    """File, detail, region and heights of the terrain"""

    bl_label = "Haptic Terrain"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "data"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only for terrains."""
        return is_terrain(context.object)

    def draw(self, context: bpy.types.Context) -> None:
        """What it is made of, and what can be changed."""
        layout, terrain = self.layout, context.object
        if layout is None or terrain is None:
            return
        layout.use_property_split = True
        layout.use_property_decorate = False
        try:
            kept = recall(terrain)
        except KeptError as error:
            draw_message(layout, str(error))
            return
        column = layout.column()
        column.enabled = terrain.library is None and terrain.mode != "EDIT"
        column.prop(terrain.haptic_terrain, "exaggeration")
        if not kept.grid.data_path.is_file():
            draw_message(layout, missing(kept))
        _draw_facts(layout, terrain, kept)
        row = layout.row(align=True)
        row.operator(HAPTIC_TERRAIN_OT_rebuild.bl_idname, icon="FILE_REFRESH", text="Rebuild")
        row.operator(HAPTIC_TERRAIN_OT_relink.bl_idname, icon="FILEBROWSER", text="Relink")


def _draw_facts(layout: bpy.types.UILayout, terrain: bpy.types.Object, kept: KeptTerrain) -> None:
    grid = kept.grid
    region = "the whole grid" if kept.region is None else str(kept.region)
    opened = "open" if live.touch is not None and live.touch.terrain.find() == terrain else memory(grid)
    vertices = len(terrain.data.vertices)
    column = layout.column(align=True)
    for name, value in (
        ("File", grid.data_path.name),
        ("Region", region),
        ("To touch", f"{grid.samples:,} samples, {opened}"),
        ("To see", f"{vertices:,} of at most {kept.vertex_budget:,} vertices"),
        ("Memory", f"about {in_bytes(vertices * VERTEX_BYTES)} for the preview"),
    ):
        row = column.split(factor=0.3)
        row.label(text=name)
        row.label(text=value)
