"""The stylus button and the handle's turn, for whoever holds no stylus."""

from __future__ import annotations

import math

from .live import Touch


def press(touch: Touch) -> None:
    """Press the button: in contact it grabs the ground, in the air it grabs the air.

    Raises:
        SessionError: touch has no modes, or too many commands wait already.
    """
    touch.session.press()
    touch.is_pressed = True


def release(touch: Touch) -> None:
    """Let the button go.

    Raises:
        SessionError: touch has no modes, or too many commands wait already.
    """
    touch.session.release()
    touch.is_pressed = False


def twist(touch: Touch, degrees: float) -> None:
    """Turn the simulated handle on, counter-clockwise seen from above.

    Raises:
        ValueError: that is no number.
        SessionError: too many commands wait already.
    """
    turn_handle(touch, math.radians(degrees))


def turn_handle(touch: Touch, radians: float) -> None:
    """The same in radians.

    Raises:
        ValueError: that is no number.
        SessionError: too many commands wait already.
    """
    twisted = touch.twist + radians
    touch.session.set_twist(twisted)
    touch.twist = twisted
