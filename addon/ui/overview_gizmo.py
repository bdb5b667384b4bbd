"""Clicking on the overview map, to go there.

A gizmo, because Blender asks gizmos before tools and keymaps: a click on the map reaches nothing that lies
under it, and a click beside it, or any other key, passes by as if there were no map. The overlay draws the
map; the gizmo only says where it is.
"""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from ..formats import FormatError
from ..overlay.overview import placed_map
from ..overlay.overview_map import OverviewMap
from ..overlay.view import view_of
from ..terrain.kept import KeptError, recall
from ..touch.go_to import go_on_map
from ..touch.live import RENDERING, live
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_overview_go(bpy.types.Operator):
    """Go to this place of the terrain: with the hand, the Touch Target, the 3D cursor and the view"""

    bl_idname = "haptic_terrain.overview_go"
    bl_label = "Go to Place on Overview Map"
    bl_options = {"UNDO", "INTERNAL"}  # noqa: RUF012

    east: bpy.props.FloatProperty(name="East", description="Metres from the grid's first column")
    north: bpy.props.FloatProperty(name="North", description="Metres from the grid's first row, below 0")

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while touch runs."""
        if live.touch is None:
            cls.poll_message_set("Touch is not running: start it first")
        elif live.rendering:
            cls.poll_message_set(RENDERING)
        return live.touch is not None and not live.rendering

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Find the place under the pointer."""
        chart = _chart(context)
        if chart is None or not chart.rect.contains(event.mouse_region_x, event.mouse_region_y):
            return {"PASS_THROUGH", "CANCELLED"}
        self.east, self.north = chart.place(event.mouse_region_x, event.mouse_region_y)
        return self.execute(context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Go."""
        terrain = live.touch.terrain.find() if live.touch is not None else None
        if terrain is None:
            return {"CANCELLED"}
        try:
            go_on_map(context, terrain, recall(terrain), self.east, self.north)
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class HAPTIC_TERRAIN_GT_overview(bpy.types.Gizmo):
    """The map's place in a region."""

    bl_idname = "HAPTIC_TERRAIN_GT_overview"

    def draw(self, context: bpy.types.Context) -> None:
        """The overlay draws it, whether gizmos are shown or not."""

    def test_select(self, context: bpy.types.Context, location: Sequence[int] | None) -> int:
        """Whether a pixel is on the map; -1 where it is not."""
        chart = _chart(context)
        return 0 if chart is not None and location is not None and chart.rect.contains(*location) else -1


class HAPTIC_TERRAIN_GGT_overview(bpy.types.GizmoGroup):
    """The map, where it can be clicked."""

    bl_idname = "HAPTIC_TERRAIN_GGT_overview"
    bl_label = "Overview Map"
    bl_space_type = "VIEW_3D"
    bl_region_type = "WINDOW"
    bl_options = {"PERSISTENT"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Where the overlay shows the map."""
        touch, scene, space = live.touch, context.scene, context.space_data
        return (
            touch is not None
            and scene is not None
            and scene.session_uid == touch.scene.session_uid
            and scene.haptic_terrain.show_overview
            and space.overlay.show_overlays
        )

    def setup(self, context: bpy.types.Context) -> None:
        """A click goes there."""
        gizmo = self.gizmos.new(HAPTIC_TERRAIN_GT_overview.bl_idname)
        gizmo.target_set_operator(HAPTIC_TERRAIN_OT_overview_go.bl_idname)
        gizmo.use_draw_modal = True


def _chart(context: bpy.types.Context) -> OverviewMap | None:
    """The map in the region of a context."""
    view, touch = view_of(context), live.touch
    return placed_map(view, touch.grid.layout) if view is not None and touch is not None else None
