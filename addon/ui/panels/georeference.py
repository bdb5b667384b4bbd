"""Where the terrain is on its body, and going to a place on it."""

from __future__ import annotations

import bpy

from ...terrain.kept import KeptError, recall
from ...touch.place_words import georeference_lines
from ..chosen import shown_terrain
from ..place_operators import HAPTIC_TERRAIN_OT_go_to, HAPTIC_TERRAIN_OT_show_curvature
from ..sidebar import TAB, draw_lines, draw_text


class HAPTIC_TERRAIN_PT_georeference(bpy.types.Panel):
    """What the numbers of the grid mean."""

    bl_label = "Georeference"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_parent_id = "HAPTIC_TERRAIN_PT_terrain"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012  # so that Touch is seen without scrolling

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain."""
        return shown_terrain(context) is not None

    def draw(self, context: bpy.types.Context) -> None:
        """Body, projection, latitudes, heights; buttons; what the reader had to say."""
        terrain = shown_terrain(context)
        if self.layout is None or terrain is None:
            return
        try:
            kept = recall(terrain)
        except KeptError:
            return  # the panel above says so
        draw_lines(self.layout, [("Format", kept.grid.format), *georeference_lines(kept.grid.georeference)])
        self.layout.operator(HAPTIC_TERRAIN_OT_go_to.bl_idname, icon="VIEWZOOM")
        curved = kept.frame.bend is not None
        button = self.layout.operator(
            HAPTIC_TERRAIN_OT_show_curvature.bl_idname, icon="SPHERE", depress=curved
        )
        button.curved = not curved
        for note in kept.grid.notes:
            draw_text(self.layout, note)
