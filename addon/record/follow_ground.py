"""Keeping an object on the terrain along its own animated path.

Where it stands in each frame is written to the curves of an Empty, and constraints bring the object there.
Nothing of the object's own animation is touched: parents, drivers and other constraints go on giving the
path, and without the two constraints it is as it was. No handler runs, so renders are as safe as any.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Literal

import bpy
import numpy as np

from ..terrain.undone import undone_on_failure
from ..touch.handle import Handle
from ..touch.own_object import mark_own
from .animated import AnimationError, found
from .bake import Bake, baked, frame_rate, opened_ground, path_of, terrain_places, usable_stand
from .curves import ensure_fcurve, write_keys
from .keys import Keys
from .resample import keys_before_jumps, ticks_at_frames
from .standing import Follow, Way, stood
from .take_data import Numbers

NAME = "Follow the Ground"
"""Of both constraints."""

MARK = "haptic_terrain_ground"
"""ID property of the Empty."""


@dataclass(frozen=True)
class Followed:
    """Where the object is to stand, with a key for each frame."""

    places: Keys
    """Scene coordinates."""
    rotations: Keys | None
    """Quaternions; ``None`` where it keeps its own."""
    beside: int
    """Frames in which there is no ground under the object, and it stays as it is."""


def followed(bake: Bake, follow: Follow) -> Generator[float, None, Followed]:
    """Find the ground under the object, telling the share that is done; the scene's frame is restored.

    Raises:
        AnimationError: the object or the terrain cannot be followed through the frames.
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    thing = found(bake.goal.thing)
    if bake.goal.bone is not None:
        raise AnimationError("A bone cannot be kept on the ground: choose an object that the rig follows.")
    if thing.library is not None:
        raise AnimationError(f"{thing.name} is linked from another file: make a library override of it.")
    with _muted(bake.goal.thing):
        way = yield from (_proxy_way(bake) if follow.path == "PROXY" else _own_way(bake))
    standing = stood(way, follow)
    rotations = None if standing.rotations is None else _keys(bake, way, standing.rotations)
    return Followed(_keys(bake, way, standing.places), rotations, standing.beside)


def write_followed(bake: Bake, result: Followed) -> bpy.types.Object:
    """Write the curves of the Empty, and tie the object to it; what was there before is replaced."""
    thing, scene = found(bake.goal.thing), found(bake.scene)
    with undone_on_failure():
        empty = bpy.data.objects.new(f"Ground of {thing.name}", None)
        mark_own(empty, MARK)
        empty.empty_display_type = "ARROWS"
        empty.empty_display_size = 0.5 * max(thing.dimensions[:]) or 0.1
        empty.rotation_mode = "QUATERNION"
        scene.collection.objects.link(empty)
        action = bpy.data.actions.new(empty.name)
        empty.animation_data_create().action = action
        curves = {"location": result.places}
        if result.rotations is not None:
            curves["rotation_quaternion"] = result.rotations
        for path, keys in curves.items():
            for axis in range(keys.values.shape[1]):
                write_keys(ensure_fcurve(action, empty, path, axis), keys, axis)
    release(thing)
    _tie(thing, "COPY_LOCATION", empty)
    if result.rotations is not None:
        _tie(thing, "COPY_ROTATION", empty)
    return empty


def is_following(thing: bpy.types.Object) -> bool:
    """Whether an object is held on the ground."""
    return bool(_ties(thing))


def release(thing: bpy.types.Object) -> bool:
    """Let an object go from the ground; gives whether it was held there."""
    tied = _ties(thing)
    empties = {tie.target for tie in tied if tie.target is not None and tie.target.get(MARK) is not None}
    actions = {empty.animation_data.action for empty in empties if empty.animation_data is not None}
    for tie in tied:
        thing.constraints.remove(tie)
    bpy.data.batch_remove([*empties, *(action for action in actions if action is not None)])
    return bool(tied)


def _tie(
    thing: bpy.types.Object, kind: Literal["COPY_LOCATION", "COPY_ROTATION"], empty: bpy.types.Object
) -> None:
    constraint: Any = thing.constraints.new(kind)
    constraint.name = NAME
    constraint.target = empty


def _ties(thing: bpy.types.Object) -> list[Any]:
    return [tie for tie in thing.constraints if tie.name.startswith(NAME)]


@contextmanager
def _muted(thing: Handle[bpy.types.Object]) -> Iterator[None]:
    """Let an object that follows the ground already go its own way."""
    muted = {tie.name for tie in _ties(found(thing)) if not tie.mute}
    for tie in _ties(found(thing)):
        tie.mute = True
    try:
        yield
    finally:  # the object may have been deleted meanwhile, and its constraints with it
        left = thing.find()
        for tie in _ties(left) if left is not None else ():
            tie.mute = tie.mute and tie.name not in muted


def _own_way(bake: Bake) -> Generator[float, None, Way]:
    kept, ground = opened_ground(bake)
    path = yield from path_of(bake)
    stand = usable_stand(bake.terrain, kept.frame, path)
    return Way(stand, ground, path.moving, terrain_places(stand, path))


def _proxy_way(bake: Bake) -> Generator[float, None, Way]:
    result = yield from baked(bake)
    ticks = ticks_at_frames(result.data.columns["time"], frame_rate(found(bake.scene)))
    moving = result.path.moving[:: bake.frames.per_frame]
    return Way(result.stand, result.ground, moving, result.data.places[ticks])


def _keys(bake: Bake, way: Way, values: Numbers) -> Keys:
    """A key in each frame, held where the next one lies beyond the seam of a map that wraps."""
    turn = way.stand.frame.turn
    turns = np.zeros(len(values)) if turn is None else np.floor(way.places[:, 0] / turn)
    held = keys_before_jumps(turns, np.zeros(len(values)))
    return Keys(bake.frames.first + np.arange(len(values)), values.astype(np.float32), held)
