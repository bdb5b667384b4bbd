"""Takes that tests make up, without a hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from tests.addon.scene import module

Numbers = npt.NDArray[np.float64]

ROWS, COLUMNS, CELL = 180, 360, 1000.0


def georeference(**options: Any) -> Any:
    """Place a planet of one sample a degree, longitude 0 in the west."""
    formats = module("formats")
    ellipsoid = module("formats.body.ellipsoid").Ellipsoid
    kept = {
        "body": "Mars",
        "ellipsoid": ellipsoid.sphere(3396000.0),
        "projection": module("formats.projections").Geographic(),
        "first_x": 0.5,
        "first_y": 89.5,
        "step_x": 1.0,
        "step_y": 1.0,
        "vertical_reference": "areoid",
    }
    return formats.Georeference(**{**kept, **options})


def about(**options: Any) -> Any:
    """Say what a made-up take was felt on."""
    of_it = module("record.take_data").TakeAbout(
        terrain="Mars",
        source="mars.img",
        rows=ROWS,
        columns=COLUMNS,
        cell_width=CELL,
        cell_height=CELL,
        wraps=True,
        georeference=georeference(),
        workspace_width=0.16,
        models=("surface_walk",),
        digest="00ff",
    )
    return replace(of_it, **options)


def take(count: int = 100, *, of: Any = None, **columns: Numbers) -> Any:
    """Make a take of a hand that goes east over the equator; columns may be replaced."""
    ticks = np.arange(count)
    random = np.random.default_rng(7)
    made = {
        "time": 12.0 + ticks / 1000.0,
        "hand_x": random.normal(size=count),
        "goal_east": 1e5 + 10.0 * ticks,
        "goal_north": np.full(count, -9e4),
        "goal_up": np.full(count, -500.0),
        "proxy_east": 1e5 + 10.0 * ticks,
        "proxy_north": np.full(count, -9e4),
        "proxy_up": 1000.0 * random.normal(size=count),
        "force_x": random.normal(size=count),
        "force_y": random.normal(size=count) * 1e-300,
        "force_z": random.normal(size=count),
        "feature": (ticks % 4).astype(float),
        "mode": (ticks % 3).astype(float),
        "window_width": np.full(count, 1e6),
        "window_exaggeration": np.full(count, 20.0),
    }
    return module("record.take_data").TakeData({**made, **columns}, about() if of is None else of)


def same(one: Any, other: Any) -> bool:
    """Whether two takes are the same to the last bit."""
    alike = all(
        np.array_equal(values, other.columns[name], equal_nan=True) for name, values in one.columns.items()
    )
    return alike and set(one.columns) == set(other.columns) and one.about == other.about
