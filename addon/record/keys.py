"""The keys of a take: at the scene's rate, or the fewest that stay within a bound; without Blender."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from .reduce import fewest_keys
from .resample import keys_before_jumps, ticks_at_frames
from .scene_view import CLEARANCE, Highest, SceneView
from .take_data import Numbers, TakeData

LAST_FRAME = 1_048_574
"""Blender's own; later keys would never be shown."""

HOVER = 0.1
"""Share of the bound by which reduced keys are held above the ground: lines between keys that lie on rough
ground would cut through it, and every roughness would need a key."""

SHARE = 0.01
"""Of the largest force and depth: how far reduced keys may be from them."""


@dataclass(frozen=True)
class Keys:
    """Keys of one quantity."""

    frames: npt.NDArray[np.intp]
    """Whole frames, rising."""
    values: npt.NDArray[np.float32]
    """n x d."""
    held: npt.NDArray[np.bool_]
    """For each key, whether its value stays until the next one instead of moving toward it."""

    def __len__(self) -> int:
        return len(self.frames)


@dataclass(frozen=True)
class TakeKeys:
    """The keys of a take."""

    location: Keys
    force: Keys
    """Newtons."""
    depth: Keys
    """Metres of the hand's motion."""
    mode: Keys
    last_frame: int
    """Of the take."""
    cut_seconds: float
    """Of the take that lie beyond Blender's last frame, and have no keys."""


def take_keys(
    data: TakeData,
    view: SceneView,
    highest: Highest,
    *,
    start_frame: int,
    frames_per_second: float,
    bound: float | None = None,
    tell: Callable[[float], None] = lambda _share: None,
) -> TakeKeys:
    """Choose the keys.

    Args:
        bound: metres of the hand's motion that the point may be away from where it was felt, at every frame;
            ``None`` gives each frame its key.
    """
    felt = ticks_at_frames(data.columns["time"], frames_per_second)
    fitting = max(1, LAST_FRAME + 1 - start_frame)
    cut_seconds = max(0, len(felt) - fitting) / frames_per_second
    felt = felt[:fitting]
    there = data.ticks(felt)
    places = there.places
    turn = view.frame.turn
    turns = np.zeros(len(felt)) if turn is None else np.floor(places[:, 0] / turn)
    held = keys_before_jumps(turns, there.columns["time"])
    frames = start_frame + np.arange(len(felt))
    points = view.above_ground(places, highest)
    mode = there.columns["mode"]
    every = np.arange(len(felt))
    location = force = depth = modes = every
    if bound is not None:
        room = bound * there.terrain_per_hand * view.units_per_metre
        hover = HOVER * room / view.units_per_metre_up
        points = view.above_ground(places, lambda east, north: highest(east, north) + hover)
        # What Blender rounds between two keys comes on top.
        room = np.maximum((1.0 - HOVER) * room - 0.5 * CLEARANCE * view.rounding(points), 0.0)

        def clear(asked: Numbers) -> npt.NDArray[np.bool_]:
            return np.asarray(view.missing(asked, highest, 0.5 * CLEARANCE) == 0.0)

        shown = points.astype(np.float64)
        location = _in_runs(held, lambda run: fewest_keys(shown[run], room[run], clear), tell)
        force, depth = (_near(values, held) for values in (there.force, there.depth))
        modes = np.flatnonzero(np.append(True, np.diff(mode) != 0.0))
    return TakeKeys(
        location=_keys(frames, points, held, location),
        force=_keys(frames, there.force[:, None], held, force),
        depth=_keys(frames, there.depth[:, None], held, depth),
        mode=_keys(frames, mode[:, None], np.ones(len(felt), dtype=bool), modes),
        last_frame=int(frames[-1]),
        cut_seconds=cut_seconds,
    )


def _near(values: Numbers, held: npt.NDArray[np.bool_]) -> npt.NDArray[np.intp]:
    """Choose keys of a number that stay within a share of its largest."""
    room = np.full(len(values), SHARE * float(values.max(initial=0.0)))
    kept = values.astype(np.float32).astype(np.float64)[:, None]
    return _in_runs(held, lambda run: fewest_keys(kept[run], room[run]))


def _in_runs(
    held: npt.NDArray[np.bool_],
    choose: Callable[[slice], npt.NDArray[np.intp]],
    tell: Callable[[float], None] = lambda _share: None,
) -> npt.NDArray[np.intp]:
    """Choose keys in each piece between jumps: both sides of a jump have theirs."""
    bounds = [0, *(np.flatnonzero(held) + 1).tolist(), len(held)]
    chosen = []
    for first, last in pairwise(bounds):
        if first < last:
            chosen.append(choose(slice(first, last)) + first)
            tell(last / len(held))
    return np.concatenate(chosen)


def _keys(
    frames: npt.NDArray[np.intp],
    values: npt.NDArray[np.floating],
    held: npt.NDArray[np.bool_],
    chosen: npt.NDArray[np.intp],
) -> Keys:
    return Keys(frames[chosen], values[chosen].astype(np.float32), held[chosen])
