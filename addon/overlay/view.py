"""The region that is drawn into, and how it looks into the scene."""

from __future__ import annotations

from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector

from .rect import Rect, Side, uncovered

GIZMO_REACH = 2.1
"""Blender's own buttons begin below the navigation gizmo by so many times the distance of its middle from the
region's corner (``view3d_gizmo_navigate.cc``)."""

GIZMO_OFFSET = 10.0
"""Pixels at a scale of 1 between the navigation gizmo and the region's corner (the same file)."""

BUTTONS = 44.0, 130.0
"""Pixels at a scale of 1 that the column of navigation buttons takes from the right side, and downwards."""

SIDES: dict[str, Side] = {"LEFT": "LEFT", "RIGHT": "RIGHT", "TOP": "TOP", "BOTTOM": "BOTTOM"}
"""Where a region that is no part of a quad view may lie, as ``Region.alignment`` has it."""


@dataclass(frozen=True)
class View:
    """A 3D view's region."""

    free: Rect
    """What sidebar, toolbar and headers leave of it, pixels."""
    axes: float
    """Pixels from the top down that Blender's navigation gizmo takes; 0 where it is not shown."""
    has_buttons: bool
    """Whether Blender's navigation buttons are shown below it."""
    width: float
    """Pixels, of all of it."""
    scale: float
    """Pixels that a pixel of the design has: interface scale and screen density."""
    perspective: Matrix
    """From the scene to clip space."""
    rotation: Matrix
    """3 x 3; its columns are the view's right, up, and backward in the scene."""
    has_text: bool = True
    """Whether it shows map, readout and legend: of a quad view only the part that may be turned."""

    @property
    def buttons(self) -> Rect:
        """Where Blender's navigation buttons are; of no size where they are not."""
        width, height = (size * self.scale if self.has_buttons else 0.0 for size in BUTTONS)
        right, top = self.free.right, self.free.top - self.axes
        return Rect(right - width, top - height, right, top)

    @property
    def to_right(self) -> Vector:
        """In the scene, of length 1."""
        return Vector([row[0] for row in self.rotation])


def view_of(context: bpy.types.Context) -> View | None:
    """The region of a context; ``None`` where it is none of a 3D view."""
    region, shown, area, space = context.region, context.region_data, context.area, context.space_data
    if region is None or shown is None or area is None or not isinstance(space, bpy.types.SpaceView3D):
        return None
    scale = context.preferences.system.ui_scale
    beside = [
        (SIDES[other.alignment], _rect(other))
        for other in area.regions
        if other.alignment in SIDES and other.width > 1 and other.height > 1 and other != region
    ]
    whole = _rect(region)
    return View(
        free=uncovered(whole, beside).moved(-whole.left, -whole.bottom),
        axes=_axes(context.preferences.view) * scale if _has_navigation(space) else 0.0,
        has_buttons=_has_navigation(space) and context.preferences.view.show_navigate_ui,
        width=region.width,
        scale=scale,
        perspective=shown.perspective_matrix,
        rotation=shown.view_matrix.to_3x3().inverted_safe().normalized(),
        has_text=not space.region_quadviews or shown == space.region_3d,
    )


def _rect(region: bpy.types.Region) -> Rect:
    return Rect(region.x, region.y, region.x + region.width, region.y + region.height)


def _has_navigation(space: bpy.types.SpaceView3D) -> bool:
    return space.show_gizmo and space.show_gizmo_navigate


def _axes(preferences: bpy.types.PreferencesView) -> float:
    """Pixels at a scale of 1 from the region's top to the navigation buttons."""
    if preferences.mini_axis_type == "NONE":
        return 0.0
    return GIZMO_REACH * (preferences.gizmo_size_navigate_v3d / 2.0 + GIZMO_OFFSET)
