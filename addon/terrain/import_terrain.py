"""From a grid file to a terrain object, while the caller waits."""

from __future__ import annotations

from pathlib import Path

import bpy

from .add_terrain import add_terrain
from .options import ImportOptions, SceneScale
from .prepare import prepare
from .progress import progress
from .undone import undone_on_failure
from .work import Work

__all__ = ["ImportOptions", "SceneScale", "import_terrain"]


def import_terrain(context: bpy.types.Context, path: Path, options: ImportOptions) -> bpy.types.Object:
    """Make a terrain object and put it into the scene; a failure leaves nothing there.

    Raises:
        FormatError: the file cannot be used.
    """
    with progress(context) as tell, undone_on_failure():
        return add_terrain(context, prepare(path, options, Work(tell)))
