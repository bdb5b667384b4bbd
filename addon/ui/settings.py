"""What a person chooses, kept in the scene."""

from __future__ import annotations

import bpy
from proxygraph import MODELS, model_descriptions

from ..record.kept_take import is_take
from ..record.take_options import BOUND_MM
from ..terrain.view import redraw
from ..touch.control import keep_control
from ..touch.live import live
from ..touch.model import keep_model
from ..touch.pre_roll import keep_pre_roll


def _switch(settings: HapticTerrainSettings, _context: bpy.types.Context) -> None:
    """Let the hand that is on the terrain feel the choice at once."""
    touched = live.touch.scene.find() if live.touch is not None else None
    if live.touch is not None and touched is not None and touched == settings.id_data:
        keep_model(live.touch, touched)
        keep_control(live.touch, touched)
        keep_pre_roll(live.touch, touched)


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
    pre_roll: bpy.props.FloatProperty(
        name="Keep Before",
        description="Seconds before Start Recording that a take begins with; 0 keeps none",
        default=0.0,
        min=0.0,
        soft_max=60.0,
        max=3600.0,
        step=100,
        precision=0,
        update=_switch,
    )
    detail: bpy.props.BoolProperty(
        name="Detail Follows",
        description="While you touch, the 3D views show the ground finely around the hand and coarsely "
        "far away; renders show the terrain's own mesh",
        default=True,
    )
    trail: bpy.props.BoolProperty(
        name="Trail",
        description="Draw trails over the terrain when a recording stops",
        default=True,
    )
    trail_kinds: bpy.props.EnumProperty(
        name="Trails",
        description="What a recording leaves on the terrain; hold Shift to choose several",
        items=[
            ("TUBE", "Tube", "A mesh that is coloured by the force"),
            ("CURVE", "Curve", "A curve that is thick where the force was strong"),
            ("POINTS", "Points", "A vertex for each tick with all its numbers, for Geometry Nodes"),
        ],
        options={"ENUM_FLAG"},
        default={"TUBE"},
    )
    take_keys: bpy.props.EnumProperty(
        name="Keys",
        description="How many keys the curves of a take have",
        items=[
            ("FRAMES", "Every Frame", "A key at each frame"),
            ("REDUCED", "Reduced", "The fewest keys that keep the point within the bound at every frame"),
        ],
    )
    take_bound: bpy.props.FloatProperty(
        name="Bound",
        description="Millimetres of the hand's motion by which reduced keys may be away from what was felt",
        default=BOUND_MM,
        min=0.001,
        max=100.0,
    )
    take_onto: bpy.props.EnumProperty(
        name="Write To",
        description="Which object gets a take",
        items=[
            ("NEW", "New Take", "Each take is an object of its own"),
            ("REPLACE", "Replace", "The chosen take becomes this one"),
            ("APPEND", "Append", "The chosen take gets these ticks, in place of what it had at their time"),
        ],
    )
    take: bpy.props.PointerProperty(
        name="Take",
        description="The take that is replaced, or appended to",
        type=bpy.types.Object,
        poll=lambda _settings, thing: is_take(thing) and thing.library is None,
    )
    take_markers: bpy.props.BoolProperty(
        name="Markers",
        description="Mark on the timeline where the hand began to pan or to zoom",
        default=True,
    )
    take_nla: bpy.props.BoolProperty(
        name="NLA Track",
        description="Push the take's action down onto an NLA track of its own",
        default=False,
    )
    keep_ticks: bpy.props.BoolProperty(
        name="Keep Ticks",
        description="Keep all ticks of a take in the .blend file, 10 MB a minute: for export and for Append",
        default=True,
    )
    play_timeline: bpy.props.BoolProperty(
        name="Play Timeline",
        description="Play the animation from the current frame on while a take is recorded",
        default=False,
    )
