"""A take: its own object with its own action, moving as the proxy did."""

from __future__ import annotations

import bpy

from ..touch.cursor import SIZE, TAKE, shape_mesh
from ..touch.live import Recording
from ..touch.placement import Placement
from .curves import ensure_fcurve, write_keys
from .resample import keys_before_jumps, ticks_at_frames

NAME = "Touch Take"

MODE = "haptic_terrain_mode"
"""ID property of a take, keyed where the hand panned or zoomed: 0 normal, 1 pan, 2 zoom."""

MODELS = "haptic_terrain_models"
"""ID property of a take: the contact models that answered, in their order."""


def add_take(
    scene: bpy.types.Scene, recording: Recording, placement: Placement
) -> tuple[bpy.types.Object, int]:
    """Make the object, at the scene's present frame rate.

    Returns:
        The object, and the number of keyframes on each of its curves.
    """
    columns = recording.recorder.columns
    felt = ticks_at_frames(columns["time"], scene.render.fps / scene.render.fps_base)
    east = [columns["proxy_east"][tick] for tick in felt]
    places = [
        placement.to_scene(
            columns["proxy_east"][tick], columns["proxy_north"][tick], columns["proxy_up"][tick]
        )
        for tick in felt
    ]
    held = keys_before_jumps([placement.frame.turns(metres) for metres in east])
    frames = [float(recording.start_frame + number) for number in range(len(felt))]

    take = _object(scene, recording, placement)
    # So that the take plays to its end; a longer range that was chosen stays.
    scene.frame_end = max(scene.frame_end, recording.start_frame + len(felt) - 1)
    action = bpy.data.actions.new(take.name)
    take.animation_data_create().action = action
    for axis in range(3):
        curve = ensure_fcurve(action, take, "location", axis)
        write_keys(curve, frames, [place[axis] for place in places], held)
    modes = [columns["mode"][tick] for tick in felt]
    if any(modes):
        curve = ensure_fcurve(action, take, f'["{MODE}"]', 0)
        write_keys(curve, frames, modes, [True] * len(modes))
    return take, len(felt)


def _object(scene: bpy.types.Scene, recording: Recording, placement: Placement) -> bpy.types.Object:
    """Make a cone like the cursor in contact, in a colour of its own; its tip is the point that moved."""
    take = bpy.data.objects.new(NAME, shape_mesh(TAKE))
    size = SIZE * placement.longest_side(recording.touch.grid.layout)
    take.scale = (size, size, size)
    take.rotation_euler = placement.rotation.to_euler()
    take[MODE] = 0
    take[MODELS] = ", ".join(recording.models)
    scene.collection.objects.link(take)
    return take
