"""How something with a footprint stands on uneven ground; without Blender.

Vectors are in scene coordinates; many moments at once, a row for each.
"""

from __future__ import annotations

import numpy as np

from .take_data import Numbers

AROUND = np.array([(side, ahead) for ahead in (-1.0, 0.0, 1.0) for side in (-1.0, 0.0, 1.0)])
"""Rightward and forward, in half footprints: the corners, the middles between them, and the middle of all."""

MIDDLE = 4
"""Its number in ``AROUND``."""

OPPOSITE = 1e-9
"""From the cosine of half a turn, below which no way around is the smallest."""

STANDS = 1e-3
"""Share of the fastest motion below which something stands: the direction of what is left is rounding."""


def plane(ground: Numbers, up: Numbers) -> Numbers:
    """Unit normals of the planes that lie on the ground under footprints, n x 3.

    Args:
        ground: at ``AROUND``, n x 9 x 3.
        up: away from the ground, n x 3.
    """
    right = ground[:, 2::3].mean(axis=1) - ground[:, 0::3].mean(axis=1)
    forward = ground[:, 6:].mean(axis=1) - ground[:, :3].mean(axis=1)
    normal = unit(np.cross(right, forward))
    return np.where(dot(normal, up)[:, None] < 0.0, -normal, normal)


def tilts(up: Numbers, normal: Numbers) -> Numbers:
    """The smallest rotations that bring ``up`` to ``normal``, n x 3 x 3: Rodrigues' formula."""
    x, y, z = np.cross(up, normal).T
    none = np.zeros(len(up))
    across = np.stack((none, -z, y, z, none, -x, -y, x, none), axis=1).reshape(-1, 3, 3)
    share = 1.0 / np.maximum(1.0 + dot(up, normal), OPPOSITE)
    return np.asarray(np.eye(3) + across + across @ across * share[:, None, None])


def turned(forward: Numbers, normal: Numbers) -> Numbers:
    """Rotation matrices whose third axis is ``normal`` and whose second looks ``forward``, n x 3 x 3."""
    right = unit(np.cross(forward, normal))
    return np.stack((right, np.cross(normal, right), normal), axis=2)


def level(vector: Numbers, up: Numbers) -> Numbers:
    """The part of vectors that is across ``up``, n x 3."""
    return np.asarray(vector - up * dot(vector, up)[:, None])


def unit(vector: Numbers) -> Numbers:
    """Vectors of length 1, n x 3."""
    return np.asarray(vector / np.sqrt(dot(vector, vector))[:, None])


def dot(one: Numbers, other: Numbers) -> Numbers:
    """Products of vectors, n."""
    return np.asarray(np.sum(one * other, axis=1))


def headings(places: Numbers, up: Numbers, own: Numbers) -> Numbers:
    """Where something looks that looks along its path: level unit vectors, n x 3.

    While it stands it looks where it looked before; before it moves at all, where it will go.

    Args:
        places: n x 3, at least two.
        own: level unit vectors for something that never moves.
    """
    ahead = np.gradient(places, axis=0)
    ahead = level(ahead, up)
    lengths = np.sqrt(dot(ahead, ahead))
    moves = lengths > STANDS * lengths.max()
    if not moves.any():
        return own
    last = np.maximum.accumulate(np.where(moves, np.arange(len(places)), -1))
    last[last < 0] = int(np.argmax(moves))
    return unit(level(ahead[last], up))
