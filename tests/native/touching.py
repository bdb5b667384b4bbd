"""Sessions on small grounds, and waiting for what happens in them."""

from __future__ import annotations

import time
from collections.abc import Callable

from proxygraph import Grid, PlaybackDevice, ScriptedDevice, Session, SimulatedDevice, Ticks, Window

from tests.native.grounds import SIDE

SCALE = 0.01
"""Workspace metres for a metre of ground."""


def over_the_middle() -> Window:
    """A window in which 16 cm of workspace are 16 m of ground."""
    return Window(SIDE / 2, -SIDE / 2, 0.0, width=0.16 / SCALE)


def touch(
    grid: Grid,
    device: ScriptedDevice | SimulatedDevice | PlaybackDevice,
    **settings: float | str | bool | None,
) -> Session:
    """A session over the middle of the ground."""
    return Session(grid, device, over_the_middle(), **settings)  # type: ignore[arg-type]


def pressing(depth: float = 0.01) -> ScriptedDevice:
    """From 2 cm above the middle straight down to ``depth`` (workspace metres) under height 0."""
    return ScriptedDevice([(0.0, 0.003, 0.001, 0.02), (0.02, 0.003, 0.001, -depth)])


def wandering() -> ScriptedDevice:
    """In and out of the hills, along a zigzag."""
    return ScriptedDevice(
        [
            (0.1 * turn, 0.06 * (-1) ** turn, 0.01 * turn - 0.05, 0.02 * (-1) ** (turn // 2))
            for turn in range(10)
        ]
    )


def rows(ticks: Ticks) -> list[tuple[float, ...]]:
    """All columns of all ticks."""
    return list(zip(*(ticks.column(name).tolist() for name in ticks.columns), strict=True))


def wait_until(happened: Callable[[], bool]) -> None:
    """Give a live session all the time that a busy machine may need."""
    end = time.monotonic() + 60.0
    while not happened():
        assert time.monotonic() < end, "it did not happen within a minute"
        time.sleep(0.001)
