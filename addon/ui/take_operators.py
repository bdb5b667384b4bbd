"""Export Take and Import Take."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy_extras.io_utils import ExportHelper, ImportHelper

from ..formats import FormatError
from ..record.about_properties import OtherTerrainError
from ..record.files.geojson_file import NoPlaceError
from ..record.kept_take import KeptTakeError, is_take
from ..record.take_files import export_take, import_take
from ..terrain.kept import KeptError
from ..terrain.progress import progress
from ..terrain.undone import undone_on_failure
from .chosen import poll_terrain, shown_terrain
from .operator_status import OperatorStatus
from .take_report import report_take

FORMATS = [
    ("CSV", "CSV", "A table of all ticks, as text"),
    ("NPZ", "NPZ", "All ticks as arrays for numpy"),
    ("GEOJSON", "GeoJSON", "The path alone: longitude, latitude and elevation"),
]


def chosen_take(context: bpy.types.Context) -> bpy.types.Object | None:
    """Find the take that is meant: the active object, else the one in the settings, else the only one."""
    active = context.view_layer.objects.active
    if is_take(active):
        return active
    kept: bpy.types.Object | None = context.scene.haptic_terrain.take
    if is_take(kept):
        return kept
    takes = [thing for thing in context.scene.objects if is_take(thing)]
    return takes[0] if len(takes) == 1 else None


class HAPTIC_TERRAIN_OT_export_take(bpy.types.Operator, ExportHelper):  # type: ignore[misc]
    """Write all ticks of a take to a file"""

    bl_idname = "haptic_terrain.export_take"
    bl_label = "Export Take"

    filename_ext = ".csv"
    filter_glob: bpy.props.StringProperty(default="*.csv;*.npz;*.geojson", options={"HIDDEN"})
    format: bpy.props.EnumProperty(
        name="Format",
        items=FORMATS,
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a take."""
        take = chosen_take(context)
        if take is None:
            cls.poll_message_set("Select a take: an object that Stop Recording made")
        return take is not None

    def check(self, context: bpy.types.Context) -> bool:
        """Give the file the ending of the chosen format, in the file browser; scripts say it by the path."""
        before = self.filepath  # type: ignore[has-type]
        self.filepath = str(Path(before).with_suffix(f".{self.format.lower()}")) if before else before
        return bool(self.filepath != before)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Write it."""
        take = chosen_take(context)
        if take is None:
            return {"CANCELLED"}
        path = Path(bpy.path.abspath(self.filepath))
        try:
            with progress(context) as tell:
                data, missing = export_take(take, path, tell)
        except (KeptTakeError, NoPlaceError, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, f"{path.name} cannot be written: {error.strerror}. Choose another folder.")
            return {"CANCELLED"}
        if missing:
            self.report({"WARNING"}, missing)
        self.report({"INFO"}, f"{path.name}: {len(data):,} ticks, {data.seconds:.1f} s")
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_import_take(bpy.types.Operator, ImportHelper):  # type: ignore[misc]
    """Make a take of a file that was exported as CSV or NPZ, from the current frame on"""

    bl_idname = "haptic_terrain.import_take"
    bl_label = "Import Take"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    filename_ext = ".csv"
    filter_glob: bpy.props.StringProperty(default="*.csv;*.npz", options={"HIDDEN"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with the terrain that it was felt on."""
        return poll_terrain(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Read it."""
        terrain = shown_terrain(context)
        if terrain is None or context.scene is None:
            return {"CANCELLED"}
        path = Path(bpy.path.abspath(self.filepath))
        try:
            with progress(context) as tell, undone_on_failure():
                take, notes = import_take(context.scene, terrain, path, tell)
        except (FormatError, KeptError, KeptTakeError, OtherTerrainError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, f"{path.name} cannot be read: {error.strerror}.")
            return {"CANCELLED"}
        for note in notes:
            self.report({"WARNING"}, note)
        report_take(self, take)
        return {"FINISHED"}


def draw_export(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    """Add the entry to File > Export."""
    self.layout.operator(HAPTIC_TERRAIN_OT_export_take.bl_idname, text="Touch take (.csv .npz .geojson)")


def draw_import(self: bpy.types.Menu, _context: bpy.types.Context) -> None:
    """Add the entry to File > Import."""
    self.layout.operator(HAPTIC_TERRAIN_OT_import_take.bl_idname, text="Touch take (.csv .npz)")
