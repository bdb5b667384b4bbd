"""Where an object stands that is kept on the ground: a row for each frame; without Blender's data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from mathutils import Matrix

from .animated import Sample
from .footing import AROUND, MIDDLE, headings, level, plane, tilts, turned, unit
from .ground import Ground
from .stand import Stand
from .take_data import Numbers


@dataclass(frozen=True)
class Follow:
    """How an object follows the ground."""

    path: Literal["OWN", "PROXY"] = "OWN"
    """Over what: its own place, or the proxy that contact makes of it."""
    ground: Literal["HIGHEST", "REAL", "SHOWN"] = "HIGHEST"
    """Every sample of the grid, the coarser ground that is shown, or the higher of the two."""
    offset: float = 0.0
    """Blender units that the origin is above the ground."""
    oriented: bool = True
    """Whether it is tilted as the ground is."""
    heading: Literal["OWN", "PATH"] = "OWN"
    """Where its Y axis looks: where it looks by itself, or along the path."""
    width: float = 0.0
    length: float = 0.0
    """Of what touches the ground, along its X and Y axes, Blender units; 0 is a point."""


@dataclass(frozen=True)
class Way:
    """What an object does by itself."""

    stand: Stand
    ground: Ground
    moving: list[Sample]
    places: Numbers
    """Terrain metres of what is to be over the ground, n x 3."""


@dataclass(frozen=True)
class Standing:
    """What it does on the ground."""

    places: Numbers
    """Scene coordinates, n x 3."""
    rotations: Numbers | None
    """Quaternions, n x 4; ``None`` where it keeps its own."""
    beside: int
    """Frames in which there is no ground under the object, and it stays as it is."""


def stood(way: Way, follow: Follow) -> Standing:
    """Put an object on the ground in each frame."""
    at, up = _uprights(way)
    # What is upright over the flat map is upright on the globe, too.
    flat_up = np.tile(unit(np.array([way.stand.matrix.column(2)])), (len(up), 1))
    own = tilts(flat_up, up) @ np.array([sample.matrix.linear for sample in way.moving])
    forward = unit(level(own[:, :, 1], up))
    if follow.heading == "PATH":
        forward = headings(at, up, forward)
    frame = turned(forward, up)

    footprint = _footprint(way, follow)
    under = _ground(way, _placed(footprint, at, frame), follow)
    is_there = np.isfinite(under).all(axis=(1, 2))
    normal = up.copy()
    if follow.oriented:
        normal[is_there] = plane(under[is_there], up[is_there])
    tilt = tilts(up, normal)
    places = under[:, MIDDLE]
    if follow.width or follow.length:  # along the vertical: its footprint stays over the same ground
        points = _placed(footprint, places, tilt @ frame)
        gaps = _ground(way, points, follow) - points
        places = places + up * np.max(np.sum(gaps * up[:, None], axis=2), axis=1)[:, None]
    places = places + normal * follow.offset
    places[~is_there] = np.array([sample.place for sample in way.moving])[~is_there]
    rotations = None
    if follow.heading == "PATH" or follow.oriented:
        rotations = _quaternions(tilt @ (frame if follow.heading == "PATH" else own))
    return Standing(places, rotations, int((~is_there).sum()))


def _uprights(way: Way) -> tuple[Numbers, Numbers]:
    """Scene coordinates of the object's place, and of the unit vector up from there, n x 3 each."""
    at = np.array([way.stand.to_scene(*place) for place in way.places.tolist()])
    above = way.places + np.array((0.0, 0.0, way.ground.grid.layout.cell_width))
    higher = np.array([way.stand.to_scene(*place) for place in above.tolist()])
    return at, unit(higher - at)


def _footprint(way: Way, follow: Follow) -> Numbers:
    """Right, forward and up of the points that stand on the ground, 9 x 3.

    Something without a footprint is tilted as the cell around it is.
    """
    stand = way.stand
    cell = way.ground.grid.layout.cell_width * stand.frame.units_per_metre * stand.across
    half = 0.5 * np.array((follow.width or cell, follow.length or cell))
    return np.column_stack((AROUND * half, np.zeros(len(AROUND))))


def _placed(footprint: Numbers, at: Numbers, frame: Numbers) -> Numbers:
    """Scene coordinates of a footprint's points, n x 9 x 3."""
    return np.asarray(at[:, None] + footprint @ frame.transpose(0, 2, 1))


def _ground(way: Way, points: Numbers, follow: Follow) -> Numbers:
    """Scene coordinates of the ground under points, n x 9 x 3; NaN where there is none under the middle."""
    stand = way.stand
    flat = np.array([stand.to_terrain((x, y, z)) for x, y, z in points.reshape(-1, 3).tolist()])
    east, north = stand.frame.on_map(flat[:, 0]), flat[:, 1]
    heights = _heights(way.ground, follow)(east, north).reshape(-1, len(AROUND))
    middle = heights[:, MIDDLE : MIDDLE + 1]
    heights = np.where(np.isnan(heights), middle, heights)  # beside a rim as in the middle
    places = np.column_stack((east, north, heights.ravel())).tolist()
    return np.array([stand.to_scene(*place) for place in places]).reshape(points.shape)


def _heights(ground: Ground, follow: Follow) -> Callable[[Numbers, Numbers], Numbers]:
    if follow.ground == "REAL":
        return ground.real
    return ground.surface.heights_at if follow.ground == "SHOWN" else ground.highest


def _quaternions(rotations: Numbers) -> Numbers:
    """From matrices that may be scaled, n x 3 x 3; without jumps of sign."""
    turns = [Matrix(rotation).to_quaternion() for rotation in rotations.tolist()]
    for before, turn in pairwise(turns):
        turn.make_compatible(before)
    return np.array([turn[:] for turn in turns])
