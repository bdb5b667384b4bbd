"""The hand follows the mouse or the Empty, and the Empty follows the window.

What counts is where the hand is in its workspace. While a mode moves the window, or a person drags the Empty,
it stays what it meant when that began. When both have ended, it is brought to the hand.
"""

from __future__ import annotations

from proxygraph import Window

from ..terrain.frame import Point
from .dragging import is_dragging
from .live import Touch, live
from .placement import Placement
from .target import place_target, target_place
from .windows import is_same
from .workspace import from_workspace, nearest_turn, to_workspace, within_reach


def lay_window(touch: Touch, window: Window) -> None:
    """Lay the workspace elsewhere: what was panned or zoomed ends; Empty and views stay where they are.

    Raises:
        SessionError: too many commands wait already.
    """
    touch.session.set_window(window)
    touch.target_window = touch.view_window = window


def carry_target(touch: Touch, placement: Placement) -> None:
    """Bring the Empty to where the hand is, after a mode or momentum has moved the window."""
    window = touch.session.window
    if live.rendering or touch.mouse is not None or is_same(window, touch.target_window) or is_dragging():
        return
    place = _meant(touch, placement)
    touch.target_window = window
    empty = touch.target.find() if touch.target is not None else None
    if place is not None and empty is not None:
        there = from_workspace(place, window, touch.workspace[0])
        place_target(empty, placement.to_scene(*there))


def follow_target(touch: Touch, placement: Placement) -> None:
    """Pull the simulated hand to where the mouse or the Empty wants it; where nothing does, it stays.

    Raises:
        SessionError: too many commands wait already.
    """
    place = _meant(touch, placement)
    if place is None:
        return
    if touch.has_modes:  # walls are no match for an arm that is pulled through them
        place = within_reach(place, touch.workspace)
    touch.session.set_target(*place)


def _meant(touch: Touch, placement: Placement) -> Point | None:
    """Workspace metres where the hand is to be; ``None`` where nothing says."""
    if touch.mouse is not None:
        return touch.mouse.pulled
    empty = touch.target.find() if touch.target is not None else None
    place = target_place(empty, placement, touch.grid.layout) if empty is not None else None
    if place is None:
        return None
    window = touch.target_window
    east = nearest_turn(place[0], window.east, touch.frame.turn)
    return to_workspace((east, *place[1:]), window, touch.workspace[0])
