"""Plays a scenario: a generator that yields what to wait for; Blender draws and takes events meanwhile."""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

import bpy

if TYPE_CHECKING:
    from tests.gui.inside.blender import Blender

T = TypeVar("T")

LOOK = 0.02
"""Seconds between two looks at what is waited for."""

BEGIN = 1.0
"""Seconds after which Blender has drawn its first picture."""


@dataclass(frozen=True)
class Until:
    """Wait for something that must come."""

    what: str
    """For the message where it does not: a sentence's end, as in "the terrain was imported"."""
    is_so: Callable[[], object]
    seconds: float = 120.0
    every: float = LOOK


Script = Generator[float | Until, None, T]
"""Yields seconds to wait, or what to wait for; ``yield from`` gives what it returns."""

Scenario = Callable[["Blender"], Script[None]]


class Failed(Exception):  # noqa: N818
    """Something that a person would see is not as it should be; the text says what."""


def check(is_so: object, otherwise: str) -> None:
    """Fail with a sentence."""
    if not is_so:
        raise Failed(otherwise)


def play(scenario: Scenario, blender: Blender) -> None:
    """Begin; at the end, or at the first failure, the outcome is written and Blender quits."""
    player = _Player(scenario(blender), blender)
    bpy.app.timers.register(player.go_on, first_interval=BEGIN, persistent=True)


class _Player:
    def __init__(self, script: Script[None], blender: Blender) -> None:
        self._script = script
        self._blender = blender
        self._wait: Until | None = None
        self._end = 0.0

    def go_on(self) -> float | None:
        """Do the next step when what was waited for has come; gives the seconds until the next look."""
        try:
            if self._wait is not None and not self._wait.is_so():
                if time.monotonic() < self._end:
                    return self._wait.every
                raise Failed(f"waited {self._wait.seconds:g} s in vain until {self._wait.what}")
            wait = next(self._script)
        except StopIteration:
            self._blender.quit(None)
            return None
        except Exception as error:
            self._blender.quit(_told(error))
            return None
        if isinstance(wait, Until):
            self._wait, self._end = wait, time.monotonic() + wait.seconds
            return LOOK
        self._wait = None
        return wait


def _told(error: Exception) -> str:
    """Say where in the scenario it went wrong."""
    steps = [step for step in traceback.extract_tb(error.__traceback__) if "scenarios" in step.filename]
    where = f" (line {steps[-1].lineno}: {steps[-1].line})" if steps else ""
    kind = "" if isinstance(error, Failed) else f"{type(error).__name__}: "
    return f"{kind}{error}{where}"
