"""How far something long has come, shown at the pointer."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from contextlib import contextmanager
from typing import TypeVar

import bpy

from .work import Tell

__all__ = ["Tell", "finished", "progress"]

Result = TypeVar("Result")


@contextmanager
def progress(context: bpy.types.Context) -> Iterator[Tell]:
    """Show progress, and take the display back whatever happens."""
    manager = context.window_manager
    manager.progress_begin(0.0, 1.0)
    try:
        yield manager.progress_update
    finally:
        manager.progress_end()


def finished(work: Generator[float, None, Result], tell: Tell = lambda _share: None) -> Result:
    """Do work that tells the share that is done, and give what comes of it."""
    try:
        while True:
            tell(next(work))
    except StopIteration as done:
        result: Result = done.value
        return result
