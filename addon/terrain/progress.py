"""How far something long has come, shown at the pointer."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy

from .work import Tell

__all__ = ["Tell", "progress"]


@contextmanager
def progress(context: bpy.types.Context) -> Iterator[Tell]:
    """Show progress, and take the display back whatever happens."""
    manager = context.window_manager
    manager.progress_begin(0.0, 1.0)
    try:
        yield manager.progress_update
    finally:
        manager.progress_end()
