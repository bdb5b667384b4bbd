"""Finding something again: an undo or a deletion invalidates every reference that Python holds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar, cast

import bpy

Thing = TypeVar("Thing", bpy.types.Object, bpy.types.Scene)


@dataclass(frozen=True)
class Handle(Generic[Thing]):
    """An object or a scene, by its name and by the identity that survives renaming."""

    kind: str
    """Of the collection in ``bpy.data``."""
    name: str
    session_uid: int

    @staticmethod
    def to(thing: Thing) -> Handle[Thing]:
        """Remember an object or a scene."""
        kind = "scenes" if isinstance(thing, bpy.types.Scene) else "objects"
        return Handle(kind, thing.name, thing.session_uid)

    def find(self) -> Thing | None:
        """Find it, or ``None`` when it is gone (or is an object that no scene uses any more)."""
        things = getattr(bpy.data, self.kind)
        found = things.get(self.name)
        if found is None or found.session_uid != self.session_uid:
            found = next((thing for thing in things if thing.session_uid == self.session_uid), None)
        if found is None or (self.kind == "objects" and found.users - int(found.use_fake_user) == 0):
            return None
        return cast("Thing", found)
