"""What terrains note of their data files when the .blend file is saved, and when they are appended."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
from bpy.app.handlers import persistent

from .kept import find_beside, remember_places
from .levels_object import put_away_levels


def register() -> None:
    """Add the handlers."""
    for handlers, handler in _handlers():
        handlers.append(handler)


def unregister() -> None:
    """Take them back."""
    for handlers, handler in reversed(_handlers()):
        if handler in handlers:
            handlers.remove(handler)


@persistent  # type: ignore[untyped-decorator]
def _before_save(path: str, *_arguments: object) -> None:
    put_away_levels()  # touch shows them again; a file has the terrain's own mesh
    if path:  # the start-up file has none
        remember_places(Path(path))


@persistent  # type: ignore[untyped-decorator]
def _after_import(imported: Any, *_arguments: object) -> None:
    """An appended terrain forgets its file, and so from where its grid is to be looked for."""
    for item in imported.import_items:
        if (
            isinstance(item.id, bpy.types.Object)
            and item.id.library is None
            and item.source_library is not None
        ):
            find_beside(item.id, Path(bpy.path.abspath(item.source_library.filepath)))


def _handlers() -> list[tuple[list[Any], Callable[..., None]]]:
    handlers: list[tuple[list[Any], Callable[..., None]]] = [(bpy.app.handlers.save_pre, _before_save)]
    # Blender tells of what it appended from 4.3 on.
    if hasattr(bpy.app.handlers, "blend_import_post"):
        handlers.append((bpy.app.handlers.blend_import_post, _after_import))
    return handlers
