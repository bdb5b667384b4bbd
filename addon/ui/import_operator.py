"""File > Import > Elevation terrain, drops on the 3D view, and imports from scripts: one road."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
from bpy_extras.io_utils import ImportHelper

from ..formats import SUFFIXES
from ..terrain.import_job import Imported, ImportJob
from ..terrain.kept import recall
from ..terrain.progress import progress
from ..terrain.view import frame_selected, show_materials
from ..touch.live import live
from .import_choices import ImportChoices, chosen_options, draw_choices
from .import_description import described, is_unplaced
from .job_operator import JobOperator
from .operator_status import OperatorStatus
from .preferences import preferences

LABEL = "Elevation terrain"
"""Also of the operator: a drop that Blender takes for an image too gets a menu of operators."""

TITLE = "Import Elevation Terrain"
"""Of the dialog, and of buttons."""


class HAPTIC_TERRAIN_OT_import_grid(JobOperator, bpy.types.Operator, ImportHelper, ImportChoices):
    """Import elevation grids as terrains that can be touched"""

    bl_idname = "haptic_terrain.import_grid"
    bl_label = LABEL
    bl_options = {"REGISTER", "UNDO", "PRESET"}  # noqa: RUF012

    # Kept from one call to the next, they would be taken for dropped files.
    filepath: bpy.props.StringProperty(
        name="File",
        description="An elevation grid, or its label or header",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    directory: bpy.props.StringProperty(subtype="DIR_PATH", options={"SKIP_SAVE", "HIDDEN"})
    files: bpy.props.CollectionProperty(
        type=bpy.types.OperatorFileListElement, options={"SKIP_SAVE", "HIDDEN"}
    )
    filter_glob: bpy.props.StringProperty(
        default=";".join(f"*{suffix}" for suffix in SUFFIXES), options={"HIDDEN"}
    )
    answered: bpy.props.BoolProperty(
        description="A person has chosen already: import now, with progress, and let them cancel",
        default=False,
        options={"SKIP_SAVE", "HIDDEN"},
    )

    _asking = False
    """Whether a dialog or the file browser is open, whose answer will be ``execute``."""

    def invoke(  # type: ignore[override]  # the two base classes do not agree
        self, context: bpy.types.Context, event: bpy.types.Event
    ) -> OperatorStatus:
        """Ask for files, or only for the options when some were dropped; then import."""
        if self.answered:
            return self.begin(context, ImportJob(chosen_paths(self), chosen_options(self)))
        chosen = preferences(context)
        if chosen is not None and not self.properties.is_property_set("vertex_budget"):
            self.vertex_budget = chosen.vertex_budget
        self._asking = True
        if self.filepath or self.files:
            context.window_manager.invoke_props_dialog(self, width=400, title=TITLE, confirm_text="Import")
        else:
            ImportHelper.invoke(self, context, event)
        return {"RUNNING_MODAL"}

    def draw(self, context: bpy.types.Context) -> None:
        """Show the options, and what they mean for the chosen file."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        paths = chosen_paths(self)
        first, options = paths[0], chosen_options(self)
        draw_choices(self, layout, unplaced=is_unplaced(first, options))
        box = layout.box().column(align=True)
        if len(paths) > 1:
            box.label(text=f"{len(paths)} files; the first is")
        for line in described(first, options):
            box.label(text=line)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Import: at once for scripts; for a person who was asked, in steps that can be cancelled."""
        if self._asking and not bpy.app.background:
            choices = self.as_keywords(ignore=("files", "filter_glob", "answered"))
            files = [{"name": file.name} for file in self.files]
            bpy.ops.haptic_terrain.import_grid("INVOKE_DEFAULT", **choices, files=files, answered=True)
            return {"CANCELLED"}  # the other call finishes, and is what can be undone
        job = ImportJob(chosen_paths(self), chosen_options(self))
        with progress(context) as tell:
            job.run(tell)
        return self.end(context, job)

    def end(self, context: bpy.types.Context, job: ImportJob) -> OperatorStatus:
        """Put the terrains into the scene, and tell what came of it."""
        if job.cancelled:
            self.report({"INFO"}, "Import cancelled: nothing was added")
            return {"CANCELLED"}
        imported = job.finish(context, live.opened)
        _frame(context, imported)
        for terrain in imported.terrains:
            self.report({"INFO"}, _summary(terrain))
            for note in recall(terrain).grid.notes:
                self.report({"WARNING"}, f"{terrain.name}: {note}")
        # An error ends a script; where something was imported, what was not is a warning there.
        kind = "WARNING" if imported.terrains and not self.answered else "ERROR"
        for failure in imported.failures:
            self.report({kind}, str(failure))  # type: ignore[arg-type]
        return {"FINISHED"} if imported.terrains else {"CANCELLED"}


class HAPTIC_TERRAIN_FH_grid(bpy.types.FileHandler):
    """Files that can be dropped into a 3D view."""

    bl_idname = "HAPTIC_TERRAIN_FH_grid"
    bl_label = LABEL
    bl_import_operator = HAPTIC_TERRAIN_OT_import_grid.bl_idname
    bl_file_extensions = ";".join(SUFFIXES)

    @classmethod
    def poll_drop(cls, context: bpy.types.Context | None) -> bool:
        """Take drops where terrain would be seen, and from scripts, which have no area."""
        return context is None or context.area is None or context.area.type in {"VIEW_3D", "OUTLINER"}


def chosen_paths(operator: Any) -> list[Path]:
    """The files that an operator's ``directory`` and ``files``, or else its ``filepath``, name."""
    names = [file.name for file in operator.files if file.name]
    if operator.directory and names:
        return [Path(bpy.path.abspath(operator.directory)) / name for name in names]
    return [Path(bpy.path.abspath(operator.filepath))]


def draw_menu(self: Any, context: bpy.types.Context) -> None:
    """Add the entry to File > Import."""
    self.layout.operator(HAPTIC_TERRAIN_OT_import_grid.bl_idname, text=LABEL)


def _frame(context: bpy.types.Context, imported: Imported) -> None:
    """Show all that was imported, in its colours."""
    shown = [terrain for terrain in imported.terrains if len(terrain.data.vertices)]
    if not shown:
        return
    show_materials(context)
    context.view_layer.update()
    for terrain in shown:
        if context.view_layer.objects.get(terrain.name) is not None:
            terrain.select_set(True)
    frame_selected(context, sum(max(terrain.dimensions[:]) for terrain in shown))


def _summary(terrain: bpy.types.Object) -> str:
    kept = recall(terrain)
    return (
        f"{kept.grid.title}: {kept.grid.samples:,} samples to touch, "
        f"{len(terrain.data.vertices):,} shown, heights x{kept.frame.exaggeration:g}"
    )
