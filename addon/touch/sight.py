"""How large things are on the screen."""

from __future__ import annotations

import bpy
from mathutils import Matrix, Vector

from ..terrain.view import views


def pixels_per_unit(context: bpy.types.Context, scene: bpy.types.Scene, place: Vector) -> float | None:
    """Pixels of a Blender unit across the line of sight, at a place, in the 3D view that has most of them.

    Returns:
        ``None`` where no view of the scene has the place before it.
    """
    scales = []
    for window, area in views(context):
        if window.scene != scene:
            continue
        for region in area.regions:
            # In quad view there are four of them, each with its own.
            view = region.data if region.type == "WINDOW" else None
            if view is not None:
                scales.append(scale_on_screen(view.window_matrix, view.view_matrix, region.width, place))
    return max((scale for scale in scales if scale > 0.0), default=None)


def scale_on_screen(window: Matrix, view: Matrix, width: int, place: Vector) -> float:
    """Pixels of a unit at a place: perspective, orthographic or a camera's; 0 or below where it is behind.

    Args:
        window: from the viewer's coordinates to the clip space.
        view: from the scene's coordinates to the viewer's.
        width: of the region, pixels.
    """
    depth = (window @ (view @ place.to_4d())).w
    return window[0][0] * width / 2.0 / depth if depth > 0.0 else 0.0
