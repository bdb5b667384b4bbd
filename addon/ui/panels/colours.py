"""What the terrain's colours mean."""

from __future__ import annotations

import bpy

from ...terrain.terrain_material import ColourBy, colour_by, filled_colour, legend, material_of
from ...touch.place_words import DEGREE
from ..chosen import shown_terrain
from ..place_operators import HAPTIC_TERRAIN_OT_colour_by
from ..sidebar import TAB

UNITS = {ColourBy.ELEVATION: " m", ColourBy.SLOPE: DEGREE}
"""After a value of the legend."""


class HAPTIC_TERRAIN_PT_colours(bpy.types.Panel):
    """The legend; its swatches are the material's own colours, and may be changed."""

    bl_label = "Colours"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_parent_id = "HAPTIC_TERRAIN_PT_terrain"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while the terrain has the material that was made for it."""
        terrain = shown_terrain(context)
        return terrain is not None and material_of(terrain) is not None

    def draw(self, context: bpy.types.Context) -> None:
        """Choose what is coloured, and say what each colour stands for."""
        terrain = shown_terrain(context)
        material = material_of(terrain) if terrain is not None else None
        if self.layout is None or material is None:
            return
        now = colour_by(material)
        row = self.layout.row(align=True)
        for what in ColourBy:
            button = row.operator(
                HAPTIC_TERRAIN_OT_colour_by.bl_idname, text=what.title(), depress=what is now
            )
            button.what = what
        column = self.layout.column(align=True)
        for swatch in legend(material):
            row = column.split(factor=0.3)
            row.prop(swatch.element, "color", text="")
            row.label(text=f"{swatch.value:,.{0 if now is ColourBy.ELEVATION else 1}f}{UNITS[now]}")
        filled = filled_colour(material)
        if filled is not None:
            row = column.split(factor=0.3)
            row.prop(filled, "default_value", text="")
            row.label(text="filled, not measured")
