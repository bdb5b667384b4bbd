"""Keeping an object on the terrain along its own animated path.

Where it stands in each frame is written to the curves of an Empty, and constraints bring the object there.
Nothing of the object's own animation is touched: parents, drivers and other constraints go on giving the
path, and without the two constraints it is as it was. No handler runs, so renders are as safe as any.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Literal

import bpy
import numpy as np
from mathutils import Matrix, Vector

from ..terrain.undone import undone_on_failure
from ..touch.own_object import mark_own
from .animated import AnimationError, Sample, found
from .bake import Bake, baked, frame_rate, opened_ground, path_of, terrain_places, usable_stand
from .curves import ensure_fcurve, write_keys
from .footing import AROUND, MIDDLE, headings, level, plane, resting, turned, unit
from .ground import Ground
from .keys import Keys
from .resample import keys_before_jumps, ticks_at_frames
from .stand import Stand
from .take_data import Numbers

NAME = "Follow the Ground"
"""Of both constraints."""

MARK = "haptic_terrain_ground"
"""ID property of the Empty."""


@dataclass(frozen=True)
class Follow:
    """How an object follows the ground."""

    path: Literal["OWN", "PROXY"] = "OWN"
    """Over what: its own place, or the proxy that contact makes of it."""
    ground: Literal["HIGHEST", "REAL", "SHOWN"] = "HIGHEST"
    """Every sample of the grid, the coarser ground that is shown, or the higher of the two."""
    offset: float = 0.0
    """Blender units that the origin is above the ground."""
    oriented: bool = True
    """Whether it is tilted as the ground is."""
    heading: Literal["OWN", "PATH"] = "OWN"
    """Where its Y axis looks: where it looks by itself, or along the path."""
    width: float = 0.0
    length: float = 0.0
    """Of what touches the ground, along its X and Y axes, Blender units; 0 is a point."""


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
    with _muted(thing):
        way = yield from (_proxy_way(bake) if follow.path == "PROXY" else _own_way(bake))
    return _standing(way, follow)


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
def _muted(thing: bpy.types.Object) -> Iterator[None]:
    """Let an object that follows the ground already go its own way."""
    muted = [tie for tie in _ties(thing) if not tie.mute]
    for tie in muted:
        tie.mute = True
    try:
        yield
    finally:
        for tie in muted:
            tie.mute = False


@dataclass(frozen=True)
class _Way:
    """What an object does by itself: a row for each frame."""

    bake: Bake
    stand: Stand
    ground: Ground
    moving: list[Sample]
    places: Numbers
    """Terrain metres of what is to be over the ground, n x 3."""


def _own_way(bake: Bake) -> Generator[float, None, _Way]:
    kept, ground = opened_ground(bake)
    path = yield from path_of(bake)
    stand = usable_stand(bake.terrain, kept.frame, path)
    return _Way(bake, stand, ground, path.moving, terrain_places(stand, path))


def _proxy_way(bake: Bake) -> Generator[float, None, _Way]:
    result = yield from baked(bake)
    ticks = ticks_at_frames(result.data.columns["time"], frame_rate(found(bake.scene)))
    moving = result.path.moving[:: bake.frames.per_frame]
    return _Way(bake, result.stand, result.ground, moving, result.data.places[ticks])


def _standing(way: _Way, follow: Follow) -> Followed:
    """Put the object on the ground in each frame; where there is none, it stays where it is by itself."""
    stand, places = way.stand, way.places
    at = np.array([stand.to_scene(*place) for place in places.tolist()])
    above = places + np.array((0.0, 0.0, way.ground.grid.layout.cell_width))
    up = unit(np.array([stand.to_scene(*place) for place in above.tolist()]) - at)
    own = np.array([sample.matrix.column(1) for sample in way.moving])
    forward = unit(level(own, up))
    if follow.heading == "PATH":
        forward = headings(at, up, forward)

    patch = _patch(way, at, forward, up, follow)
    is_there = np.isfinite(patch).all(axis=(1, 2))
    normal = plane(patch, up) if follow.oriented else up.copy()
    normal[~is_there] = up[~is_there]
    standing = patch[:, MIDDLE] if not follow.width and not follow.length else resting(patch, normal, up)
    standing = standing + normal * follow.offset
    standing[~is_there] = np.array([sample.place for sample in way.moving])[~is_there]
    rotations = _rotations(way, forward, up, normal, follow)
    return Followed(
        _keys(way, standing),
        None if rotations is None else _keys(way, rotations),
        int((~is_there).sum()),
    )


def _keys(way: _Way, values: Numbers) -> Keys:
    """A key in each frame, held where the next one lies beyond the seam of a map that wraps."""
    frames = way.bake.frames.first + np.arange(len(values))
    turn = way.stand.frame.turn
    turns = np.zeros(len(values)) if turn is None else np.floor(way.places[:, 0] / turn)
    return Keys(frames, values.astype(np.float32), keys_before_jumps(turns, np.zeros(len(values))))


def _patch(way: _Way, at: Numbers, forward: Numbers, up: Numbers, follow: Follow) -> Numbers:
    """Scene coordinates of the ground around the object, n x 9 x 3; NaN where there is none in the middle.

    Something without a footprint is tilted as the cell around it is.
    """
    stand, layout = way.stand, way.ground.grid.layout
    cell = layout.cell_width * stand.frame.units_per_metre * stand.across
    right = np.cross(forward, up)
    side, ahead = (AROUND * (follow.width or cell, follow.length or cell) / 2.0).T
    around = at[:, None] + side[:, None] * right[:, None] + ahead[:, None] * forward[:, None]
    flat = np.array([stand.to_terrain(place) for place in around.reshape(-1, 3).tolist()])
    east, north = stand.frame.on_map(flat[:, 0]), flat[:, 1]
    heights = _heights(way.ground, follow)(east, north).reshape(-1, len(AROUND))
    heights = np.where(
        np.isnan(heights), heights[:, MIDDLE:][:, :1], heights
    )  # beside a rim, as in the middle
    places = np.column_stack((east, north, heights.ravel())).tolist()
    return np.array([stand.to_scene(*place) for place in places]).reshape(around.shape)


def _heights(ground: Ground, follow: Follow) -> Callable[[Numbers, Numbers], Numbers]:
    if follow.ground == "REAL":
        return ground.real
    return ground.surface.heights_at if follow.ground == "SHOWN" else ground.highest


def _rotations(way: _Way, forward: Numbers, up: Numbers, normal: Numbers, follow: Follow) -> Numbers | None:
    """Quaternions, n x 4, without jumps of sign."""
    if follow.heading == "PATH":
        turns = [Matrix(turn).to_quaternion() for turn in turned(forward, normal).tolist()]
    elif follow.oriented:
        turns = [
            Vector(before).rotation_difference(Vector(after)) @ Matrix(sample.matrix.linear).to_quaternion()
            for before, after, sample in zip(up.tolist(), normal.tolist(), way.moving, strict=True)
        ]
    else:
        return None
    for before, turn in pairwise(turns):
        turn.make_compatible(before)
    return np.array([turn[:] for turn in turns])
