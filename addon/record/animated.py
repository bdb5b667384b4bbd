"""Where an animated object, or the end of a bone, is: as Blender evaluates it, frame by frame."""

from __future__ import annotations

import math
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal

import bpy

from ..terrain.frame import Point
from ..touch.handle import Handle, Thing
from .affine import Affine

Tip = Literal["HEAD", "TAIL"]


class AnimationError(ValueError):
    """An object cannot be followed through its animation; the text says why, and what to do."""


@dataclass(frozen=True)
class Animated:
    """An object whose origin moves, or a bone of a rig, one of whose ends does."""

    thing: Handle[bpy.types.Object]
    bone: str | None = None
    tip: Tip = "HEAD"

    @property
    def name(self) -> str:
        """As a person knows it."""
        return self.thing.name if self.bone is None else f"{self.thing.name}, bone {self.bone}"


@dataclass(frozen=True)
class Frames:
    """Frames of a scene, and how many samples each has."""

    first: int
    last: int
    per_frame: int = 1

    @property
    def samples(self) -> int:
        """From the first frame to the last, both among them."""
        return (self.last - self.first) * self.per_frame + 1

    def frame(self, sample: int) -> tuple[int, float]:
        """Frame of a sample, and share of the way to the next one."""
        whole, part = divmod(sample, self.per_frame)
        return self.first + whole, part / self.per_frame


@dataclass(frozen=True)
class Sample:
    """Something at a moment, in scene coordinates."""

    place: Point
    matrix: Affine
    """Of the object."""


@dataclass(frozen=True)
class Path:
    """What was found at every sample."""

    terrain: Affine
    """Where the terrain stands, all the time."""
    moving: list[Sample]


def check_frames(scene: bpy.types.Scene, frames: Frames) -> None:
    """Refuse frames that are no path in time.

    Raises:
        AnimationError: naming what was found, and what was expected.
    """
    if frames.last < frames.first:
        raise AnimationError(
            f"The frames run backwards, from {frames.first} to {frames.last}: give a later last frame."
        )
    if frames.last == frames.first:
        raise AnimationError(f"Frame {frames.first} alone is no path: give at least two frames.")
    render = scene.render
    if render.frame_map_old != render.frame_map_new:
        raise AnimationError(
            f"{scene.name} stretches time ({render.frame_map_old} to {render.frame_map_new}): keys that are "
            "written would not play when they were felt. Set Time Stretching to 100 and 100."
        )


def samples(
    scene: Handle[bpy.types.Scene],
    view_layer: str,
    moving: Animated,
    still: Handle[bpy.types.Object],
    frames: Frames,
) -> Generator[float, None, Path]:
    """Evaluate the scene at every sample, telling the share that is done; its frame is restored at the end.

    Whatever makes the object move is honoured, for Blender is asked where it ends: curves, parents, drivers,
    constraints.

    Args:
        moving: what is followed.
        still: the terrain, which must not move meanwhile.

    Raises:
        AnimationError: something is gone, not evaluated, not a number, or the terrain moves.
    """
    moved = []
    with _frame_restored(scene):
        stands: Affine | None = None
        for number in range(frames.samples):
            frame, part = frames.frame(number)
            graph = _evaluated(scene, view_layer, frame, part)
            ground = Affine.of(_in_graph(still, graph).matrix_world)
            stands = stands or ground
            if ground != stands:
                raise AnimationError(
                    f"The terrain {still.name} moves at frame {frame + part:g}: what is felt there would lie "
                    "beside it at any other time. Let it stand, and move the object instead."
                )
            moved.append(_sample(moving, graph, frame + part))
            yield (number + 1) / frames.samples
    if stands is None:
        raise AnimationError("There is no frame to look at.")
    return Path(stands, moved)


def found(handle: Handle[Thing]) -> Thing:
    """Give what a handle stands for.

    Raises:
        AnimationError: it is gone.
    """
    thing = handle.find()
    if thing is None:
        raise AnimationError(f"{handle.name} is gone: it was deleted meanwhile.")
    return thing


@contextmanager
def _frame_restored(scene: Handle[bpy.types.Scene]) -> Iterator[None]:
    """Go back to the frame that was shown, whatever happens."""
    shown = found(scene)
    frame, part = shown.frame_current, shown.frame_subframe
    try:
        yield
    finally:
        left = scene.find()
        if left is not None:
            left.frame_set(frame, subframe=part)


def _evaluated(
    scene: Handle[bpy.types.Scene], view_layer: str, frame: int, part: float
) -> bpy.types.Depsgraph:
    now = found(scene)
    now.frame_set(frame, subframe=part)
    layer = now.view_layers.get(view_layer)
    if layer is None:
        raise AnimationError(f"The view layer {view_layer} of {scene.name} is gone.")
    return layer.depsgraph


def _in_graph(thing: Handle[bpy.types.Object], graph: bpy.types.Depsgraph) -> bpy.types.Object:
    evaluated: bpy.types.Object = found(thing).evaluated_get(graph)
    if not evaluated.is_evaluated:
        raise AnimationError(
            f"Blender does not evaluate {thing.name}: it is disabled in viewports, or its collection is "
            "excluded from the view layer. Show it (hiding it with the eye does no harm)."
        )
    return evaluated


def _sample(moving: Animated, graph: bpy.types.Depsgraph, frame: float) -> Sample:
    thing = _in_graph(moving.thing, graph)
    matrix = Affine.of(thing.matrix_world)
    place = matrix.shift
    if moving.bone is not None:
        bone = thing.pose.bones.get(moving.bone) if thing.pose is not None else None
        if bone is None:
            raise AnimationError(f"{thing.name} has no bone {moving.bone}.")
        place = matrix.point(bone.head if moving.tip == "HEAD" else bone.tail)
    if not (matrix.is_finite and all(map(math.isfinite, place))):
        raise AnimationError(
            f"The place of {moving.name} at frame {frame:g} is not a number: look at its drivers."
        )
    return Sample(place, matrix)
