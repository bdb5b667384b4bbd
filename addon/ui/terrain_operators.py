"""Rebuild Terrain and Relink Terrain: another preview, another region, a file that was moved or changed."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import bpy
from bpy_extras.io_utils import ImportHelper
from proxygraph import CancelledError

from ..formats import SUFFIXES, FormatError
from ..terrain.chosen_region import ChosenRegion, LongitudeLatitudeBox
from ..terrain.kept import KeptError, recall
from ..terrain.options import ImportOptions
from ..terrain.progress import progress
from ..terrain.rebuild import RebuildJob, header_of, options_of, relink
from ..touch.live import RENDERING, live
from .chosen import poll_terrain, shown_terrain
from .import_choices import ImportChoices, RegionBy, chosen_options, draw_choices
from .import_description import described
from .job_operator import JobOperator
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_rebuild(JobOperator, bpy.types.Operator, ImportChoices):
    """Read the terrain's file again: with other detail, another region, or after the file has changed"""

    bl_idname = "haptic_terrain.rebuild"
    bl_label = "Rebuild Terrain"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    answered: bpy.props.BoolProperty(
        description="A person has chosen already: rebuild now, with progress, and let them cancel",
        default=False,
        options={"SKIP_SAVE", "HIDDEN"},
    )

    _asking = False
    """Whether the dialog is open, whose answer will be ``execute``."""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain of this file that nobody touches."""
        return _poll_changeable(cls, context)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Ask, beginning with how the terrain is now; then rebuild."""
        if self.answered:
            return self._begun(context)
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            _fill_in(self, options_of(recall(terrain)))
        except KeptError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._asking = True
        context.window_manager.invoke_props_dialog(
            self, width=400, title=self.bl_label, confirm_text="Rebuild"
        )
        return {"RUNNING_MODAL"}

    def draw(self, context: bpy.types.Context) -> None:
        """The choices, and what they mean."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        draw_choices(self, layout, unplaced=False)
        terrain = shown_terrain(context)
        if terrain is None:
            return
        box = layout.box().column(align=True)
        try:
            lines = described(header_of(recall(terrain)), chosen_options(self))
        except (FormatError, KeptError) as error:
            lines = [str(error)]
        for line in lines:
            box.label(text=line)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Rebuild: at once for scripts, where what is not given stays as it is; else in steps."""
        if self._asking and not bpy.app.background:
            choices = self.as_keywords(ignore=("answered",))
            bpy.ops.haptic_terrain.rebuild("INVOKE_DEFAULT", **choices, answered=True)
            return {"CANCELLED"}  # the other call finishes, and is what can be undone
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            with progress(context) as tell:
                job = RebuildJob(terrain, self._options(terrain), tell)
                job.run()
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return self.end(context, job)

    def end(self, context: bpy.types.Context, job: RebuildJob) -> OperatorStatus:
        """Show the new preview, or tell why it is the old one still."""
        if live.touch is not None:
            self.report({"ERROR"}, "Touch was started meanwhile: stop it, and rebuild again")
            return {"CANCELLED"}
        try:
            terrain = job.finish(live.opened)
        except CancelledError:
            self.report({"INFO"}, "Rebuilding cancelled: the terrain is as it was")
            return {"CANCELLED"}
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, f"{terrain.name}: {len(terrain.data.vertices):,} vertices shown")
        return {"FINISHED"}

    def _begun(self, context: bpy.types.Context) -> OperatorStatus:
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            return self.begin(context, RebuildJob(terrain, chosen_options(self)))
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    def _options(self, terrain: bpy.types.Object) -> ImportOptions:
        """As the terrain is, but for what was given."""
        given = {
            name: getattr(self, name)
            for name in ImportChoices.__annotations__
            if self.properties.is_property_set(name)
        }
        _fill_in(self, options_of(recall(terrain)))
        for name, value in given.items():
            setattr(self, name, value)
        return chosen_options(self)


class HAPTIC_TERRAIN_OT_relink(bpy.types.Operator, ImportHelper):  # type: ignore[misc]  # their invoke
    """Say where the terrain's file is now, after it was moved or renamed"""

    bl_idname = "haptic_terrain.relink"
    bl_label = "Relink Terrain"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    filter_glob: bpy.props.StringProperty(
        default=";".join(f"*{suffix}" for suffix in SUFFIXES), options={"HIDDEN"}
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only with a terrain of this file that nobody touches."""
        return _poll_changeable(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Look whether it is the same grid, and note it."""
        terrain = shown_terrain(context)
        if terrain is None:
            return {"CANCELLED"}
        try:
            relink(terrain, Path(bpy.path.abspath(self.filepath)))
        except (FormatError, KeptError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, f"{terrain.name} is read from {Path(self.filepath).name} from now on")
        return {"FINISHED"}


def _poll_changeable(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    if live.touch is not None:
        cls.poll_message_set("Touch is running: stop it first")
        return False
    if live.rendering:
        cls.poll_message_set(RENDERING)
        return False
    if not poll_terrain(cls, context):
        return False
    terrain = shown_terrain(context)
    if terrain is not None and terrain.library is not None:
        cls.poll_message_set("The terrain is linked from another file: change it there, or make it local")
        return False
    return True


def _fill_in(choices: Any, options: ImportOptions) -> None:
    """Set the properties of an operator to what a terrain has."""
    choices.vertex_budget = options.vertex_budget
    choices.scale = options.scale
    choices.exaggeration = options.exaggeration
    choices.fill_voids = options.fill_voids
    choices.placed = options.position is not None
    if options.position is not None:
        choices.latitude, choices.longitude = options.position
    choices.region = _region_by(options.region)
    if options.region is not None:
        for name, value in asdict(options.region).items():
            setattr(choices, name, value)


def _region_by(region: ChosenRegion | None) -> RegionBy:
    if region is None:
        return RegionBy.WHOLE
    return RegionBy.DEGREES if isinstance(region, LongitudeLatitudeBox) else RegionBy.SAMPLES
