"""How something with a footprint stands on uneven ground; without Blender."""

from __future__ import annotations

import numpy as np

from .take_data import Numbers

AROUND = (
    (-1.0, -1.0),
    (0.0, -1.0),
    (1.0, -1.0),
    (-1.0, 0.0),
    (0.0, 0.0),
    (1.0, 0.0),
    (-1.0, 1.0),
    (0.0, 1.0),
    (1.0, 1.0),
)
"""Sideways and forward, in half footprints: the corners, the middles between them, and the middle of all."""


def footing(ground: Numbers, up: Numbers) -> tuple[Numbers, Numbers]:
    """Lay a plane on the ground under a footprint so that none of its points is buried.

    Args:
        ground: scene coordinates of the ground at ``AROUND``, 9 x 3.
        up: unit vector away from the ground.

    Returns:
        The middle of the plane, and its unit normal.
    """
    right = ground[[2, 5, 8]] - ground[[0, 3, 6]]
    forward = ground[[6, 7, 8]] - ground[[0, 1, 2]]
    normal = _unit(np.cross(right.mean(axis=0), forward.mean(axis=0)))
    if normal @ up < 0.0:  # a mirrored terrain
        normal = -normal
    middle = ground[4]
    lift = np.max((ground - middle) @ normal)
    # Along the vertical: a thing that is lifted stays over its place.
    return middle + up * (lift / (normal @ up)), normal


def basis(forward: Numbers, normal: Numbers) -> Numbers:
    """Columns right, forward and up of something that stands on a plane and looks along ``forward``."""
    right = _unit(np.cross(forward, normal))
    return np.stack((right, np.cross(normal, right), normal), axis=1)


def _unit(vector: Numbers) -> Numbers:
    return np.asarray(vector / np.sqrt(np.sum(vector * vector)))
