"""Finding an object again: an undo or a deletion invalidates every reference that Python holds."""

from __future__ import annotations

from dataclasses import dataclass

import bpy


@dataclass(frozen=True)
class Handle:
    """An object, by its name and by the identity that survives renaming."""

    name: str
    session_uid: int

    @staticmethod
    def to(thing: bpy.types.Object) -> Handle:
        """Remember an object."""
        return Handle(thing.name, thing.session_uid)

    def find(self) -> bpy.types.Object | None:
        """Find the object, or ``None`` when it is gone (or used by no scene any more)."""
        found = bpy.data.objects.get(self.name)
        if found is None or found.session_uid != self.session_uid:
            found = next((thing for thing in bpy.data.objects if thing.session_uid == self.session_uid), None)
        if found is None or found.users - int(found.use_fake_user) == 0:
            return None
        return found
