"""An operator that works in a thread: progress at the pointer and in the status bar, and Esc to cancel."""

from __future__ import annotations

from typing import Any, Protocol

import bpy

from .operator_status import OperatorStatus
from .shown_work import ShownWork

POLL_SECONDS = 0.1
"""Between two looks at a job that runs."""


class Job(Protocol):
    """Work in a thread."""

    def start(self) -> None:
        """Begin."""

    def poll(self) -> bool:
        """Whether it has ended."""

    def cancel(self) -> None:
        """End as soon as possible."""

    @property
    def cancelled(self) -> bool:
        """Whether it was asked to end."""

    @property
    def share(self) -> float:
        """What is done, from 0 to 1."""

    @property
    def step(self) -> str:
        """What is being done, in words."""


class JobOperator(ShownWork):
    """What an operator needs to watch a job; it gives ``end``, which takes the job when that has ended."""

    _job: Any = None

    def begin(self, context: bpy.types.Context, job: Job) -> OperatorStatus:
        """Start the job, and watch it."""
        self._job = job
        self.begin_showing(context, POLL_SECONDS)
        job.start()
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Look how far it is; Esc cancels it, all else goes on as ever."""
        job = self._job
        if job is None:
            return {"CANCELLED"}
        if event.type == "ESC" and event.value == "PRESS":
            job.cancel()
            return {"RUNNING_MODAL"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if not job.poll():
            self.show_work(context, job.step, job.share, "ending ..." if job.cancelled else "Esc cancels")
            return {"PASS_THROUGH"}
        self._clear(context)
        return self.end(context, job)

    def cancel(self, context: bpy.types.Context) -> None:
        """Blender takes the operator away: another file is loaded, or the window is closed."""
        if self._job is not None:
            self._job.cancel()
            self._clear(context)

    def end(self, context: bpy.types.Context, job: Any) -> OperatorStatus:
        """Do what is to be done with what the job made, and tell what came of it."""
        raise NotImplementedError

    def _clear(self, context: bpy.types.Context) -> None:
        self.end_showing(context)
        self._job = None
