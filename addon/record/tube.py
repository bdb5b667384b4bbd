"""The tube that shows a trail; without Blender."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ..terrain.frame import TerrainFrame
from .trail_path import Numbers, Trail

SIDES = 8
"""Of the tube around a trail."""

UPRIGHT = 1e-6
"""Radians from the vertical, and share of a step, below which rounding decides what the direction is."""


@dataclass(frozen=True)
class Tube:
    """Triangles around trails, and the force at each of their vertices."""

    positions: Numbers
    """Object coordinates, n x 3."""
    triangles: npt.NDArray[np.int32]
    force: Numbers
    """Newtons."""


def tube(trails: Sequence[Trail], frame: TerrainFrame, radius: float) -> Tube:
    """Wrap trails into tubes of ``radius`` (object coordinates), resting on the ground."""
    positions = [_rings(_line(trail, frame), radius) for trail in trails]
    firsts = np.cumsum([0, *map(len, positions)])
    triangles = [_triangles(len(trail.force)) + first for trail, first in zip(trails, firsts, strict=False)]
    return Tube(
        np.concatenate(positions),
        np.concatenate(triangles).astype(np.int32),
        np.concatenate([np.repeat(trail.force, SIDES) for trail in trails]),
    )


def _line(trail: Trail, frame: TerrainFrame) -> Numbers:
    """Object coordinates of a trail, n x 3."""
    east, north, up = trail.places.T
    return np.stack(frame.to_object(east, north, up), axis=-1)


def _rings(line: Numbers, radius: float) -> Numbers:
    """Put a ring of vertices around each point, across the way there."""
    steps = np.diff(line, axis=0, append=line[-1:])
    steps[-1] = steps[-2]
    along = np.gradient(line, axis=0)
    # Where a hand turns back the way there and the way on are opposite: their mean leads nowhere.
    back = np.linalg.norm(along, axis=1) <= UPRIGHT * np.linalg.norm(steps, axis=1)
    along[back] = steps[back]
    side = np.cross(along, (0.0, 0.0, 1.0))
    # A trail is never steeper than the ground; where it is nearly upright, any side will do.
    side[np.linalg.norm(side, axis=1) <= UPRIGHT * np.linalg.norm(along, axis=1)] = (1.0, 0.0, 0.0)
    over = np.cross(side, along)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    over /= np.linalg.norm(over, axis=1, keepdims=True)
    angles = np.linspace(0.0, 2.0 * math.pi, SIDES, endpoint=False)
    ring = np.cos(angles)[None, :, None] * side[:, None, :] + np.sin(angles)[None, :, None] * over[:, None, :]
    rings: Numbers = (line[:, None, :] + radius * ring).reshape(-1, 3)
    return rings


def _triangles(points: int) -> npt.NDArray[np.int32]:
    """Join each ring to the next; the ends stay open."""
    rings = np.arange(points - 1)[:, None] * SIDES
    corner = np.arange(SIDES)[None, :]
    following = (corner + 1) % SIDES
    a, b = rings + corner, rings + following
    c, d = b + SIDES, a + SIDES
    triangles: npt.NDArray[np.int32] = np.stack((a, b, c, a, c, d), axis=-1).reshape(-1, 3).astype(np.int32)
    return triangles
