"""Whether a person is dragging something: what they drag must not be moved under their hand."""

from __future__ import annotations

import bpy


def is_dragging() -> bool:
    """Whether one of Blender's transforms (G, R, S, a gizmo) runs in any window."""
    return any(
        operator.bl_idname.startswith("TRANSFORM_OT_")
        for window in bpy.context.window_manager.windows
        for operator in window.modal_operators
    )
