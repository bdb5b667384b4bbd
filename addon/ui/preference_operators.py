"""Copy Diagnostics, Clear Folder and Open Folder: the buttons of the preferences."""

from __future__ import annotations

import shutil
from contextlib import suppress
from pathlib import Path

import bpy

from ..package import OwnFolder, own_folder
from ..terrain.byte_size import in_bytes
from ..touch.live import live
from .diagnostics import diagnostics
from .operator_status import OperatorStatus


class HAPTIC_TERRAIN_OT_copy_diagnostics(bpy.types.Operator):
    """Copy versions, devices and the servo's timing for a bug report; no names and no paths are in it"""

    bl_idname = "haptic_terrain.copy_diagnostics"
    bl_label = "Copy Diagnostics"

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Copy; where there is no clipboard the console has it."""
        text = diagnostics()
        context.window_manager.clipboard = text
        if bpy.app.background:
            print(text)
        self.report({"INFO"}, "The diagnostics are in the clipboard: paste them into the bug report")
        return {"FINISHED"}


class HAPTIC_TERRAIN_OT_clear_folder(bpy.types.Operator):
    """Remove the files that the extension keeps in one of its folders"""

    bl_idname = "haptic_terrain.clear_folder"
    bl_label = "Clear Folder"

    folder: bpy.props.EnumProperty(
        name="Folder",
        description="Whose files are removed",
        items=[
            (OwnFolder.CACHE, "Decoded Grids", "They are decoded again when they are needed"),
            (OwnFolder.MOLA, "Downloaded Grids", "Terrains that were imported from them lose their samples"),
        ],
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Not under a hand that feels what lies there."""
        if live.touch is not None:
            cls.poll_message_set("Touch is running: stop it first, for it may read these files")
            return False
        return True

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Ask: what was downloaded is not made again."""
        return context.window_manager.invoke_confirm(self, event)

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Remove."""
        folder = own_folder(OwnFolder(self.folder))
        live.opened.clear()  # what is open is mapped from there
        before = folder_size(folder)
        shutil.rmtree(folder, ignore_errors=True)
        left = folder_size(folder)
        self.report({"INFO"}, f"{in_bytes(before - left)} were removed")
        if left:
            self.report({"WARNING"}, f"{in_bytes(left)} are still there: other programs use them")
        return {"FINISHED"}


def folder_size(folder: Path) -> int:
    """Bytes of all files in a folder; 0 where there is none."""
    size = 0
    with suppress(OSError):
        for path in folder.rglob("*"):
            with suppress(OSError):
                size += path.stat().st_size if path.is_file() else 0
    return size
