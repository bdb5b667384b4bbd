"""What terrains note when the .blend file is saved."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.app.handlers import persistent

from .kept import remember_places
from .levels_object import put_away_levels


def register() -> None:
    """Add the handler."""
    bpy.app.handlers.save_pre.append(_before_save)


def unregister() -> None:
    """Take it back."""
    if _before_save in bpy.app.handlers.save_pre:
        bpy.app.handlers.save_pre.remove(_before_save)


@persistent  # type: ignore[untyped-decorator]
def _before_save(path: str, *_arguments: object) -> None:
    put_away_levels()  # touch shows them again; a file has the terrain's own mesh
    if path:  # the start-up file has none
        remember_places(Path(path))
