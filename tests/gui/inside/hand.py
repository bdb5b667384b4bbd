"""Keys and mouse, simulated: Blender's own events drive modal operators and keymaps as real ones do."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tests.gui.inside.blender import Blender

from tests.gui.inside.script import Script

BETWEEN_EVENTS = 0.05
"""Seconds: Blender handles an event, and draws, before the next one comes."""

DIGITS = ("ZERO", "ONE", "TWO", "THREE", "FOUR", "FIVE", "SIX", "SEVEN", "EIGHT", "NINE")

TYPED = {" ": "SPACE", "-": "MINUS", ".": "PERIOD", **{str(n): name for n, name in enumerate(DIGITS)}}
"""Blender's names of keys that are not letters."""


class Hand:
    """On keyboard and mouse; places are pixels of the window from its lower left."""

    def __init__(self, blender: Blender) -> None:
        self._blender = blender
        self.place = (0, 0)

    def move(self, x: float, y: float) -> Script[None]:
        """Move the mouse."""
        self.place = (round(x), round(y))
        self._event("MOUSEMOVE", "NOTHING")
        yield BETWEEN_EVENTS

    def drag(self, x: float, y: float, *, steps: int = 10) -> Script[None]:
        """Move the mouse evenly, as a hand does, to a place."""
        from_x, from_y = self.place
        for step in range(1, steps + 1):
            share = step / steps
            yield from self.move(from_x + share * (x - from_x), from_y + share * (y - from_y))

    def over_view(self) -> Script[None]:
        """Put the mouse over the middle of the 3D view, where keys mean what they mean there."""
        region = self._blender.region()
        yield from self.move(region.x + region.width // 2, region.y + region.height // 2)

    def tap(self, key: str, *, shift: bool = False, ctrl: bool = False) -> Script[None]:
        """Press a key or a mouse button, and let it go."""
        yield from self.press(key, shift=shift, ctrl=ctrl)
        yield from self.release(key, shift=shift, ctrl=ctrl)

    def press(self, key: str, *, shift: bool = False, ctrl: bool = False) -> Script[None]:
        """Press a key or a mouse button."""
        self._event(key, "PRESS", shift=shift, ctrl=ctrl)
        yield BETWEEN_EVENTS

    def release(self, key: str, *, shift: bool = False, ctrl: bool = False) -> Script[None]:
        """Let it go."""
        self._event(key, "RELEASE", shift=shift, ctrl=ctrl)
        yield BETWEEN_EVENTS

    def type(self, text: str) -> Script[None]:
        """Type letters, digits and spaces."""
        for letter in text:
            key = TYPED.get(letter, letter.upper())
            self._event(key, "PRESS", unicode=letter)
            yield BETWEEN_EVENTS
            yield from self.release(key)

    def _event(
        self, kind: str, value: str, *, shift: bool = False, ctrl: bool = False, unicode: str | None = None
    ) -> None:
        x, y = self.place
        options: dict[str, Any] = {"x": x, "y": y, "shift": shift, "ctrl": ctrl}
        if unicode is not None:
            options["unicode"] = unicode
        self._blender.window.event_simulate(type=kind, value=value, **options)  # type: ignore[arg-type]
