"""The Empty that a person drags: the simulated hand is pulled toward it."""

from __future__ import annotations

import bpy
from proxygraph import Grid, Window

from ..terrain.frame import Point
from .placement import Placement

NAME = "Touch Target"

CLEARANCE = 0.03
"""Above the ground where a hand begins, as a share of the window's width as it is seen."""


def target_object(context: bpy.types.Context) -> bpy.types.Object | None:
    """Find the Empty in this scene."""
    target = bpy.data.objects.get(NAME)
    return target if target is not None and target.name in context.scene.objects else None


def add_target(context: bpy.types.Context, placement: Placement, window: Window) -> bpy.types.Object:
    """Make the Empty above the middle of the window, ready to be dragged."""
    target = bpy.data.objects.new(NAME, None)
    across = window.width * placement.frame.units_per_metre * abs(placement.matrix.to_scale().x)
    target.empty_display_type = "SPHERE"
    target.empty_display_size = 0.01 * across
    target.location = placement.to_scene(window.east, window.north, window.up + clearance(window))
    context.scene.collection.objects.link(target)
    context.view_layer.update()
    return target


def clearance(window: Window) -> float:
    """Metres of terrain above the ground where a hand begins."""
    return CLEARANCE * window.width / window.exaggeration


def above_ground(place: Point, grid: Grid, window: Window) -> Point:
    """Let a hand begin above the ground: where the Empty was left below, it would feel nothing."""
    east, north, up = place
    ground = grid.elevation_at(east, north)
    return place if ground is None or up > ground else (east, north, ground + clearance(window))


def to_workspace(place: Point, window: Window, width: float) -> Point:
    """Workspace metres of a terrain place.

    Args:
        width: of the device's workspace, metres.
    """
    east, north, up = place
    scale = width / window.width
    return (
        (east - window.east) * scale,
        (north - window.north) * scale,
        (up - window.up) * scale * window.exaggeration,
    )
