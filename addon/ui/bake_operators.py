"""Bake Touch: an animated object feels the terrain."""

from __future__ import annotations

import time
from collections.abc import Generator

import bpy

from ..formats import FormatError
from ..record.animated import AnimationError
from ..record.bake import SAMPLES_PER_FRAME, Bake, Baked, bake_of, baked, write_baked
from ..record.take_options import TakeOptions, TrailKind
from ..terrain.kept import KeptError
from ..terrain.progress import Tell, progress
from ..touch.live import live
from .goal_choices import GoalChoices, chosen_frames, chosen_goal, poll_goal, terrain_under
from .operator_status import OperatorStatus

TURN_SECONDS = 0.05
"""Of baking between two looks at the keys."""

EXPECTED = (AnimationError, FormatError, KeptError, ValueError)
"""What a person can mend."""


class HAPTIC_TERRAIN_OT_bake(bpy.types.Operator, GoalChoices):
    """Let an animated object, or the end of a bone, feel the terrain, and make a take of it"""

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
    trail: bpy.props.BoolProperty(
        name="Trail", description="Also draw a trail over the terrain, coloured by force", default=True
    )
    reduced: bpy.props.BoolProperty(
        name="Fewest Keys",
        description="Leave out keys without which the point stays within a millimetre of the hand's motion",
        default=False,
    )

    _work: Generator[float, None, Baked] | None = None
    _timer: bpy.types.Timer | None = None

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only over a terrain."""
        return poll_goal(cls, context)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Bake at once, for scripts."""
        try:
            bake = self._bake(context)
            with progress(context) as tell:
                work = baked(bake)
                result = _finished(work, tell)
                return self._write(bake, result, tell)
        except EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Bake in turns, so that a person sees how far it is and can cancel it."""
        if context.window is None:
            return self.execute(context)
        try:
            self._what = self._bake(context)
        except EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._work = baked(self._what)
        manager = context.window_manager
        self._timer = manager.event_timer_add(TURN_SECONDS / 2.0, window=context.window)
        manager.progress_begin(0.0, 1.0)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Bake on; Esc cancels, and nothing else gets through meanwhile: the frame is not the person's."""
        if self._work is None:
            return {"CANCELLED"}
        if event.type == "ESC" and event.value == "PRESS":
            self._clear(context)
            self.report({"INFO"}, "Bake cancelled: nothing was added")
            return {"CANCELLED"}
        if event.type != "TIMER" or live.rendering:
            return {"RUNNING_MODAL"}
        try:
            result = self._turn(context)
            if result is None:
                return {"RUNNING_MODAL"}
            self._clear(context)
            with progress(context) as tell:
                return self._write(self._what, result, tell)
        except EXPECTED as error:
            self.report({"ERROR"}, str(error))
        except BaseException:
            self._clear(context)
            raise
        self._clear(context)
        return {"CANCELLED"}

    def cancel(self, context: bpy.types.Context) -> None:
        """Blender takes the bake away: another file is loaded, or the window is closed."""
        self._clear(context)

    def _bake(self, context: bpy.types.Context) -> Bake:
        return bake_of(
            context,
            chosen_goal(context, self.goal, self.bone, self.tip),
            terrain_under(context, self.terrain),
            chosen_frames(context, self.frame_start, self.frame_end, self.samples),
        )

    def _turn(self, context: bpy.types.Context) -> Baked | None:
        """Bake for a moment; gives what was felt once all is."""
        end = time.perf_counter() + TURN_SECONDS
        share = 0.0
        try:
            while self._work is not None and time.perf_counter() < end:
                share = next(self._work)
        except StopIteration as done:
            result: Baked = done.value
            return result
        context.window_manager.progress_update(share)
        if context.workspace is not None:
            context.workspace.status_text_set(f"{self._what.goal.name}: {share:.0%} baked (Esc cancels)")
        return None

    def _clear(self, context: bpy.types.Context) -> None:
        """Take timer and display back; closing the work restores the scene's frame."""
        manager = context.window_manager
        if self._work is not None:
            self._work.close()
        if self._timer is not None:
            manager.event_timer_remove(self._timer)
        manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)
        self._work = self._timer = None

    def _write(self, bake: Bake, result: Baked, tell: Tell) -> OperatorStatus:
        trails: frozenset[TrailKind] = frozenset({"TUBE"}) if self.trail else frozenset()
        options = TakeOptions(bake.frames.first, reduced=self.reduced, trails=trails)
        take = write_baked(bake, result, options, tell)
        self.report(
            {"INFO"}, f"{take.take.name}: {take.seconds:.1f} s of {bake.goal.name}, {take.keyframes:,} keys"
        )
        for note in result.notes:
            self.report({"WARNING"}, note)
        return {"FINISHED"}


def _finished(work: Generator[float, None, Baked], tell: Tell) -> Baked:
    """Bake to the end."""
    try:
        while True:
            tell(next(work))
    except StopIteration as done:
        result: Baked = done.value
        return result
