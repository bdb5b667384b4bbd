"""Mark A, Mark B, Add Profile and Export Profile."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy_extras.io_utils import ExportHelper

from ..formats import FormatError
from ..formats.profiles.profile import Profile
from ..formats.profiles.profile_csv import write_profile
from ..terrain.kept import KeptError, recall
from ..terrain.marks import marks_of
from ..terrain.undone import undone_on_failure
from ..touch.go_to import PlaceError
from ..touch.live import RENDERING, live
from ..touch.marking import mark, marked_profile
from ..touch.profile_curve import add_profile_curve
from .chosen import poll_terrain, shown_terrain
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_mark(bpy.types.Operator):
    """Mark the place that is touched, or that of the 3D cursor while nothing is"""

    bl_idname = "haptic_terrain.mark"
    bl_label = "Mark"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    which: bpy.props.EnumProperty(
        name="Mark", items=[("A", "A", "The first end"), ("B", "B", "The other end")]
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain."""
        return poll_terrain(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Mark."""
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            mark(context, terrain, self.which)
        except (PlaceError, FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_add_profile(bpy.types.Operator):
    """Draw the line from A to B on the terrain"""

    bl_idname = "haptic_terrain.add_profile"
    bl_label = "Add Profile"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only between two marks, and not while a picture is rendered."""
        if live.rendering:
            cls.poll_message_set(RENDERING)
            return False
        return _poll_marked(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Draw it."""
        terrain = shown_terrain(context)
        if terrain is None or context.scene is None:
            return {"CANCELLED"}
        try:
            with undone_on_failure():
                cut = marked_profile(terrain)
                if cut is None:
                    return {"CANCELLED"}
                add_profile_curve(context.scene, terrain, cut)
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, _summary(cut))
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_export_profile(bpy.types.Operator, ExportHelper):  # type: ignore[misc]
    """Write the profile from A to B as a table (CSV)"""

    bl_idname = "haptic_terrain.export_profile"
    bl_label = "Export Profile"

    filename_ext = ".csv"
    filter_glob: bpy.props.StringProperty(default="*.csv", options={"HIDDEN"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only between two marks."""
        return _poll_marked(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Write it."""
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        path = Path(bpy.path.abspath(self.filepath))
        try:
            cut = marked_profile(terrain)
            if cut is None:
                return {"CANCELLED"}
            write_profile(path, cut, recall(terrain).grid.georeference)
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, f"{path.name} cannot be written: {error.strerror}. Choose another folder.")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{path.name}: {_summary(cut)}")
        return {"FINISHED"}


def _poll_marked(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    terrain = shown_terrain(context)
    if terrain is None:
        return poll_terrain(cls, context)
    marks = marks_of(terrain)
    if marks.a is None or marks.b is None:
        cls.poll_message_set("Mark A and B first")
        return False
    if marks.a == marks.b:
        cls.poll_message_set("A and B are the same place; while touch runs, a mark is where the hand is")
        return False
    return True


def _summary(cut: Profile) -> str:
    exact = "" if cut.exact else ", sampled evenly"
    return f"{cut.length / 1000.0:,.3f} km, {len(cut.points):,} points{exact}"
