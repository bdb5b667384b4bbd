"""The mouse takes the simulated hand from the Empty, and gives it back."""

from __future__ import annotations

from contextlib import suppress

from proxygraph import SessionError, State

from ..terrain.frame import Point
from .live import Touch, live
from .mouse_hand import MouseHand
from .placement import Placement
from .stylus import press, release, turn_handle
from .target import place_target
from .workspace import from_workspace, to_workspace

BEGINNING = (0.0, 0.0, 0.005)
"""Workspace metres where a hand begins that no Empty leads: in the middle, a little above the ground."""


def take_hand(touch: Touch, place: Point | None = None) -> MouseHand:
    """Let the mouse lead the hand.

    Args:
        place: where it is, workspace metres, in a session that has not ticked yet; others know.
    """
    state = touch.session.state()
    here = place or state.hand
    touch.mouse = MouseHand(goal=here, pulled=here, pulled_at=state.time, heard_at=state.time)
    return touch.mouse


def give_back_hand(touch: Touch) -> None:
    """Let the Empty lead again: it is brought to the hand, so that the hand stays."""
    let_go(touch)
    touch.mouse = None
    empty = touch.target.find() if touch.target is not None else None
    terrain = touch.terrain.find()
    if empty is None or terrain is None or live.rendering:
        return
    window = touch.session.window
    placement = Placement.of(terrain, touch.frame)
    if placement.is_usable:
        there = from_workspace(touch.session.state().hand, window, touch.workspace[0])
        place_target(empty, placement.to_scene(*there))
        touch.target_window = window


def keep_mouse(touch: Touch, state: State) -> None:
    """Lead the hand on to where the mouse wants it.

    Raises:
        SessionError: too many commands wait already.
    """
    mouse = touch.mouse
    if mouse is None:
        return
    if mouse.lets_go:
        let_go(touch)
    mouse.keep_within(touch.workspace, _ground(touch, mouse))
    turned = mouse.come(state.time)
    if turned:
        turn_handle(touch, turned)


def grab(touch: Touch) -> None:
    """Press the stylus button for the mouse, unless it is down already.

    Raises:
        SessionError: too many commands wait already.
    """
    if touch.mouse is not None and not touch.is_pressed:
        press(touch)
        touch.mouse.holds_button, touch.mouse.lets_go = True, False


def let_go(touch: Touch) -> None:
    """Release the stylus button, where the mouse has pressed it; a servo that is busy is told again later."""
    mouse = touch.mouse
    if mouse is None or not mouse.holds_button:
        return
    mouse.lets_go = True
    with suppress(SessionError):
        if touch.is_pressed:  # nobody else has released it
            release(touch)
        mouse.holds_button = mouse.lets_go = False


def _ground(touch: Touch, mouse: MouseHand) -> float | None:
    """Workspace metres up where the ground is under the goal."""
    window, width = touch.session.window, touch.workspace[0]
    east, north, _up = from_workspace(mouse.goal, window, width)
    up = touch.grid.elevation_at(touch.frame.on_map(east), north)
    return None if up is None else to_workspace((east, north, up), window, width)[2]
