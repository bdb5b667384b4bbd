"""Every tick of a take, as the servo gave them; without Blender."""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field

from proxygraph import Ticks

COLUMNS = (
    "time",
    "hand_x",
    "hand_y",
    "hand_z",
    "goal_east",
    "goal_north",
    "goal_up",
    "proxy_east",
    "proxy_north",
    "proxy_up",
    "force_x",
    "force_y",
    "force_z",
    "feature",
    "mode",
    "window_east",
    "window_north",
    "window_up",
    "window_width",
    "window_exaggeration",
    "window_turn",
)
"""Of ``Ticks``, 168 bytes a tick: 10 MB a minute."""


@dataclass
class Recorder:
    """Ticks in the order in which they were felt."""

    columns: dict[str, array[float]] = field(default_factory=lambda: {name: array("d") for name in COLUMNS})

    def __len__(self) -> int:
        return len(self.columns["time"])

    @property
    def seconds(self) -> float:
        """From the first tick to the last."""
        time = self.columns["time"]
        return time[-1] - time[0] if time else 0.0

    def add(self, ticks: Ticks) -> None:
        """Append what was drained."""
        for name, values in self.columns.items():
            values.frombytes(ticks.column(name).tobytes())
