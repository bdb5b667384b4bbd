"""The Empty that a person drags: the simulated hand is pulled toward it."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix, Vector
from proxygraph import Grid, GridLayout, Window

from ..terrain.frame import Point, nearest_on_map
from .own_object import mark_own, own_object
from .placement import Placement

NAME = "Touch Target"

MARK = "haptic_terrain_target"
"""ID property of the Empty."""

CLEARANCE = 0.03
"""Above the ground where a hand begins, as a share of the window's width as it is seen."""


def target_object(scene: bpy.types.Scene) -> bpy.types.Object | None:
    """Find the Empty in a scene."""
    return own_object(scene, MARK)


def target_place(empty: bpy.types.Object, placement: Placement, layout: GridLayout) -> Point | None:
    """Terrain metres of the Empty, or of the map's edge nearest to it; ``None`` where they are no numbers.

    A map that wraps has no edge in the east or west: beside it the Empty is beyond the seam.
    """
    place = placement.to_terrain(empty.matrix_world.translation)
    return nearest_on_map(layout, place) if all(map(math.isfinite, place)) else None


def add_target(context: bpy.types.Context, placement: Placement, window: Window) -> bpy.types.Object:
    """Make the Empty above the middle of the window, ready to be dragged."""
    target = bpy.data.objects.new(NAME, None)
    mark_own(target, MARK)
    across = window.width * placement.units_per_metre
    target.empty_display_type = "SPHERE"
    target.empty_display_size = 0.01 * across
    target.location = placement.to_scene(window.east, window.north, window.up + clearance(window))
    context.scene.collection.objects.link(target)
    context.view_layer.update()
    return target


def move_target(scene: bpy.types.Scene, place: Vector) -> None:
    """Bring the Empty to a place in the scene, where there is one."""
    target = target_object(scene)
    if target is not None:
        place_target(target, place)


def place_target(target: bpy.types.Object, place: Vector) -> None:
    """Bring the Empty to a place in the scene."""
    target.matrix_world = Matrix.Translation(place[:]) @ target.matrix_world.to_3x3().to_4x4()


def clearance(window: Window) -> float:
    """Metres of terrain above the ground where a hand begins."""
    return CLEARANCE * window.width / window.exaggeration


def above_ground(place: Point, grid: Grid, window: Window) -> Point:
    """Let a hand begin above the ground: where the Empty was left below, it would feel nothing."""
    east, north, up = place
    ground = grid.elevation_at(east, north)
    return place if ground is None or up > ground else (east, north, ground + clearance(window))
