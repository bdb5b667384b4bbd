"""What bakes and followed ground ask for: which object, over which terrain, in which frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from ..record.animated import Animated, AnimationError, Frames
from ..terrain.kept import is_terrain
from ..touch.error import TouchError
from ..touch.handle import Handle
from ..touch.live import RENDERING, live
from ..touch.start import chosen_terrain

if TYPE_CHECKING:
    from ..record.animated import Tip


class GoalChoices:
    """Properties of an operator; what is left empty is taken from what is selected, and from the scene."""

    goal: bpy.props.StringProperty(
        name="Object",
        description="That moves; empty is the active object",
        options={"SKIP_SAVE"},
    )
    terrain: bpy.props.StringProperty(
        name="Terrain",
        description="Empty is the selected one, or the only one",
        options={"SKIP_SAVE"},
    )
    frame_start: bpy.props.IntProperty(
        name="First Frame", description="0 and 0 are the frames of the scene", options={"SKIP_SAVE"}
    )
    frame_end: bpy.props.IntProperty(
        name="Last Frame", description="0 and 0 are the frames of the scene", options={"SKIP_SAVE"}
    )


def poll_goal(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    """Whether there is a terrain, and nothing in the way."""
    if live.rendering:
        cls.poll_message_set(RENDERING)
        return False
    if context.scene is None or not any(map(is_terrain, context.scene.objects)):
        cls.poll_message_set("Import a terrain first")
        return False
    return True


def chosen_goal(context: bpy.types.Context, name: str, bone: str = "", tip: Tip = "HEAD") -> Animated:
    """Find what moves; in pose mode the active bone.

    Raises:
        AnimationError: there is no such object or bone, or nothing is active.
    """
    goal = _named(context, name) if name else context.view_layer.objects.active
    if goal is None:
        raise AnimationError("Make the object active that is to move over the terrain, or name it.")
    if not bone and not name and context.mode == "POSE" and context.active_pose_bone is not None:
        bone = context.active_pose_bone.name
    if bone and (goal.pose is None or bone not in goal.pose.bones):
        raise AnimationError(f"{goal.name} has no bone {bone}.")
    return Animated(Handle.to(goal), bone or None, tip)


def terrain_under(context: bpy.types.Context, name: str) -> bpy.types.Object:
    """Find the terrain: the one that is named, else the one that is selected, else the only one.

    Raises:
        AnimationError: it is not to be found, or is no terrain.
    """
    if name:
        named = _named(context, name)
        if not is_terrain(named):
            raise AnimationError(f"{name} is no terrain: name one that was imported from a grid.")
        return named
    selected = [thing for thing in context.selected_objects if is_terrain(thing)]
    if len(selected) == 1:
        return selected[0]
    try:
        return chosen_terrain(context)
    except TouchError as error:
        raise AnimationError(str(error)) from error


def chosen_frames(context: bpy.types.Context, first: int, last: int, per_frame: int = 1) -> Frames:
    """The frames that were given, else those of the scene."""
    if first == last == 0 and context.scene is not None:
        first, last = context.scene.frame_start, context.scene.frame_end
    return Frames(first, last, per_frame)


def _named(context: bpy.types.Context, name: str) -> bpy.types.Object:
    found: bpy.types.Object | None = context.scene.objects.get(name)
    if found is None:
        raise AnimationError(f"{context.scene.name} has no object {name}.")
    return found
