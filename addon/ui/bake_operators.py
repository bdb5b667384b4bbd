"""Bake Touch and Follow the Ground: what is animated meets the terrain."""

from __future__ import annotations

from collections.abc import Generator

import bpy

from ..record.animated import Animated, AnimationError
from ..record.bake import SAMPLES_PER_FRAME, Baked, bake_of, baked, write_baked
from ..record.follow_ground import Followed, followed, release, write_followed
from ..record.standing import Follow
from ..terrain.progress import Tell
from ..touch.live import RENDERING, live
from .goal_choices import GoalChoices, chosen_frames, chosen_goal, poll_goal, terrain_under
from .in_turns import InTurns
from .operator_status import OperatorStatus
from .take_report import report_take


class HAPTIC_TERRAIN_OT_bake(InTurns, bpy.types.Operator, GoalChoices):
    """Let an animated object, or the end of a bone, feel the terrain, and write a take of it"""

    bl_idname = "haptic_terrain.bake"
    bl_label = "Bake Touch"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    bone: bpy.props.StringProperty(
        name="Bone",
        description="Of a rig; empty is the object's origin (in pose mode the active bone)",
        options={"SKIP_SAVE"},
    )
    tip: bpy.props.EnumProperty(
        name="End of Bone",
        items=[
            ("HEAD", "Head", "The end where the bone begins"),
            ("TAIL", "Tail", "The end where its children begin"),
        ],
        default="TAIL",
    )
    samples: bpy.props.IntProperty(
        name="Samples per Frame",
        description="How often the scene is evaluated for each frame; contact is always computed at 1 kHz",
        default=SAMPLES_PER_FRAME,
        min=1,
        max=100,
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only over a terrain."""
        return poll_goal(cls, context)

    def work(self, context: bpy.types.Context) -> Generator[float, None, Baked]:
        """Compute the contact."""
        self._bake = bake_of(
            context,
            chosen_goal(context, self.goal, self.bone, self.tip),
            terrain_under(context, self.terrain),
            chosen_frames(context, self.frame_start, self.frame_end, self.samples),
        )
        return baked(self._bake)

    def write(self, result: Baked, tell: Tell) -> None:
        """Write the take, and tell what came of it."""
        report_take(self, write_baked(self._bake, result, tell))
        for note in result.notes:
            self.report({"WARNING"}, note)


class HAPTIC_TERRAIN_OT_follow_ground(InTurns, bpy.types.Operator, GoalChoices):
    """Keep an object on the terrain along its own animated path; once more, after the path was changed"""

    bl_idname = "haptic_terrain.follow_ground"
    bl_label = "Follow the Ground"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    path: bpy.props.EnumProperty(
        name="Over",
        items=[
            ("OWN", "Own Place", "The ground straight under the object"),
            ("PROXY", "Contact", "Where contact holds the object back, as Bake Touch has it"),
        ],
    )
    ground: bpy.props.EnumProperty(
        name="Ground",
        items=[
            ("HIGHEST", "Higher of Both", "Never buried: neither in what is shown nor in the whole grid"),
            ("REAL", "Every Sample", "The whole grid, of which fewer samples are shown"),
            ("SHOWN", "As Shown", "The coarser ground that is seen"),
        ],
    )
    offset: bpy.props.FloatProperty(
        name="Offset", description="Of the object's origin above the ground", subtype="DISTANCE"
    )
    oriented: bpy.props.BoolProperty(name="Tilt", description="As the ground is tilted", default=True)
    heading: bpy.props.EnumProperty(
        name="Heading",
        items=[
            ("OWN", "Own", "As the object is turned by itself"),
            ("PATH", "Along the Path", "The object's Y axis looks where it goes"),
        ],
    )
    footprint: bpy.props.FloatVectorProperty(
        name="Footprint",
        description="Width and length (X and Y) of what stands on the ground; 0 is a point",
        subtype="XYZ_LENGTH",
        size=2,
        min=0.0,
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only over a terrain."""
        return poll_goal(cls, context)

    def work(self, context: bpy.types.Context) -> Generator[float, None, Followed]:
        """Find the ground under the object."""
        goal = chosen_goal(context, self.goal)
        per_frame = SAMPLES_PER_FRAME if self.path == "PROXY" else 1
        self._bake = bake_of(
            context,
            Animated(goal.thing),
            terrain_under(context, self.terrain),
            chosen_frames(context, self.frame_start, self.frame_end, per_frame),
        )
        follow = Follow(
            self.path,
            self.ground,
            self.offset,
            self.oriented,
            self.heading,
            self.footprint[0],
            self.footprint[1],
        )
        return followed(self._bake, follow)

    def write(self, result: Followed, tell: Tell) -> None:
        """Tie the object to the ground, and tell what came of it."""
        write_followed(self._bake, result)
        name, frames = self._bake.goal.name, len(result.places)
        self.report({"INFO"}, f"{name} follows the ground in {frames:,} frames")
        if result.beside:
            self.report(
                {"WARNING"},
                f"{name} is not over the ground in {result.beside:,} frames: there it stays as it is",
            )


class HAPTIC_TERRAIN_OT_leave_ground(bpy.types.Operator, GoalChoices):
    """Let an object go its own way again"""

    bl_idname = "haptic_terrain.leave_ground"
    bl_label = "Leave the Ground"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only where something may follow the ground."""
        if live.rendering:
            cls.poll_message_set(RENDERING)
            return False
        if context.scene is None or not context.scene.objects:
            cls.poll_message_set("There is no object in the scene")
            return False
        return True

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Remove the constraints, and the Empty with the curves."""
        try:
            goal = chosen_goal(context, self.goal).thing.find()
        except AnimationError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if goal is None or not release(goal):
            self.report({"WARNING"}, "It does not follow the ground")
            return {"CANCELLED"}
        return {"FINISHED"}
