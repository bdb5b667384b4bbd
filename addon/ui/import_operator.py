"""File > Import > Planetary Terrain."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import bpy
from bpy_extras.io_utils import ImportHelper

from ..formats import SUFFIXES, ElevationGrid, FormatError, read_grid
from ..formats.partner_file import is_file
from ..terrain.import_terrain import ImportOptions, SceneScale, import_terrain
from ..terrain.kept import recall
from ..terrain.preview import VERTEX_BUDGET, preview_cells
from ..terrain.view import frame_selected
from .operator_status import OperatorStatus
from .wrapped import wrapped

DIALOG_LETTERS = 48
"""That a line of the dialog holds."""


class HAPTIC_TERRAIN_OT_import_grid(bpy.types.Operator, ImportHelper):
    """Import an elevation grid as a terrain that can be touched"""

    bl_idname = "haptic_terrain.import_grid"
    bl_label = "Import Planetary Terrain"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    # Kept from one call to the next, it would be taken for a dropped file.
    filepath: bpy.props.StringProperty(
        name="File",
        description="Label (.lbl) or data file (.img)",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    filter_glob: bpy.props.StringProperty(
        default=";".join(f"*{suffix}" for suffix in SUFFIXES), options={"HIDDEN"}
    )
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

    def invoke(  # type: ignore[override]  # the two base classes do not agree
        self, context: bpy.types.Context, event: bpy.types.Event
    ) -> OperatorStatus:
        """Ask for a file, or only for the options when one was dropped."""
        if self.filepath:
            context.window_manager.invoke_props_dialog(self, confirm_text="Import")
        else:
            ImportHelper.invoke(self, context, event)
        return {"RUNNING_MODAL"}

    def draw(self, context: bpy.types.Context) -> None:
        """Show the options, and what they mean for the chosen file."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("vertex_budget", "scale", "exaggeration"):
            layout.prop(self, name)
        box = layout.box()
        for line in preview_lines(Path(bpy.path.abspath(self.filepath)), self.vertex_budget):
            box.label(text=line)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Import the file."""
        options = ImportOptions(self.vertex_budget, SceneScale(self.scale), self.exaggeration)
        try:
            terrain = import_terrain(context, Path(bpy.path.abspath(self.filepath)), options)
        except FormatError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        kept = recall(terrain)
        if len(terrain.data.vertices):
            frame_selected(context, max(terrain.dimensions[:]))
        self.report(
            {"INFO"},
            f"{kept.grid.title}: {kept.grid.samples:,} samples to touch, "
            f"{len(terrain.data.vertices):,} shown, heights x{kept.frame.exaggeration:g}",
        )
        return {"FINISHED"}


class HAPTIC_TERRAIN_FH_grid(bpy.types.FileHandler):
    """Files that can be dropped into a 3D view."""

    bl_idname = "HAPTIC_TERRAIN_FH_grid"
    bl_label = "Planetary Terrain"
    bl_import_operator = HAPTIC_TERRAIN_OT_import_grid.bl_idname
    bl_file_extensions = ";".join(SUFFIXES)

    @classmethod
    def poll_drop(cls, context: bpy.types.Context | None) -> bool:
        """Take drops where terrain would be seen, and from scripts, which have no area."""
        return context is None or context.area is None or context.area.type in {"VIEW_3D", "OUTLINER"}


def preview_lines(path: Path, vertex_budget: int) -> list[str]:
    """Describe a file from its label alone: what it has, and how much of it would be shown."""
    if not is_file(path):
        return ["Choose a label (.lbl) or a data file (.img)"]
    grid = _cached_grid(path, _ages(path))
    if isinstance(grid, FormatError):
        return wrapped(str(grid), DIALOG_LETTERS)
    shown = preview_cells(grid.layout, vertex_budget)
    return [
        grid.title,
        f"{grid.layout.columns:,} x {grid.layout.rows:,} = {grid.samples:,} samples to touch",
        f"{shown.vertices:,} vertices to see",
    ]


def draw_menu(self: Any, context: bpy.types.Context) -> None:
    """Add the entry to File > Import."""
    self.layout.operator(HAPTIC_TERRAIN_OT_import_grid.bl_idname, text="Planetary Terrain (.lbl, .img)")


@lru_cache(maxsize=1)
def _cached_grid(path: Path, _ages: tuple[int, ...]) -> ElevationGrid | FormatError:
    """Remember the last label, also one that is refused: the file browser asks each time it is drawn."""
    try:
        return read_grid(path)
    except FormatError as error:
        return error


def _ages(path: Path) -> tuple[int, ...]:
    """When the file, its partner and their folder were changed: what was refused may have been mended."""
    ages = []
    for place in (path, path.with_suffix(".lbl"), path.with_suffix(".img"), path.parent):
        try:
            ages.append(place.stat().st_mtime_ns)
        except OSError:
            ages.append(0)
    return tuple(ages)
