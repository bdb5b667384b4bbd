"""How many vertices are shown: as many as are drawn quickly. The frame rate is kept by dropping samples.

Vertices are halved when frames are slow, and doubled when they have been quick for a while. If halving did
not help, something else is slow: they are doubled again, and left alone for a while. If doubling made frames
slow again, it is tried again only after twice the time.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from statistics import median

SLOW = 1.0 / 25.0
"""Seconds from frame to frame that look like stumbling."""

QUICK = 1.0 / 45.0
"""Seconds from frame to frame that leave room for twice the vertices."""

SLOW_REFRESH, QUICK_REFRESH = 0.012, 0.005
"""The same of a refresh: not even the slowest in a hundred is to hold Blender up for more than 16 ms."""

PAUSE = 5.0
"""Seconds from frame to frame that are no frame: a dialog, a render, a computer that slept."""

FEWEST = 15_000
"""Vertices: with fewer the levels have hardly any place to be fine in."""

LOOK = 24
"""Frames that are looked at together at most."""

FEW, LONG = 6, 2.0
"""So many frames are enough where they take so many seconds: very slow ones are not borne for long."""

LOOK_REFRESHES = 6
"""Refreshes that are looked at together."""

HELPED = 0.9
"""Frames are as long at most, by the ones before, where halving the vertices helped."""

FIRST_WAIT, LONGEST_WAIT = 3.0, 60.0
"""Seconds that frames must be quick before vertices are doubled."""

REST = 60.0
"""Seconds that vertices are left alone where something else is slow."""


@dataclass
class Steering:
    """Told of every frame and refresh, it says how many vertices may be shown."""

    most: int
    """Vertices that the terrain may have."""
    halvings: int = 0
    """How often they are halved now."""
    _frames: deque[float] = field(default_factory=lambda: deque(maxlen=LOOK))
    _refreshes: deque[float] = field(default_factory=lambda: deque(maxlen=LOOK_REFRESHES))
    _quick: float = 0.0
    """Seconds that frames have been quick without a break."""
    _wait: float = FIRST_WAIT
    _rest: float = 0.0
    """Seconds of rest that are left."""
    _before: float | None = None
    """Seconds of a frame before vertices were halved, until it is known whether that helped."""
    _was_raised: bool = False
    """Whether the last change was a doubling."""

    @property
    def budget(self) -> int:
        """Vertices."""
        return self.most >> self.halvings

    def frame(self, seconds: float) -> None:
        """Tell the time since the last frame."""
        if seconds >= PAUSE:
            return
        self._frames.append(seconds)
        self._rest = max(self._rest - seconds, 0.0)
        self._quick = self._quick + seconds if seconds <= QUICK else 0.0
        seen = len(self._frames)
        if seen < LOOK and not (seen >= FEW and sum(self._frames) >= LONG):
            return
        typical = median(self._frames)
        if self._before is not None:
            self._judge(typical)
        elif typical > SLOW and self._rest == 0.0:
            self._halve(typical)
        elif self._quick >= self._wait and self._refreshes_quickly and self.halvings > 0:
            self._double()

    def refresh(self, seconds: float) -> None:
        """Tell how long a refresh held Blender up."""
        self._refreshes.append(seconds)
        if len(self._refreshes) == LOOK_REFRESHES and median(self._refreshes) > SLOW_REFRESH:
            self._halve(None)

    @property
    def _refreshes_quickly(self) -> bool:
        return not self._refreshes or median(self._refreshes) <= QUICK_REFRESH

    def _halve(self, typical: float | None) -> None:
        """Show half; ``typical`` is the length of frames that has to become shorter by it."""
        if self.budget // 2 < FEWEST:
            return
        if self._was_raised:
            self._wait = min(2.0 * self._wait, LONGEST_WAIT)
        self.halvings += 1
        self._changed(before=typical, was_raised=False)

    def _double(self) -> None:
        self.halvings -= 1
        self._changed(before=None, was_raised=True)

    def _judge(self, typical: float) -> None:
        """Look whether halving helped."""
        before, self._before = self._before, None
        if before is not None and typical > SLOW and typical > HELPED * before:
            self._double()
            self._was_raised = False
            self._rest = REST

    def _changed(self, *, before: float | None, was_raised: bool) -> None:
        """Begin to look anew: what was measured is of other meshes."""
        self._before, self._was_raised = before, was_raised
        self._frames.clear()
        self._refreshes.clear()
        self._quick = 0.0
