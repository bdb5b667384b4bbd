"""The hand that a mouse moves; without Blender."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..terrain.frame import Point
from .pointer_map import PointerMap
from .pointer_view import Pixel
from .workspace import within_reach

CATCH_UP = 300.0
"""Pixels of the mouse's way in which the distance of a hand that is not under the pointer falls to 1/e. Ours:
after the view was turned, or the pointer was elsewhere, the hand neither jumps nor stays away."""

SPEED = 0.5
"""Workspace metres a second: a brisk hand. A pointer can jump, a hand cannot."""

NOTCH = 0.002
"""Workspace metres for a notch of the wheel: 0.4 N more on flat ground, as the simulated hand's muscle is."""

PRESS = 0.03
"""Workspace metres under the ground that the hand is pulled to at most: there it pushes with nearly 6 N.
Steep ground lifts a hand that goes on, for a mouse is not held back by it as an arm is."""

TURNING = math.radians(180.0)
"""Radians a second that the handle turns: a twist is seen, and is no jerk."""

LONGEST = 0.1
"""Seconds that the hand moves on at a time: while Blender stands still, nobody sees where it goes."""


@dataclass
class MouseHand:
    """Where the mouse wants the hand, and how far it has come."""

    goal: Point
    """Where the pointer wants it, workspace metres."""
    pulled: Point
    """Where its muscle pulls it now, on the way to the goal."""
    pulled_at: float
    """Seconds of the session's clock."""
    ground: float | None = None
    """Workspace metres up where the ground is under the goal; ``None`` where there has been none yet."""
    pointer: Pixel | None = None
    """Where the pointer was last seen; ``None`` where it has been elsewhere since."""
    has_met: bool = False
    """Whether it has been sent to the pointer, as it is when the pointer first comes to a view."""
    turn_left: float = 0.0
    """Radians that the handle still has to be turned."""
    holds_button: bool = False
    """Whether the mouse's operator holds the stylus button down, and has to let it go."""
    lets_go: bool = False
    """Whether it has let go, and the servo does not know yet."""
    heard_at: float = 0.0
    """Seconds of the session's clock when its operator last heard of what a person did."""

    def go_under(self, pointer: Pixel, seen: PointerMap) -> None:
        """Put the hand under the pointer, wherever it was."""
        self.pointer, self.has_met = pointer, True
        found = seen.under(pointer, self._seen_at(self.goal))
        if found is not None:
            self.goal = _plus(self.goal, _minus(found, self._seen_at(self.goal)))

    def move(self, pointer: Pixel, seen: PointerMap, *, catches_up: bool) -> None:
        """Move the hand as the pointer moved since it was seen last.

        Args:
            catches_up: whether a hand that is not under the pointer comes nearer to it: not where it moves
                what the pointer points at.
        """
        if not self.has_met:
            self.go_under(pointer, seen)
            return
        before, self.pointer = self.pointer, pointer
        if before is None:
            return
        here = self._seen_at(self.goal)
        was, now = seen.under(before, here), seen.under(pointer, here)
        if now is None:
            return
        if was is not None:
            self.goal = _plus(self.goal, _minus(now, was))
        if catches_up:
            share = 1.0 - math.exp(-math.dist(before, pointer) / CATCH_UP)
            self.goal = _plus(self.goal, _minus(now, self._seen_at(self.goal)), share)

    def lift_with(self, pointer: Pixel, seen: PointerMap, *, upright: bool) -> None:
        """Move the hand in the direction that pointers do not have, by the pointer's way up the screen.

        Args:
            upright: up, however the view looks.
        """
        before, self.pointer = self.pointer, pointer
        if before is not None:
            outward = (0.0, 0.0, 1.0) if upright else seen.outward(self.goal)
            pixels = pointer[1] - before[1]
            self.goal = _plus(self.goal, outward, pixels * seen.metres_per_pixel(self.goal))

    def go_out(self, pointer: Pixel, seen: PointerMap, metres: float, *, upright: bool) -> None:
        """Move the hand in the direction that pointers do not have, so that it stays under one that rests.

        Args:
            upright: straight up, however the view looks.
        """
        outward = (0.0, 0.0, 1.0) if upright else seen.outward(self.goal)
        before, self.goal = self.goal, _plus(self.goal, outward, metres)
        if upright:
            return
        here, there = self._seen_at(before), self._seen_at(self.goal)
        was, now = seen.under(pointer, here), seen.under(pointer, there)
        if was is not None and now is not None:
            self.goal = _plus(self.goal, _minus(_minus(now, was), _minus(there, here)))

    def stay(self) -> None:
        """Stay where it is: the pointer goes elsewhere, or something else moves with it."""
        self.pointer = None

    def keep_within(self, workspace: tuple[float, float, float], ground: float | None) -> None:
        """Keep the goal within reach: of the workspace, and upright of the ground, wherever that is.

        Args:
            workspace: width, depth and height that the hand can reach, metres.
            ground: workspace metres up where the ground is; over a hole and beside the map ``None``, which
                counts as what was last: a hand shall not dive there and come back under the ground.
        """
        self.ground = ground = self.ground if ground is None else ground
        x, y, z = within_reach(self.goal, workspace)
        half = workspace[2] / 2.0
        lowest, highest = (-half, half) if ground is None else (ground - PRESS, max(half, ground + half))
        self.goal = x, y, min(max(z, lowest), highest)

    def come(self, time: float) -> float:
        """Come nearer to the goal until a time of the session's clock.

        Returns:
            Radians that the handle turns meanwhile.
        """
        seconds, self.pulled_at = min(max(time - self.pulled_at, 0.0), LONGEST), time
        way = _minus(self.goal, self.pulled)
        far = math.hypot(*way)
        share = min(SPEED * seconds / far, 1.0) if far > 0.0 else 1.0
        self.pulled = _plus(self.pulled, way, share)
        turned = math.copysign(min(abs(self.turn_left), TURNING * seconds), self.turn_left)
        self.turn_left -= turned
        return turned

    def _seen_at(self, place: Point) -> Point:
        """Where what the eye follows is: the hand, or the ground above it, into which it presses."""
        x, y, z = place
        return x, y, z if self.ground is None else max(z, self.ground)


def _plus(place: Point, way: Point, share: float = 1.0) -> Point:
    return place[0] + share * way[0], place[1] + share * way[1], place[2] + share * way[2]


def _minus(place: Point, other: Point) -> Point:
    return _plus(place, other, -1.0)
