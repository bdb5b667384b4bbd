"""What a person chooses, kept in the scene."""

from __future__ import annotations

import bpy
from proxygraph import MODELS, model_descriptions

from ..terrain.view import redraw
from ..touch.control import keep_control
from ..touch.live import live
from ..touch.model import keep_model


def _switch(settings: HapticTerrainSettings, _context: bpy.types.Context) -> None:
    """Let the hand that is on the terrain feel the choice at once."""
    touched = live.touch.scene.find() if live.touch is not None else None
    if live.touch is not None and touched is not None and touched == settings.id_data:
        keep_model(live.touch, touched)
        keep_control(live.touch, touched)


def _redraw(_settings: HapticTerrainSettings, context: bpy.types.Context) -> None:
    redraw(context)


class HapticTerrainSettings(bpy.types.PropertyGroup):
    """Of one scene, as ``scene.haptic_terrain``."""

    device: bpy.props.EnumProperty(
        name="Device",
        description="What the hand holds",
        items=[
            ("SIMULATED", "Simulated Hand", 'A hand that is pulled toward the Empty "Touch Target"; drag it')
        ],
    )
    window_width: bpy.props.FloatProperty(
        name="Width",
        description="Kilometres of terrain within reach, around the Touch Target; 0 is the whole map",
        default=0.0,
        min=0.0,
    )
    max_force: bpy.props.FloatProperty(
        name="Max Force",
        description="Newtons that the hand feels at most, where the device would give more",
        default=8.0,
        min=0.0,
        soft_max=20.0,
    )
    passivity_control: bpy.props.BoolProperty(
        name="Passivity Control",
        description="Add damping while a trembling device gives the hand more energy than it took",
        default=False,
        update=_switch,
    )
    contact_model: bpy.props.EnumProperty(
        name="Contact Model",
        description="How the point that is felt follows the hand over the ground; change it while you touch",
        items=[
            (name, name.replace("_", " ").title(), description)
            for name, description in model_descriptions().items()
        ],
        default=MODELS[0],
        update=_switch,
    )
    sub_step: bpy.props.EnumProperty(
        name="Sub-Steps",
        description="How far a fast hand is followed at a time: small steps are more faithful, and slower",
        items=[
            ("OFF", "Off", "All the way at once"),
            ("CELL", "1 Cell", "At most a cell of the grid at a time"),
            ("QUARTER", "1/4 Cell", "At most a quarter of a cell at a time"),
        ],
        update=_switch,
    )
    radius: bpy.props.FloatProperty(
        name="Radius",
        description="Of the sphere that is felt with, in millimetres of the hand's motion",
        default=1.0,
        min=0.01,
        max=50.0,
        update=_switch,
    )
    follow_view: bpy.props.BoolProperty(
        name="View Follows",
        description="The 3D views go along while the hand pans, zooms or turns",
        default=True,
    )
    show_overview: bpy.props.BoolProperty(
        name="Overview Map",
        description="The whole terrain, where the hand can reach and where it is; click on it to go there",
        default=True,
        update=_redraw,
    )
    show_readout: bpy.props.BoolProperty(
        name="Readout",
        description="Mode, place, force, device and a scale bar",
        default=True,
        update=_redraw,
    )
    show_legend: bpy.props.BoolProperty(
        name="Cursor Legend",
        description="What the shapes and colours of the cursor mean, and the key that leads to them",
        default=True,
        update=_redraw,
    )
    show_force: bpy.props.BoolProperty(
        name="Force Arrow",
        description="The force on the hand, as an arrow at the cursor",
        default=True,
        update=_redraw,
    )
    show_ghost: bpy.props.BoolProperty(
        name="Hand",
        description="A ring where the hand is, joined to the cursor: the farther away, the larger the force",
        default=True,
        update=_redraw,
    )
    trail: bpy.props.BoolProperty(
        name="Trail",
        description="Draw a trail over the terrain, coloured by force, when a recording stops",
        default=True,
    )
