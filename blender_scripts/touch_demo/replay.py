"""The hand's path once more, stepped through two contact models side by side.

No tick is missed here, so both models get the same goals, and the counts are the same on every machine.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from proxygraph import Grid, ScriptedDevice, Session, Statistics, Window

from touch_demo.counts import Counts
from touch_demo.hand_path import HandPath

MODELS = ("surface_walk", "proxy_graph")
"""Ours, and the paper's."""

TURN = 100
"""Ticks until it is the other model's turn: what else the machine does meanwhile meets both."""

TICKS_PER_SECOND = 1000


@dataclass
class Replay:
    """What one model did on the path."""

    statistics: Statistics
    swipes: Counts


@dataclass(frozen=True)
class Part:
    """Some ticks of the path."""

    ticks: int
    is_swipe: bool
    window: int
    """Its number."""


def replay(
    grid: Grid, path: HandPath, windows: list[Window], workspace: tuple[float, float, float]
) -> dict[str, Replay]:
    """Step every model along the path, by name."""
    sessions = {
        name: Session(
            grid,
            ScriptedDevice(path.points, workspace=workspace),
            windows[0],
            ring_seconds=1.0 / TICKS_PER_SECOND,  # counts are all that is looked at
            model=name,
        )
        for name in MODELS
    }
    swipes = {name: Counts() for name in MODELS}
    for part in parts(path):
        before = {name: session.statistics() for name, session in sessions.items()}
        for session in sessions.values():
            session.set_window(windows[part.window])
        _in_turns(list(sessions.values()), part.ticks)
        if part.is_swipe:
            for name, session in sessions.items():
                swipes[name].add(before[name], session.statistics())
    return {name: Replay(session.statistics(), swipes[name]) for name, session in sessions.items()}


def parts(path: HandPath) -> Iterator[Part]:
    """Cut the path where swipes begin and end, and where the window is moved."""
    edges = [*(_tick(moment) for swipe in path.swipes for moment in swipe), _tick(path.explore_at)]
    done = 0
    for number, edge in enumerate(edges):
        yield Part(edge - done, is_swipe=number % 2 == 1, window=0)
        done = edge
    yield Part(_tick(path.seconds) - done, is_swipe=False, window=1)


def _tick(seconds: float) -> int:
    return round(seconds * TICKS_PER_SECOND)


def _in_turns(sessions: list[Session], ticks: int) -> None:
    while ticks > 0:
        turn = min(ticks, TURN)
        for session in sessions:
            session.step(turn)
        sessions.reverse()
        ticks -= turn
