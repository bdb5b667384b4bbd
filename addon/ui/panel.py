"""The tab in the sidebar of the 3D view."""

from __future__ import annotations

import math

import bpy

from ..terrain.kept import KeptError, recall
from ..touch.live import Readout, Recording, live
from ..touch.model import SPHERE, WALK
from ..touch.place_words import place_lines
from ..touch.placement import Placement
from ..touch.state_words import HELD, MODES
from .chosen import shown_terrain
from .download_operator import HAPTIC_TERRAIN_OT_download_mola
from .import_operator import TITLE, HAPTIC_TERRAIN_OT_import_grid
from .mouse_touch import HAPTIC_TERRAIN_OT_mouse_touch
from .presets import draw_touch_presets
from .record_operators import (
    HAPTIC_TERRAIN_OT_record_start,
    HAPTIC_TERRAIN_OT_record_stop,
    HAPTIC_TERRAIN_OT_recover_take,
)
from .sidebar import TAB, draw_lines, draw_message, draw_text
from .stylus_buttons import draw_stylus
from .terrain_operators import HAPTIC_TERRAIN_OT_relink
from .terrain_words import missing
from .touch_operators import HAPTIC_TERRAIN_OT_touch_start, HAPTIC_TERRAIN_OT_touch_stop


class HAPTIC_TERRAIN_PT_terrain(bpy.types.Panel):
    """The grid that is touched."""

    bl_label = "Terrain"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB

    def draw(self, context: bpy.types.Context) -> None:
        """Name the grid, what is shown of it, and how."""
        terrain = shown_terrain(context)
        if terrain is None:
            self.layout.operator(HAPTIC_TERRAIN_OT_import_grid.bl_idname, text=TITLE, icon="IMPORT")
            self.layout.operator(HAPTIC_TERRAIN_OT_download_mola.bl_idname, icon="WORLD")
            return
        try:
            kept = recall(terrain)
        except KeptError as error:
            draw_message(self.layout, str(error))
            return
        exaggeration = Placement.of(terrain, kept.frame).exaggeration
        column = self.layout.column(align=True)
        column.label(text=kept.grid.title, icon="WORLD")
        column.label(text=f"{kept.grid.layout.columns:,} x {kept.grid.layout.rows:,} samples")
        column.label(text=f"{len(terrain.data.vertices):,} vertices shown")
        column.label(text=f"{kept.minimum:,.0f} to {kept.maximum:,.0f} m, heights x{exaggeration:g}")
        if not kept.grid.data_path.is_file():
            draw_message(self.layout, missing(kept))
            self.layout.operator(HAPTIC_TERRAIN_OT_relink.bl_idname, icon="FILEBROWSER")
        self.layout.operator(HAPTIC_TERRAIN_OT_import_grid.bl_idname, icon="IMPORT", text="Import Another")


class HAPTIC_TERRAIN_PT_touch(bpy.types.Panel):
    """Touch, and what is felt."""

    bl_label = "Touch"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB

    def draw(self, context: bpy.types.Context) -> None:
        """Start, stop, and the newest tick."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        if live.message:
            draw_message(layout, live.message)
        if live.touch is None:
            draw_touch_presets(layout)
            layout.prop(context.scene.haptic_terrain, "device")
            layout.prop(context.scene.haptic_terrain, "window_width", text="Width in km")
            layout.prop(context.scene.haptic_terrain, "max_force", text="Max Force in N")
            layout.prop(context.scene.haptic_terrain, "passivity_control")
            _draw_model(layout, context.scene)
            layout.operator(HAPTIC_TERRAIN_OT_touch_start.bl_idname, icon="PLAY")
            layout.operator(HAPTIC_TERRAIN_OT_mouse_touch.bl_idname, icon="MOUSE_MOVE")
            return
        layout.operator(HAPTIC_TERRAIN_OT_touch_stop.bl_idname, icon="SNAP_FACE")
        if live.touch.is_simulated:
            layout.operator(HAPTIC_TERRAIN_OT_mouse_touch.bl_idname, icon="MOUSE_MOVE")
        for shortcoming in live.touch.shortcomings:
            draw_message(layout, shortcoming)
        draw_stylus(layout, live.touch)
        _draw_model(layout, live.touch.scene.find())
        if live.touch.detail is not None and live.touch.detail.words is not None:
            draw_lines(layout, [("Shown", live.touch.detail.words)])
        if live.touch.target is not None and live.touch.target.find() is None:
            draw_message(layout, "The Touch Target is gone: stop touch and start it again.")
        if live.touch.readout is not None:
            exaggeration = live.touch.readout.window.exaggeration
            in_degrees = live.touch.georeference.projection.in_degrees
            draw_lines(layout, readout_lines(live.touch.readout, exaggeration, in_degrees=in_degrees))


class HAPTIC_TERRAIN_PT_safety(bpy.types.Panel):
    """What the safety chain did."""

    bl_label = "Safety"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_parent_id = "HAPTIC_TERRAIN_PT_touch"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only while touch runs."""
        return live.touch is not None and live.touch.readout is not None

    def draw(self, context: bpy.types.Context) -> None:
        """A sentence for each thing that took the force away, or kept it small."""
        if live.touch is None or live.touch.readout is None or self.layout is None:
            return
        scene = live.touch.scene.find()
        if scene is not None:
            self.layout.prop(scene.haptic_terrain, "passivity_control")
        for warning in live.touch.readout.warnings or ("Nothing held the force back so far.",):
            draw_text(self.layout, warning)


class HAPTIC_TERRAIN_PT_record(bpy.types.Panel):
    """Takes."""

    bl_label = "Record"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB

    def draw(self, context: bpy.types.Context) -> None:
        """Start and stop a take."""
        layout = self.layout
        settings = context.scene.haptic_terrain
        layout.prop(settings, "trail")
        if live.recording is None:
            layout.prop(settings, "pre_roll", text="Keep Before in s")
            layout.operator(HAPTIC_TERRAIN_OT_record_start.bl_idname, icon="REC")
            layout.operator(HAPTIC_TERRAIN_OT_recover_take.bl_idname, icon="FILE_REFRESH")
            return
        layout.label(text=f"{live.recording.recorder.seconds:.1f} s")
        trouble = spool_trouble(live.recording)
        if trouble:
            draw_message(layout, trouble)
        stop = layout.operator(HAPTIC_TERRAIN_OT_record_stop.bl_idname, icon="SNAP_FACE")
        stop.trail = settings.trail


def spool_trouble(recording: Recording) -> str:
    """Say why a take is in memory only; empty where it is not."""
    reason = recording.not_spooled or recording.recorder.spool_failure
    return f"The take is in memory only, and a crash would lose it: {reason}" if reason else ""


def readout_lines(readout: Readout, exaggeration: float, *, in_degrees: bool) -> list[tuple[str, str]]:
    """Put the newest tick into words."""
    lines = [
        ("Mode", MODES[readout.mode]),
        ("Contact", "Touching" if readout.in_contact else "Free"),
        ("Force", f"{readout.force:.2f} N"),
        ("Reach", reach(readout)),
        ("Missed ticks", f"{readout.missed_ticks:,} of {readout.ticks + readout.missed_ticks:,}"),
    ]
    if readout.held is not None:
        lines.insert(3, ("Held back", HELD[readout.held]))
    lines += servo_lines(readout)
    beside = [("Place", "Beside the map")]
    lines[2:2] = place_lines(readout, exaggeration, in_degrees=in_degrees) if readout.on_map else beside
    return lines


def reach(readout: Readout) -> str:
    """How much terrain lies under the hand's whole reach, and how it is turned."""
    window = readout.window
    metres = window.width
    width = f"{metres:,.0f} m" if metres < 1e4 else f"{metres / 1000.0:,.0f} km"
    degrees = round(math.degrees(window.turn)) % 360
    return f"{width}, turned {degrees}\N{DEGREE SIGN}" if degrees else width


def servo_lines(readout: Readout) -> list[tuple[str, str]]:
    """Put into words how the servo keeps its time."""
    priority, _colon, reason = readout.priority.partition(": ")
    lines = [
        ("Servo load", f"{readout.load:.1%} of each ms ({readout.worst_load:.1%})"),
        ("Lateness", f"{readout.late_us:,.0f} us (99%)"),
        ("Active ticks", f"{readout.active_ticks:,}"),
        ("Priority", priority.title()),
    ]
    return [*lines, ("", reason)] if reason else lines


def _draw_model(layout: bpy.types.UILayout | None, scene: bpy.types.Scene | None) -> None:
    """Offer the contact models, and the knob of the chosen one."""
    if layout is None or scene is None:
        return
    settings = scene.haptic_terrain
    layout.prop(settings, "contact_model")
    if settings.contact_model == WALK:
        layout.prop(settings, "sub_step")
    elif settings.contact_model == SPHERE:
        layout.prop(settings, "radius", text="Radius in mm")
