"""Long work of an operator on Blender's thread: at once for scripts; for people in turns, with progress."""

from __future__ import annotations

import time
from collections.abc import Generator
from typing import Any

import bpy

from ..formats import FormatError
from ..record.animated import AnimationError
from ..terrain.kept import KeptError
from ..terrain.progress import Tell, finished, progress
from ..touch.live import live
from .operator_status import OperatorStatus
from .shown_work import ShownWork

TURN_SECONDS = 0.05
"""Of work between two looks at the keys."""

EXPECTED = (AnimationError, FormatError, KeptError, ValueError)
"""What a person can mend, and is told."""


class InTurns(ShownWork):
    """Of an operator that gives its work as a generator of the share that is done.

    Closing the generator must undo what it did to the scene; what it returns goes to ``write``. A person is
    asked for the properties first.
    """

    answered: bpy.props.BoolProperty(
        description="A person has chosen already: begin, with progress, and let them cancel",
        default=False,
        options={"SKIP_SAVE", "HIDDEN"},
    )

    bl_idname: str
    bl_label: str
    report: Any
    as_keywords: Any
    _asking = False
    """Whether a dialog is open, whose answer will be ``execute``."""
    _work: Generator[float, None, Any] | None = None

    def work(self, context: bpy.types.Context) -> Generator[float, None, Any]:
        """Look at what was chosen, and give the work, not yet begun."""
        raise NotImplementedError

    def write(self, result: Any, tell: Tell) -> None:
        """Put what came of it into the scene."""
        raise NotImplementedError

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Work at once, for scripts; for a person who was asked, in turns."""
        if self._asking and not bpy.app.background:
            again = getattr(bpy.ops.haptic_terrain, self.bl_idname.partition(".")[2])
            again("INVOKE_DEFAULT", **self.as_keywords(ignore=("answered",)), answered=True)
            return {"CANCELLED"}  # the other call finishes, and is what can be undone
        try:
            with progress(context) as tell:
                self.write(finished(self.work(context), tell), tell)
        except EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> OperatorStatus:
        """Ask; then work in turns, so that a person sees how far it is and can cancel it."""
        if context.window is None or bpy.app.background:
            return self.execute(context)
        if not self.answered:
            self._asking = True
            context.window_manager.invoke_props_dialog(self)  # type: ignore[arg-type]
            return {"RUNNING_MODAL"}
        try:
            self._work = self.work(context)
        except EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.begin_showing(context, TURN_SECONDS / 2.0)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Work on; Esc cancels. Nothing else gets through: the scene's frame is not the person's now."""
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, f"{self.bl_label} cancelled: nothing was added")
            return {"CANCELLED"}
        if event.type != "TIMER" or live.rendering:
            return {"RUNNING_MODAL"}
        try:
            share = self._turn()
        except StopIteration as done:
            return self._end(context, done.value)
        except EXPECTED as error:
            self.cancel(context)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except BaseException:
            self.cancel(context)
            raise
        self.show_work(context, self.bl_label, share, "Esc cancels")
        return {"RUNNING_MODAL"}

    def cancel(self, context: bpy.types.Context) -> None:
        """End early: the person, or Blender, takes the work away. Harmless when it has ended."""
        if self._work is None:
            return
        self._work.close()
        self._work = None
        self.end_showing(context)

    def _turn(self) -> float:
        """Work for a moment; gives the share that is done, and raises ``StopIteration`` when all is."""
        end = time.perf_counter() + TURN_SECONDS
        share = 0.0
        while self._work is not None:
            share = next(self._work)
            if time.perf_counter() >= end:
                break
        return share

    def _end(self, context: bpy.types.Context, result: Any) -> OperatorStatus:
        self.cancel(context)
        try:
            with progress(context) as tell:
                self.write(result, tell)
        except EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}
