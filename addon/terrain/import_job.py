"""An import of one file or several: prepared in a thread of its own, put into the scene when all is there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from threading import Thread

import bpy
from proxygraph import CancelledError

from ..formats import FormatError
from .add_terrain import add_terrain
from .opened import OpenedGrids
from .options import ImportOptions
from .prepare import Prepared, prepare
from .undone import undone_on_failure
from .work import Tell, Work

GAP = 0.1
"""Between terrains that are imported together, as a share of their width."""


@dataclass
class Imported:
    """What came of it."""

    terrains: list[bpy.types.Object] = field(default_factory=list)
    failures: list[FormatError] = field(default_factory=list)
    """Of the files that cannot be used; nothing of them is in the scene."""


class ImportJob:
    """``start``, then ``poll`` now and then until it is done, then ``finish``; or ``run`` and ``finish``.

    Nothing of Blender's is touched before ``finish``: a job that is cancelled leaves nothing behind.
    """

    def __init__(self, paths: Sequence[Path], options: ImportOptions) -> None:
        self._paths = tuple(paths)
        self._options = options
        self._number = 0
        self._work = Work()
        self._cancelled = False
        self._prepared: list[Prepared] = []
        self._failures: list[FormatError] = []
        self._error: BaseException | None = None
        self._thread: Thread | None = None

    def start(self) -> None:
        """Begin in a thread."""
        self._thread = Thread(target=self.run, name="elevation import", daemon=True)
        self._thread.start()

    def run(self, tell: Tell | None = None) -> None:
        """Prepare every file, here and now; what goes wrong is told by ``finish``.

        Args:
            tell: is called with the share that is done.
        """

        def tell_all(_share: float) -> None:
            if tell is not None:
                tell(self.share)

        try:
            for number, path in enumerate(self._paths):
                self._number, self._work = number, Work(tell_all)
                if self._cancelled:  # looked at after the work is there that ``cancel`` ends
                    return
                self._prepare(path)
        except CancelledError:
            return
        except BaseException as error:  # in a thread nobody would see it
            self._error = error

    def poll(self) -> bool:
        """Whether everything is prepared, or has failed, or was cancelled."""
        return self._thread is None or not self._thread.is_alive()

    def cancel(self) -> None:
        """End as soon as possible; ``finish`` then gives nothing."""
        self._cancelled = True
        self._work.cancel()

    @property
    def cancelled(self) -> bool:
        """Whether it was asked to end."""
        return self._cancelled

    @property
    def share(self) -> float:
        """What is done, from 0 to 1."""
        return (self._number + self._work.share) / max(1, len(self._paths))

    @property
    def step(self) -> str:
        """What is being done, in words."""
        if self._number >= len(self._paths):
            return ""
        return f"{self._paths[self._number].name}: {self._work.step}"

    def finish(self, context: bpy.types.Context, opened: OpenedGrids) -> Imported:
        """Put what was prepared into the scene; a failure here leaves nothing there.

        Args:
            opened: keeps the grids, so that touch need not open them again.

        Raises:
            Exception: what no file is to blame for.
        """
        if self._thread is not None:
            self._thread.join()
        if self._cancelled:
            return Imported()
        if self._error is not None:
            raise self._error
        imported = Imported(failures=self._failures)
        with undone_on_failure():
            for prepared in self._prepared:
                imported.terrains.append(add_terrain(context, prepared))
            _lay_in_a_row(imported.terrains)
        for prepared in self._prepared:
            opened.add(prepared.kept, prepared.samples)
        return imported

    def _prepare(self, path: Path) -> None:
        try:
            prepared = prepare(path, self._options, self._work)
        except FormatError as error:
            self._failures.append(error)
            return
        # Label and data file of one grid may both have been chosen.
        if all(prepared.kept.grid != other.kept.grid for other in self._prepared):
            self._prepared.append(prepared)


def _lay_in_a_row(terrains: Sequence[bpy.types.Object]) -> None:
    """Put each east of the one before it: all are centred on their origins."""
    for before, terrain in pairwise(terrains):
        apart = (before.dimensions.x + terrain.dimensions.x) / 2.0
        terrain.location.x = before.location.x + apart * (1.0 + GAP)
