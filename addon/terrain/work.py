"""How far a long work has come, told across threads; without Blender."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock

from proxygraph import CancelledError, Progress

Tell = Callable[[float], None]
"""Takes the share that is done, 0 to 1."""


class Work:
    """Steps one after the other, each with its share of the whole.

    Args:
        tell: is called with the share that is done whenever a step begins, in the thread that works.
    """

    def __init__(self, tell: Tell | None = None) -> None:
        self._tell = tell
        self._lock = Lock()
        self._step = ""
        self._done, self._until = 0.0, 0.0
        self._progress = Progress()
        self._cancelled = False

    def begin(self, step: str, *, until: float) -> Progress:
        """Begin a step, in words, after which ``until`` of the whole is done.

        Raises:
            CancelledError: the work was asked to end.
        """
        with self._lock:
            if self._cancelled:
                raise CancelledError("cancelled")
            self._step = step
            self._done, self._until = self._until, until
            self._progress = Progress()
            begun = self._progress
        if self._tell is not None:
            self._tell(self._done)
        return begun

    @property
    def step(self) -> str:
        """What is being done, in words."""
        return self._step

    @property
    def share(self) -> float:
        """What is done, from 0 to 1."""
        with self._lock:
            return self._done + (self._until - self._done) * self._progress.share

    @property
    def cancelled(self) -> bool:
        """Whether it was asked to end."""
        return self._cancelled

    def cancel(self) -> None:
        """Ask the work to end as soon as it can; it then raises ``CancelledError``."""
        with self._lock:
            self._cancelled = True
            self._progress.cancel()
