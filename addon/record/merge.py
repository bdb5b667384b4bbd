"""One take put into another; without Blender."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .about_properties import check_same_terrain
from .take_data import TakeData


def merged(old: TakeData, new: TakeData, later: float) -> TakeData:
    """Put a take into an older one: it replaces what that has between its own first and last tick.

    Args:
        later: seconds from the older one's first tick to the new one's; below 0 where it begins before.

    Raises:
        OtherTerrainError: they were felt on different terrains.
    """
    check_same_terrain(new.about, old.about)
    times = old.columns["time"]
    moved = new.columns["time"] - new.columns["time"][0] + times[0] + later
    before, after = times < moved[0], times > moved[-1]
    shared = [name for name in old.columns if name in new.columns]
    columns = {
        name: np.concatenate(
            (
                old.columns[name][before],
                moved if name == "time" else new.columns[name],
                old.columns[name][after],
            )
        )
        for name in shared
    }
    models = tuple(dict.fromkeys((*old.about.models, *new.about.models)))
    lost = old.about.lost_ticks + new.about.lost_ticks
    return TakeData(columns, replace(old.about, models=models, lost_ticks=lost))
