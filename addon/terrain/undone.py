"""All or nothing: what was begun in Blender's data and could not be finished is taken back."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy


@contextmanager
def undone_on_failure() -> Iterator[None]:
    """Remove objects with their data, materials, actions and collections made inside when that fails."""
    before = {thing.session_uid for thing in _things()}
    try:
        yield
    except BaseException:
        bpy.data.batch_remove([thing for thing in _things() if thing.session_uid not in before])
        raise


def _things() -> Iterator[bpy.types.ID]:
    data = bpy.data
    for things in (
        data.objects,
        data.meshes,
        data.curves,
        data.materials,
        data.actions,
        data.collections,
    ):
        yield from things
