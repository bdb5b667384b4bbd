"""Go to Place, Show Curvature and Colour By."""

from __future__ import annotations

import bpy

from ..formats import FormatError
from ..terrain.curvature import CurvatureError, show_curvature
from ..terrain.kept import KeptError, recall
from ..terrain.terrain_material import ColourBy, material_of, set_colour_by
from ..terrain.view import redraw
from ..touch.go_to import PlaceError, go_to
from ..touch.live import live
from ..touch.placement import Placement
from ..touch.target import move_target, target_object
from .chosen import poll_terrain, shown_terrain
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_go_to(bpy.types.Operator):
    """Bring the 3D cursor, the Touch Target and the view to a longitude and latitude"""

    bl_idname = "haptic_terrain.go_to"
    bl_label = "Go to Place"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    longitude: bpy.props.FloatProperty(
        name="Longitude", description="Degrees east, +-180 or 0 to 360", min=-360.0, max=360.0, precision=5
    )
    latitude: bpy.props.FloatProperty(
        name="Latitude",
        description="Degrees north, of the kind that the grid has",
        min=-90.0,
        max=90.0,
        precision=5,
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain."""
        return poll_terrain(cls, context)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Ask for the place."""
        context.window_manager.invoke_props_dialog(self)
        return {"RUNNING_MODAL"}

    def draw(self, context: bpy.types.Context) -> None:
        """Say what kind of latitude is meant."""
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "longitude")
        layout.prop(self, "latitude")
        terrain = shown_terrain(context)
        if terrain is None:
            return
        try:
            kind = recall(terrain).grid.georeference.latitude_kind
        except KeptError:
            return
        layout.label(text=f"Latitudes of this map are {kind}")

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Go."""
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            go_to(context, terrain, self.longitude, self.latitude)
        except (PlaceError, FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_show_curvature(bpy.types.Operator):
    """Show the terrain on its sphere, or flat; the grid and what is felt stay as they are"""

    bl_idname = "haptic_terrain.show_curvature"
    bl_label = "Show Curvature"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    curved: bpy.props.BoolProperty(name="Curved", description="On the sphere, or flat", default=True)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain, and not in the middle of a take."""
        if live.recording is not None:
            cls.poll_message_set("A take is being recorded: stop it first")
            return False
        return poll_terrain(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Bend; the Touch Target stays over its place on the map."""
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            before = Placement.of(terrain, recall(terrain).frame)
            show_curvature(terrain, live.opened, curved=self.curved)
            after = Placement.of(terrain, recall(terrain).frame)
        except (CurvatureError, FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        target = target_object(context.scene) if context.scene is not None else None
        if target is not None and context.scene is not None and before.is_usable:
            place = before.to_terrain(target.matrix_world.translation)
            move_target(context.scene, after.to_scene(*place))
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_colour_by(bpy.types.Operator):
    """Colour the terrain by elevation, or by how steep the true ground is"""

    bl_idname = "haptic_terrain.colour_by"
    bl_label = "Colour By"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    what: bpy.props.EnumProperty(
        name="Colour By",
        items=[
            (ColourBy.ELEVATION, "Elevation", "Metres above the grid's reference"),
            (ColourBy.SLOPE, "Slope", "Degrees from the horizontal, at exaggeration 1"),
        ],
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain."""
        return poll_terrain(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Change the terrain's own material."""
        terrain = shown_terrain(context)
        material = material_of(terrain) if terrain is not None else None
        if material is None:
            self.report({"ERROR"}, "The terrain has another material now: colour it there.")
            return {"CANCELLED"}
        set_colour_by(material, ColourBy(self.what))
        redraw(context)
        return {"FINISHED"}
