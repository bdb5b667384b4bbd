"""From the mouse pointer to the hand: where in the workspace a pixel of a 3D view is; without Blender.

A pointer has two directions and a hand three. The pointer moves the hand over a surface through where it is:

* where the view looks down on the ground, at the hand's height. The hand stays under the pointer, as the
  mouse is pushed over a table;
* where the view looks along the ground, upright, facing the view: then up on the screen is up.

The third direction, up or away, is that of the wheel.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from proxygraph import Window

from ..terrain.frame import Point, TerrainFrame
from .pointer_view import Numbers, Pixel, PointerView, Ray
from .workspace import from_workspace, nearest_turn, to_workspace, within_reach

LOOKS_DOWN = math.sin(math.radians(20.0))
"""Of the view's slope. Ours: where ground is seen flatter than this, a pixel up the screen goes three times
as far as one beside."""


@dataclass(frozen=True)
class PointerMap:
    """A view of a terrain, and where the workspace lies on what is seen."""

    view: PointerView
    """In the terrain object's coordinates."""
    frame: TerrainFrame
    window: Window
    """That the view shows."""
    workspace: tuple[float, float, float]
    """Width, depth and height that the hand can reach, metres."""

    def under(self, pointer: Pixel, hand: Point) -> Point | None:
        """Where the pointer puts the hand, within its reach; ``None`` where it points at the sky.

        Args:
            hand: where it is, workspace metres.
        """
        ray, here = self.view.ray(pointer), self._shown(hand)
        if self._looks_down(here):
            found = self._at_height(ray, here)
            place = self._hand_at(found, hand)
            return None if place is None else (place[0], place[1], hand[2])
        return self._hand_at(self._facing(ray, here), hand)

    def outward(self, hand: Point) -> Point:
        """The direction that no pointer has, of length 1: up, or along the ground away from whoever looks."""
        here = self._shown(hand)
        if self._looks_down(here):
            return 0.0, 0.0, 1.0
        # Far enough for 64 bits, near enough that a globe is flat.
        step = 1e-3 * self.window.width * self.frame.units_per_metre
        x, y, _z = self._to_workspace(here + step * self._level(here))
        east, north = x - hand[0], y - hand[1]
        length = math.hypot(east, north)
        return (east / length, north / length, 0.0) if length > 0.0 else (0.0, 0.0, 1.0)

    def metres_per_pixel(self, hand: Point) -> float:
        """Workspace metres that a pixel is wide where the hand is."""
        terrain = self.view.units_per_pixel(self._shown(hand)) / self.frame.units_per_metre
        return terrain * self.workspace[0] / self.window.width

    def _shown(self, hand: Point) -> Numbers:
        """Where a hand is seen, in the object's coordinates; beyond a seam it goes straight on."""
        east, north, up = from_workspace(hand, self.window, self.workspace[0])
        middle = self.frame.on_map(self.window.east)
        return np.array(self.frame.shown(middle + (east - self.window.east), north, up), dtype=np.float64)

    def _to_workspace(self, place: Numbers) -> Point:
        east, north, up = self.frame.to_terrain(float(place[0]), float(place[1]), float(place[2]))
        east = nearest_turn(east, self.window.east, self.frame.turn)
        return to_workspace((east, north, up), self.window, self.workspace[0])

    def _hand_at(self, place: Numbers | None, hand: Point) -> Point | None:
        if place is None:
            return None
        found = self._to_workspace(place)
        return within_reach(found, self.workspace) if all(map(math.isfinite, found)) else None

    def _upward(self, here: Numbers) -> Numbers:
        """Away from the ground at the hand, a unit vector in the object's coordinates."""
        if self.frame.bend is None:
            return np.array((0.0, 0.0, 1.0))
        away = here - self._centre()
        return np.asarray(away / np.linalg.norm(away))

    def _looks_down(self, here: Numbers) -> bool:
        return abs(float(self.view.forward @ self._upward(here))) >= LOOKS_DOWN

    def _level(self, here: Numbers) -> Numbers:
        """Where the view looks, along the ground, a unit vector in the object's coordinates."""
        upward, forward = self._upward(here), self.view.forward
        level = forward - (forward @ upward) * upward
        return np.asarray(level / np.linalg.norm(level))

    def _facing(self, ray: Ray, here: Numbers) -> Numbers | None:
        """Where a ray meets the upright plane through the hand that faces the view."""
        level = self._level(here)
        slope = float(ray.direction @ level)
        return ray.at(float((here - ray.origin) @ level) / slope) if slope != 0.0 else None

    def _at_height(self, ray: Ray, here: Numbers) -> Numbers | None:
        """Where a ray meets all that is as high as the hand: a plane, or a sphere where the map is bent."""
        if self.frame.bend is None:
            slope = float(ray.direction[2])
            return ray.at(float(here[2] - ray.origin[2]) / slope) if slope != 0.0 else None
        centre = self._centre()
        away, along = ray.origin - centre, ray.direction
        half = float(away @ along)
        square = float(along @ along)
        beside = float(away @ away) - float((here - centre) @ (here - centre))
        left = half * half - square * beside
        if left < 0.0:
            return None
        nearer, farther = (-half - math.sqrt(left)) / square, (-half + math.sqrt(left)) / square
        found = ray.at(nearer)  # from inside the globe only the other one is before the eye
        return ray.at(farther) if found is None else found

    def _centre(self) -> Numbers:
        """Of the sphere that the map is bent to, in the object's coordinates."""
        radius = self.frame.bend.radius if self.frame.bend is not None else math.inf
        return np.array((0.0, 0.0, -radius * self.frame.units_per_metre))
