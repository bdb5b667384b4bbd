"""A take: every tick that was felt, and what it was felt on; without Blender.

Live recordings, files that were read back, playback and baking all end in this form, so that the same
writers make animation and files of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..formats import Georeference

if TYPE_CHECKING:
    from collections.abc import Buffer

Numbers = npt.NDArray[np.float64]

NEEDED = (
    "time",
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
    "window_width",
    "window_exaggeration",
)
"""Columns that every take has; more of ``Ticks.columns`` may come with them, and are kept as they are."""

MODES = ("normal", "pan", "zoom")
"""What the numbers in the column ``mode`` mean, in their order."""

RATE = 1000.0
"""Hertz, of the servo."""


@dataclass(frozen=True)
class TakeAbout:
    """What a take was felt on, and with what."""

    terrain: str
    """Name of the terrain object."""
    source: str
    """Name of the file with the samples, without its folders."""
    rows: int
    columns: int
    cell_width: float
    cell_height: float
    """Metres."""
    wraps: bool
    """Whether east runs on around the planet."""
    georeference: Georeference
    workspace_width: float
    """Of the device, metres: with the column ``window_width`` it gives the scale from hand to terrain."""
    models: tuple[str, ...] = ()
    """Contact models that answered, in their order."""
    rate: float = RATE
    """Ticks a second."""
    lost_ticks: int = 0
    """That were felt and are not in the columns."""
    digest: str = ""
    """Of the samples' file, as ``SourceStamp`` has it; empty where it is not known."""

    @property
    def turn(self) -> float | None:
        """Terrain metres once around the planet; ``None`` on a map with edges."""
        return self.columns * self.cell_width if self.wraps else None


@dataclass(frozen=True)
class TakeData:
    """The columns of a take. Frames and units are those of ``proxygraph.Ticks``."""

    columns: Mapping[str, Numbers]
    """A number for each tick, float64; ``NEEDED`` and whatever else was recorded."""
    about: TakeAbout

    @staticmethod
    def of(columns: Mapping[str, Buffer], about: TakeAbout) -> TakeData:
        """Copy buffers of doubles: whatever fills them may go on.

        Raises:
            ValueError: a column is missing, or they differ in length.
        """
        seen: dict[str, Any] = {name: np.frombuffer(values).copy() for name, values in columns.items()}
        missing = [name for name in NEEDED if name not in seen]
        if missing:
            raise ValueError(f"a take needs the columns {', '.join(missing)}")
        lengths = {len(values) for values in seen.values()}
        if len(lengths) > 1:
            raise ValueError(f"columns of a take have {', '.join(map(str, sorted(lengths)))} values")
        return TakeData(seen, about)

    def __len__(self) -> int:
        return len(self.columns["time"])

    @property
    def seconds(self) -> float:
        """From the first tick to the last."""
        time = self.columns["time"]
        return float(time[-1] - time[0]) if len(time) else 0.0

    @cached_property
    def places(self) -> Numbers:
        """Of the proxy: terrain metres east, north and up, n x 3."""
        return self._vectors("proxy", ("east", "north", "up"))

    @cached_property
    def force(self) -> Numbers:
        """Newtons, n."""
        strength: Numbers = np.linalg.norm(self._vectors("force", ("x", "y", "z")), axis=1)
        return strength

    @cached_property
    def depth(self) -> Numbers:
        """From the proxy to the goal beyond it, in metres of the hand's motion; 0 in free space."""
        apart = self._vectors("goal", ("east", "north", "up")) - self.places
        apart[:, 2] *= self.columns["window_exaggeration"]
        lengths = np.linalg.norm(apart, axis=1) / self.terrain_per_hand
        return np.where(self.in_contact, lengths, 0.0)

    @property
    def in_contact(self) -> npt.NDArray[np.bool_]:
        """Whether the proxy lay on the surface."""
        return np.asarray(self.columns["feature"] != 0.0)

    @property
    def terrain_per_hand(self) -> Numbers:
        """Metres of terrain for a metre of the hand's motion."""
        scale: Numbers = self.columns["window_width"] / self.about.workspace_width
        return scale

    def ticks(self, chosen: Any) -> TakeData:
        """The same take with some of its ticks: a slice, numbers or a mask."""
        return TakeData({name: values[chosen] for name, values in self.columns.items()}, self.about)

    def _vectors(self, name: str, axes: tuple[str, str, str]) -> Numbers:
        return np.stack([self.columns[f"{name}_{axis}"] for axis in axes], axis=1)
