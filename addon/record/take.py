"""A take: its own object with its own action, moving as the proxy did."""

from __future__ import annotations

import bpy

from ..touch.cursor import SIZE, TAKE_COLOURS, Shape, shape_mesh, take_shape
from ..touch.placement import Placement
from .curves import ensure_fcurve, has_fcurve, write_keys
from .kept_take import is_take, take_action
from .keys import Keys, TakeKeys
from .nla import off_tracks

NAME = "Touch Take"

COLLECTION = "haptic_terrain_take"
"""ID property of a collection: it holds a take and its trails, and nothing else was put there."""

MODE = "haptic_terrain_mode"
"""ID property of a take, keyed where the hand panned or zoomed: 0 normal, 1 pan, 2 zoom."""

FORCE = "haptic_terrain_force"
"""ID property of a take, keyed: newtons."""

DEPTH = "haptic_terrain_depth"
"""ID property of a take, keyed: from the proxy to the goal, metres of the hand's motion; 0 in free space."""

MODELS = "haptic_terrain_models"
"""ID property of a take: the contact models that answered, in their order."""


def new_take(scene: bpy.types.Scene, placement: Placement, longest_side: float) -> bpy.types.Object:
    """Make the object in a collection of its own: a cone whose tip is the point that moved.

    Args:
        longest_side: of the map, Blender units in the scene.
    """
    take = bpy.data.objects.new(NAME, shape_mesh(_rarest_shape(scene)))
    size = SIZE * longest_side
    take.scale = (size, size, size)
    take.rotation_euler = placement.rotation.to_euler()
    collection = bpy.data.collections.new(take.name)
    collection[COLLECTION] = True
    scene.collection.children.link(collection)
    collection.objects.link(take)
    take.animation_data_create().action = bpy.data.actions.new(take.name)
    return take


def _rarest_shape(scene: bpy.types.Scene) -> Shape:
    """Choose the colour that the fewest takes of a scene have."""
    names = [thing.data.name for thing in scene.objects if is_take(thing) and thing.data is not None]
    return min(map(take_shape, range(len(TAKE_COLOURS))), key=lambda shape: names.count(shape.name))


def home(take: bpy.types.Object, scene: bpy.types.Scene) -> bpy.types.Collection:
    """Where a take's trails belong: its own collection, else the scene's."""
    own = (collection for collection in take.users_collection if collection.get(COLLECTION))
    return next(own, scene.collection)


def key_take(take: bpy.types.Object, keys: TakeKeys, models: tuple[str, ...]) -> bpy.types.Action:
    """Write the curves, in place of those that the take had; its action is in use then, on no NLA track."""
    action = take_action(take) or take.animation_data.action
    assert action is not None  # a new take has one, and what has none is no take
    off_tracks(take, action)
    take.animation_data.action = action
    for axis in range(3):
        write_keys(ensure_fcurve(action, take, "location", axis), keys.location, axis)
    for name, of_it in ((FORCE, keys.force), (DEPTH, keys.depth)):
        take[name] = 0.0
        write_keys(ensure_fcurve(action, take, f'["{name}"]', 0), of_it)
    take[MODELS] = ", ".join(models)
    _key_mode(take, action, keys.mode)
    action.use_frame_range = True
    action.frame_start, action.frame_end = float(keys.location.frames[0]), float(keys.last_frame)
    return action


def _key_mode(take: bpy.types.Object, action: bpy.types.Action, mode: Keys) -> None:
    """A curve only where there were modes, now or before."""
    take[MODE] = 0
    path = f'["{MODE}"]'
    if mode.values.any() or has_fcurve(action, path):
        write_keys(ensure_fcurve(action, take, path, 0), mode)
