"""Distance, rise and slope between two marked places."""

from __future__ import annotations

import bpy

from ...terrain.marks import Between, marks_of
from ...touch.place_words import DEGREE, Line
from ..chosen import shown_terrain
from ..profile_operators import (
    HAPTIC_TERRAIN_OT_add_profile,
    HAPTIC_TERRAIN_OT_export_profile,
    HAPTIC_TERRAIN_OT_mark,
)
from ..sidebar import TAB, draw_lines


class HAPTIC_TERRAIN_PT_profile(bpy.types.Panel):
    """Two marks, and what lies between."""

    bl_label = "Profile"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_parent_id = "HAPTIC_TERRAIN_PT_terrain"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain."""
        return shown_terrain(context) is not None

    def draw(self, context: bpy.types.Context) -> None:
        """Mark, read off, draw, export."""
        terrain = shown_terrain(context)
        if self.layout is None or terrain is None:
            return
        marks = marks_of(terrain)
        row = self.layout.row(align=True)
        for name, place in (("A", marks.a), ("B", marks.b)):
            text = f"Mark {name}" if place is None else f"Mark {name} Again"
            button = row.operator(HAPTIC_TERRAIN_OT_mark.bl_idname, text=text)
            button.which = name
        if marks.between is not None:
            draw_lines(self.layout, between_lines(marks.between))
            self.layout.operator(HAPTIC_TERRAIN_OT_add_profile.bl_idname, icon="CURVE_DATA")
            self.layout.operator(HAPTIC_TERRAIN_OT_export_profile.bl_idname, icon="EXPORT")


def between_lines(between: Between) -> list[Line]:
    """Put into words what lies between two marks."""
    lines = [("Distance", f"{between.length / 1000.0:,.3f} km")]
    if between.difference is not None:
        lines.append(("A to B", f"{between.difference:+,.1f} m"))
    if between.slope is not None:
        lines.append(("Slope", f"{between.slope:+.2f}{DEGREE}"))
    lines += [
        ("Up, down", f"{between.rise:,.0f} m, {between.fall:,.0f} m"),
        ("Steepest", f"{between.steepest_slope:.2f}{DEGREE} (mean {between.mean_slope:.2f}{DEGREE})"),
    ]
    if between.void_length > 0.0:
        lines.append(("No data", f"{between.void_length / 1000.0:,.3f} km"))
    return lines
