"""What a tick costs: the servo's own loop, stepped, with a scripted hand."""

from __future__ import annotations

import random
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from proxygraph import ScriptedDevice, Session, Window

from tests.bench.grounds import Ground
from tests.bench.hand import Field, Height, Place, above, wander

SPEEDS = (0.3, 1.0, 3.4, 13.4, 50.0)
BLOCKS = 30
TICKS = 1000
"""Ticks in a block."""

HAND = 0.001
"""Workspace metres for a cell."""

WORKSPACE = (0.16, 0.12, 0.12)

Script = Callable[[Field, Height, float, int, int], Iterator[Place]]


@dataclass
class Contender:
    """One path at one speed, measured block by block."""

    session: Session
    touches: bool
    exaggeration: int
    speed: float
    nanoseconds: list[float] = field(default_factory=list)

    def run_block(self) -> None:
        """The next block of the path; the ring is emptied outside the measured time."""
        begin = time.perf_counter_ns()
        self.session.step(TICKS)
        self.nanoseconds.append((time.perf_counter_ns() - begin) / TICKS)
        self.session.drain()

    @property
    def median(self) -> float:
        """Nanoseconds for a tick; the first block warms up and does not count."""
        return statistics.median(self.nanoseconds[1:])

    @property
    def spread(self) -> float:
        """Half the way between the quartiles, as a share of the median."""
        low, _, high = statistics.quantiles(self.nanoseconds[1:], n=4)
        return (high - low) / 2.0 / self.median


def contender(ground: Ground, exaggeration: int, speed: float, *, touches: bool) -> Contender:
    """A session whose scripted hand wanders, in contact or ten cells above."""
    layout = ground.grid.layout
    script: Script = wander if touches else above
    row = layout.cell_height / layout.cell_width
    places = script(ground.field, ground.oracle(exaggeration).height, speed, BLOCKS * TICKS, int(100 * speed))
    path = [
        (tick / 1000.0, HAND * columns, -HAND * row * rows, HAND * height)
        for tick, (columns, rows, height) in enumerate(places, start=1)
    ]
    width = WORKSPACE[0] / HAND * layout.cell_width
    window = Window(0.0, 0.0, 0.0, width=width, exaggeration=exaggeration)
    device = ScriptedDevice(path, workspace=WORKSPACE)
    session = Session(ground.grid, device, window, ring_seconds=TICKS / 1000.0, model="proxy_graph")
    return Contender(session, touches, exaggeration, speed)


def measure(ground: Ground) -> list[Contender]:
    """All contenders in one process, their blocks shuffled: none always inherits the same one's cache."""
    contenders = [contender(ground, 1, speed, touches=False) for speed in SPEEDS]
    for exaggeration in ground.exaggerations:
        contenders += [contender(ground, exaggeration, speed, touches=True) for speed in SPEEDS]
    turns = contenders * BLOCKS
    random.Random(7).shuffle(turns)
    for turn in turns:
        turn.run_block()
    return contenders
