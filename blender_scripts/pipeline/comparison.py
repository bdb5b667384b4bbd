"""The same goals through several contact models."""

from __future__ import annotations

import random
import statistics
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]

BLOCK = 500
"""Goals that a model follows before it is another's turn: what else the machine does then meets all."""

COUNTS = ("vertices", "faces", "collision_tests", "cells")

WORD = 20
"""Letters of a column of the table."""


@dataclass
class Followed:
    """What a model did."""

    columns: dict[str, Numbers]
    """Of ``Contacts``, one value an update."""
    microseconds: float
    """Of an update: the median of the blocks' means."""


def follow_all(contact: ModuleType, answer: Any, names: Sequence[str], goals: Numbers) -> dict[str, Followed]:
    """Let every model follow the goals, in turns and in an order that is shuffled each time.

    Args:
        contact: the extension's ``record.bake_contact``.
        answer: its ``Answer``; the model in it is replaced.
    """
    models = {name: contact.contact_model(_with_model(answer, name), goals[0]) for name in names}
    found: dict[str, list[Any]] = {name: [] for name in names}
    times: dict[str, list[float]] = {name: [] for name in names}
    order, shuffle = list(names), random.Random(0)
    for first in range(0, len(goals), BLOCK):
        block = np.ascontiguousarray(goals[first : first + BLOCK])
        shuffle.shuffle(order)
        for name in order:
            began = time.perf_counter()
            found[name].append(models[name].follow(block))
            times[name].append((time.perf_counter() - began) / len(block))
    return {name: Followed(_joined(found[name]), 1e6 * statistics.median(times[name])) for name in names}


def figures(followed: Mapping[str, Followed], stretch: Numbers) -> dict[str, Any]:
    """What tells the models apart.

    Args:
        stretch: millimetres of the hand's motion for a metre of terrain, for each axis.
    """
    first = next(iter(followed.values()))
    models = {
        name: {
            "microseconds_per_update": round(found.microseconds, 4),
            "time_ratio": round(found.microseconds / first.microseconds, 3),
            "in_contact_share": float(np.mean(found.columns["feature"] != 0.0)),
            **{f"{count}_per_update": float(np.mean(found.columns[count])) for count in COUNTS},
            "updates_with_steps_left": int(np.count_nonzero(found.columns["steps_left"])),
        }
        for name, found in followed.items()
    }
    distances = {
        f"{one}, {other}": _distances(followed[one], followed[other], stretch)
        for one, other in combinations(followed, 2)
    }
    return {"models": models, "proxies_apart_millimetres": distances}


def table(found: Mapping[str, Any]) -> str:
    """The figures for people."""
    models = found["models"]
    lines = [
        "".join(
            word.ljust(WORD)
            for word in ("model", "us an update", "of the first's", "in contact", "looked at")
        )
    ]
    for name, model in models.items():
        looked = model["vertices_per_update"] + model["faces_per_update"]
        cells = (
            name,
            f"{model['microseconds_per_update']:.3f}",
            f"x {model['time_ratio']:.2f}",
            f"{model['in_contact_share']:.1%}",
            f"{looked:.2f}",
        )
        lines.append("".join(cell.ljust(WORD) for cell in cells))
    lines.append("")
    lines.append(
        "".join(word.ljust(WORD) for word in ("apart, mm of hand", "mean", "99%", "most")) + "between"
    )
    for pair, apart in found["proxies_apart_millimetres"].items():
        numbers = (f"{apart[key]:.4f}" for key in ("mean", "p99", "max"))
        lines.append("".ljust(WORD) + "".join(number.ljust(WORD) for number in numbers) + pair)
    return "\n".join(lines)


def _with_model(answer: Any, name: str) -> Any:
    chosen = name == answer.model
    return replace(
        answer,
        model=name,
        sub_step=answer.sub_step if chosen else None,
        radius=(answer.radius or 0.001) if name == "virtual_proxy" else None,
    )


def _joined(pieces: Sequence[Any]) -> dict[str, Numbers]:
    names = pieces[0].columns
    return {name: np.concatenate([np.frombuffer(piece.column(name)) for piece in pieces]) for name in names}


def _distances(one: Followed, other: Followed, stretch: Numbers) -> dict[str, float]:
    apart = np.stack(
        [one.columns[name] - other.columns[name] for name in ("proxy_east", "proxy_north", "proxy_up")],
        axis=1,
    )
    lengths = np.linalg.norm(apart * stretch, axis=1)
    return {
        "mean": float(lengths.mean()),
        "p99": float(np.percentile(lengths, 99.0)),
        "max": float(lengths.max()),
    }
