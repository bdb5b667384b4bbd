"""The contact of a path of goals, without a servo; without Blender.

No safety stands between goal and proxy here: nothing ramps in, no speed is too high, and the force is that of
the spring as a hand at rest would feel it, up to the largest.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass

import numpy as np
from proxygraph import ContactModel, Grid, Window

from .take_data import Numbers

STIFFNESS = 500.0
"""Newtons a metre of the hand's motion: the servo's own, where a device does not limit it."""

PIECE = 10_000
"""Goals that are followed at once: some milliseconds, after which a person can cancel."""

MOST_BEGINNINGS = 1_000
"""Updates until the proxy has come to the first goal; one is enough for all but the smallest step budgets."""

COUNTS = ("feature", "vertices", "faces", "collision_tests", "cells")

FOUND = ("proxy_east", "proxy_north", "proxy_up", "spring_x", "spring_y", "spring_z", *COUNTS)
"""Columns of ``Contacts``."""


@dataclass(frozen=True)
class Answer:
    """What answers the goals, and on what scale."""

    grid: Grid
    highest: float
    """Metres, of the whole grid."""
    window: Window
    workspace_width: float
    """Of the device, metres."""
    model: str
    sub_step: float | None = None
    radius: float | None = None
    """As ``ContactModel`` takes them."""
    max_force: float = np.inf
    """Newtons."""

    @property
    def scale(self) -> float:
        """Workspace metres for a metre of terrain."""
        return self.workspace_width / self.window.width


def felt(answer: Answer, times: Numbers, goals: Numbers) -> Generator[float, None, dict[str, Numbers]]:
    """Follow the goals, telling the share that is done; gives the columns of ``Ticks``.

    Args:
        times: seconds, n.
        goals: terrain metres east, north and up, n x 3; the first is come to from above.

    Raises:
        ValueError: the model or a knob cannot be used.
    """
    model = contact_model(answer, goals[0])
    found = {name: np.empty(len(goals)) for name in FOUND}
    for first in range(0, len(goals), PIECE):
        piece = slice(first, first + PIECE)
        contacts = model.follow(np.ascontiguousarray(goals[piece]))
        for name, column in found.items():
            column[piece] = np.frombuffer(contacts.column(name))
        yield min(1.0, (first + PIECE) / len(goals))
    return _columns(answer, times, goals, found)


def contact_model(answer: Answer, goal: Numbers) -> ContactModel:
    """Make the model, its proxy at the first goal, or above it on the ground.

    Raises:
        ValueError: the model or a knob cannot be used.
    """
    model = ContactModel(
        answer.grid,
        answer.model,
        scale=answer.scale,
        exaggeration=answer.window.exaggeration,
        sub_step=answer.sub_step,
        radius=answer.radius,
    )
    east, north, up = goal.tolist()
    # A proxy that is placed inside the ground stays there; this one comes from above, whatever its radius.
    clear = answer.grid.layout.cell_width + (model.radius or 0.0) / answer.scale / answer.window.exaggeration
    model.place(east, north, max(up, answer.highest + clear))
    for _ in range(MOST_BEGINNINGS):
        if not model.update(east, north, up).steps_left:
            break
    return model


def _columns(answer: Answer, times: Numbers, goals: Numbers, found: dict[str, Numbers]) -> dict[str, Numbers]:
    """Name everything as the servo does. The window is never turned here."""
    window = answer.window
    columns = {"tick": np.arange(len(times), dtype=np.float64), "time": times}
    stretch = (1.0, 1.0, window.exaggeration)
    for number, axis in enumerate(("east", "north", "up")):
        middle = getattr(window, axis)
        columns[f"hand_{'xyz'[number]}"] = (goals[:, number] - middle) * answer.scale * stretch[number]
        columns[f"goal_{axis}"] = goals[:, number].copy()
        columns[f"proxy_{axis}"] = found[f"proxy_{axis}"]
        columns[f"window_{axis}"] = np.full(len(times), middle)
    columns |= _forces(answer, found)
    columns |= {name: found[name] for name in COUNTS}
    columns["mode"] = np.zeros(len(times))
    for name in ("width", "exaggeration", "turn"):
        columns[f"window_{name}"] = np.full(len(times), getattr(window, name))
    return columns


def _forces(answer: Answer, found: dict[str, Numbers]) -> dict[str, Numbers]:
    """Newtons: of the spring while there is contact, never above the largest."""
    in_contact = found["feature"] != 0.0
    x, y, z = (np.where(in_contact, STIFFNESS * found[f"spring_{axis}"], 0.0) for axis in "xyz")
    length = np.sqrt(x * x + y * y + z * z)
    kept = np.where(length > answer.max_force, answer.max_force / np.where(length > 0.0, length, 1.0), 1.0)
    return {"force_x": x * kept, "force_y": y * kept, "force_z": z * kept}
