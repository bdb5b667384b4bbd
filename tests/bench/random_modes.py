"""Modes changed at random by a hand that wanders through the ground and the walls: what the force and the
momentum make of it, through the module that the wheel ships, in stepped time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from proxygraph import Grid, GridLayout, ScriptedDevice, Session, Ticks, Window

Numbers = npt.NDArray[np.float64]

TICK = 1e-3
"""Seconds."""

WORKSPACE = (0.16, 0.12, 0.12)
"""Metres."""

WALL = 0.9 / 2.0
"""Where walls begin, of the workspace's width and depth."""

PAN_MASS = 0.2
"""Kilograms of the ground that is pushed, as by default."""

SIDE = 64
"""Samples along a side of the ground, a metre apart."""

BETWEEN_AIMS, BETWEEN_BUTTONS = 0.15, 0.025
"""Seconds, mean."""

SECONDS = 20.0
"""That each hand wanders; the session's ring holds three times as much."""


@dataclass
class Figures:
    """What a run came to."""

    force_step: float = 0.0
    """The largest step of the force in a tick, of what the slew limit lets it be."""
    energy_gain: float = -np.inf
    """Joules that a drift had, at the most, beyond what it was let go with."""
    mode_changes: int = 0
    zooms: int = 0
    """Ticks that changed the window's width."""
    wall_touches: int = 0
    drift_ticks: int = 0
    contact_ticks: int = 0


def wander(changes: int, *, seed: int = 7) -> Figures:
    """Let one hand after another wander until the mode has changed so often.

    Each begins over the middle of the ground: in time, pans lead beyond the map's edge.
    """
    figures = Figures()
    while figures.mode_changes < changes:
        _wander_once(figures, np.random.default_rng(seed))
        seed += 1
    return figures


def _wander_once(figures: Figures, random: np.random.Generator) -> None:
    session = Session(
        _hills(),
        _wandering_hand(SECONDS, random),
        Window(SIDE / 2, -SIDE / 2, 0.0, width=16.0),
        walls=True,
        modes=True,
    )
    session.step(round(SECONDS / TICK))
    drained = session.drain()
    rows = np.column_stack([np.asarray(drained.column(name)) for name in Ticks.columns])
    if not np.isfinite(rows).all():
        raise ArithmeticError("a tick told something that is no number")
    _look(figures, rows, session.max_slew * TICK)
    figures.mode_changes += session.statistics().mode_changes


def _look(figures: Figures, rows: Numbers, longest_step: float) -> None:
    """Take differences from tick to tick."""
    ticks = {name: rows[:, number] for number, name in enumerate(Ticks.columns)}
    force = np.column_stack([ticks[f"force_{axis}"] for axis in "xyz"])
    steps = np.linalg.norm(np.diff(force, axis=0), axis=1)
    figures.force_step = max(figures.force_step, float(steps.max()) / longest_step)
    zooms = np.diff(ticks["window_width"]) != 0.0
    figures.zooms += int(zooms.sum())
    at_wall = (np.abs(ticks["hand_x"]) > WALL * WORKSPACE[0]) | (
        np.abs(ticks["hand_y"]) > WALL * WORKSPACE[1]
    )
    figures.wall_touches += int((at_wall[1:] & ~at_wall[:-1]).sum())
    figures.contact_ticks += int(((ticks["mode"] == 0.0) & (ticks["feature"] != 0.0)).sum())
    _look_at_drift(figures, ticks, zooms)


def _look_at_drift(figures: Figures, ticks: dict[str, Numbers], zooms: npt.NDArray[np.bool_]) -> None:
    """Compare the energy of a drift with that which the ground was let go with."""
    way = np.hypot(np.diff(ticks["window_east"]), np.diff(ticks["window_north"]))
    speed = way * WORKSPACE[0] / ticks["window_width"][1:] / TICK
    mode = ticks["mode"]
    energies = np.where((mode[1:] == 2.0) | zooms, 0.0, 0.5 * PAN_MASS * speed**2)
    drifts = (mode[1:] == 0.0) & (mode[:-1] == 0.0)
    let_go_with = 0.0
    for energy, drifting in zip(energies.tolist(), drifts.tolist(), strict=True):
        if not drifting:
            let_go_with = energy
            continue
        if energy > 0.0:
            figures.drift_ticks += 1
            # What differences of a window's metres round.
            rounding = 1e-9 * let_go_with + 1e-15
            figures.energy_gain = max(figures.energy_gain, energy - let_go_with - rounding)


def _hills() -> Grid:
    """Waves with noise on them, up to 70 cm."""
    _rows, columns = np.mgrid[0:SIDE, 0:SIDE]
    heights = 0.3 * np.sin(0.7 * columns) + np.random.default_rng(1).uniform(0.0, 0.4, (SIDE, SIDE))
    layout = GridLayout(SIDE, SIDE, cell_width=1.0, cell_height=1.0, sample="f64", byte_order="little")
    return Grid.from_buffer(heights.astype("<f8").tobytes(), layout)


def _wandering_hand(seconds: float, random: np.random.Generator) -> ScriptedDevice:
    """Head for one place after another, in and above the ground and beyond the walls, with up to 0.6 m/s."""
    legs = np.cumsum(random.exponential(BETWEEN_AIMS, round(seconds / BETWEEN_AIMS)) + TICK)
    times = np.concatenate([[0.0], legs])
    places = [np.array([0.0, 0.0, 0.02])]
    for duration in np.diff(times):
        way = random.uniform((-0.09, -0.07, -0.02), (0.09, 0.07, 0.03)) - places[-1]
        reach = random.uniform(0.0, 0.6) * duration / np.linalg.norm(way)
        places.append(places[-1] + min(reach, 1.0) * way)
    turns = np.concatenate([[0.0], np.cumsum(random.uniform(-6.0, 6.0, len(legs)) * np.diff(times))])
    presses = np.cumsum(random.exponential(BETWEEN_BUTTONS, round(seconds / BETWEEN_BUTTONS)) + TICK)
    moments = np.union1d(times, presses)
    down = np.searchsorted(presses, moments, side="right") % 2
    handle = zip(moments.tolist(), np.interp(moments, times, turns).tolist(), down.tolist(), strict=True)
    path = [(moment, *place.tolist()) for moment, place in zip(times.tolist(), places, strict=True)]
    return ScriptedDevice(path, workspace=WORKSPACE, handle=list(handle))
