"""Long work in a thread of its own, of which a person sees how far it is, and which they can cancel."""

from __future__ import annotations

from threading import Thread

from proxygraph import CancelledError

from .work import Tell, Work


class Job:
    """``start``, then ``poll`` now and then until it is done, then ``check``; or ``run`` and ``check``.

    What is to be done is ``do``, which must not touch Blender, and keeps what comes of it.

    This is no generic class: ``typing`` keeps what those are made of for ever, and with it the module bpy; if
    the add-on is taken away, Blender 4.2 then crashes at its end.

    Args:
        title: of the job, in words.
        tell: is called with the share that is done, in the thread that works.
    """

    def __init__(self, title: str, tell: Tell | None = None) -> None:
        self._title = title
        self._work = Work(tell)
        self._error: BaseException | None = None
        self._thread: Thread | None = None

    def do(self, work: Work) -> None:
        """Do it, step by step."""
        raise NotImplementedError

    def start(self) -> None:
        """Begin in a thread. It is a daemon, which does not keep Blender from quitting."""
        self._thread = Thread(target=self.run, name=self._title, daemon=True)
        self._thread.start()

    def run(self) -> None:
        """Do it here and now; what goes wrong is told by ``check``."""
        try:
            self.do(self._work)
        except CancelledError:
            return
        except BaseException as error:  # in a thread nobody would see it
            self._error = error

    def poll(self) -> bool:
        """Whether it has ended; one that is cancelled ends by itself, and is not waited for."""
        return self.cancelled or self._thread is None or not self._thread.is_alive()

    def cancel(self) -> None:
        """End as soon as possible."""
        self._work.cancel()

    @property
    def cancelled(self) -> bool:
        """Whether it was asked to end."""
        return self._work.cancelled

    @property
    def share(self) -> float:
        """What is done, from 0 to 1."""
        return self._work.share

    @property
    def step(self) -> str:
        """What is being done, in words."""
        return f"{self._title}: {self._work.step}"

    def check(self) -> None:
        """Whether it came to its end.

        Raises:
            CancelledError: it was cancelled.
            Exception: what went wrong.
        """
        if self.cancelled:
            raise CancelledError("cancelled")
        if self._error is not None:
            raise self._error
