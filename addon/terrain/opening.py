"""Opening a terrain's grid again: at once where it is at hand, else with its progress shown."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor, wait

import bpy
from proxygraph import Grid, Progress

from .kept import KeptTerrain
from .opened import OpenedGrids
from .progress import progress

LOOK_SECONDS = 0.05
"""Between two looks at how far it is; what is opened sooner shows nothing."""


def open_shown(opened: OpenedGrids, kept: KeptTerrain) -> Grid:
    """Open a terrain's grid in a thread, and show at the pointer how far it is.

    This waits for the thread, so Blender reads no keys meanwhile and nobody can cancel it there; an import
    can be cancelled, and after one the grid is open already. An interrupt of Python's ends it.

    Raises:
        FormatError: the file was changed, or cannot be read.
    """
    told = Progress()
    with ThreadPoolExecutor(1, thread_name_prefix="elevation opening") as pool:
        opening = pool.submit(opened.open, kept, told)
        try:
            if not _is_done(opening):
                with progress(bpy.context) as tell:
                    while not _is_done(opening):
                        tell(told.share)
        except BaseException:
            told.cancel()  # leaving the pool waits for the thread
            raise
        return opening.result()


def _is_done(opening: Future[Grid]) -> bool:
    return bool(wait([opening], timeout=LOOK_SECONDS).done)
