"""What a person chooses, kept in the scene."""

from __future__ import annotations

import bpy


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
    trail: bpy.props.BoolProperty(
        name="Trail",
        description="Draw a trail over the terrain, coloured by force, when a recording stops",
        default=True,
    )
