"""Landforms, each a change of elevations in metres: basins, craters, shield volcanoes, canyons."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sample_grid.noise import Random
from sample_grid.sphere import RADIUS_KM, Array, Sphere, smoothstep


@dataclass(frozen=True)
class Shield:
    """A shield volcano: gentle flanks, a scarp around its foot, a nested caldera.

    Attributes:
        latitude, longitude: of the summit, degrees.
        height: of the caldera's rim above the ground, metres.
        radius: of the foot, kilometres.
        caldera: its radius, kilometres.
    """

    latitude: float
    longitude: float
    height: float
    radius: float
    caldera: float

    def build_on(self, sphere: Sphere, elevation: Array, ragged: Array) -> None:
        """Raise the volcano; ``ragged`` (about -1 to 1) roughens its outline and flows."""
        patch = sphere.patch(self.latitude, self.longitude, 1.4 * self.radius)
        distance = sphere.patch_distance_km(patch, self.latitude, self.longitude)
        r = distance / self.radius * (1.0 + 0.10 * ragged[patch])
        flank = np.maximum(1.0 - r, 0.0)
        # Nine tenths of the height by the flanks, steeper toward the summit; the rest by the scarp.
        rise = self.height * (flank * (0.55 + 0.35 * flank) + 0.10 * smoothstep(1.06, 0.94, r))
        rise += 60.0 * ragged[patch] * smoothstep(1.0, 0.8, r)
        rim = self.caldera / self.radius
        top = self.height * ((1.0 - rim) * (0.55 + 0.35 * (1.0 - rim)) + 0.10)
        inner = smoothstep(1.25 * self.caldera, 0.85 * self.caldera, distance)
        pit = smoothstep(0.62 * self.caldera, 0.40 * self.caldera, distance)
        rise = rise * (1.0 - inner) + (top - 0.11 * self.height - 0.05 * self.height * pit) * inner
        elevation[patch] += rise


@dataclass(frozen=True)
class Basin:
    """An old impact basin: a wide, worn bowl within a low rim.

    Attributes:
        latitude, longitude: of the centre, degrees.
        radius: of the rim's crest, kilometres.
        depth: below the ground around, metres.
    """

    latitude: float
    longitude: float
    radius: float
    depth: float

    def dig_into(self, sphere: Sphere, elevation: Array, ragged: Array) -> None:
        """Sink the bowl and raise its rim; ``ragged`` (about -1 to 1) wears both."""
        r = sphere.distance_km(self.latitude, self.longitude) / self.radius * (1.0 + 0.10 * ragged)
        bowl = smoothstep(1.0, 0.45, r)
        rim = smoothstep(0.80, 1.0, r) * smoothstep(1.9, 1.0, r)
        elevation += 0.17 * self.depth * rim * (1.0 + 0.6 * ragged) - self.depth * bowl


def add_craters(
    sphere: Sphere,
    elevation: Array,
    density: Array,
    *,
    count: int,
    smallest_km: float,
    largest_km: float,
    seed: int,
) -> None:
    """Strew craters whose number above a diameter falls with its square, as on old ground.

    ``density`` (0 to 1) is the share of craters that survive at a cell. Depth follows the diameter
    D (km) as 360 D^0.49 m for fresh complex craters (Garvin et al. 2003); most are worn.
    """
    random = Random(seed)
    for _ in range(count):
        latitude = math.degrees(math.asin(random.between(-1.0, 1.0)))
        longitude = random.between(0.0, 360.0)
        share = random.unit()
        diameter = 1.0 / math.sqrt((1.0 - share) / smallest_km**2 + share / largest_km**2)
        wear = random.between(0.25, 1.0)
        survives = random.unit()
        row = min(sphere.rows - 1, int((90.0 - latitude) / 180.0 * sphere.rows))
        column = min(sphere.columns - 1, int(longitude / 360.0 * sphere.columns))
        if survives >= density[row, column]:
            continue
        depth = 360.0 * diameter**0.49 * wear
        rim = 0.22 * depth
        patch = sphere.patch(latitude, longitude, 1.3 * diameter)
        t = sphere.patch_distance_km(patch, latitude, longitude) / (0.5 * diameter)
        inside = -depth + (depth + rim) * smoothstep(0.45, 1.0, t)
        # Fresh complex craters have a central peak.
        inside += 0.35 * depth * max(wear - 0.5, 0.0) * smoothstep(0.25, 0.0, t)
        near = np.maximum(t, 1.0)
        blanket = rim * smoothstep(2.6, 1.0, t) / (near * near * near)
        elevation[patch] += np.where(t < 1.0, inside, blanket)


@dataclass(frozen=True)
class Trough:
    """A straight piece of a canyon, from one place to another (degrees).

    Attributes:
        half_width: of the floor's edge to the axis, kilometres.
        depth: of the floor below the plain, metres.
    """

    latitude_a: float
    longitude_a: float
    latitude_b: float
    longitude_b: float
    half_width: float
    depth: float


def canyon(
    random: Random,
    latitude: float,
    longitude: float,
    heading: float,
    *,
    length_km: float,
    half_width: float,
    depth: float,
    branching: int,
) -> Iterator[Trough]:
    """A winding trough with branches.

    It starts at a place (degrees), runs along ``heading`` (degrees north of east), narrows toward
    both ends, and sends out side canyons ``branching`` times over.
    """
    step_km = 55.0
    degrees = math.degrees(step_km / RADIUS_KM)
    steps = max(2, round(length_km / step_km))
    turn = 0.0
    for index in range(steps):
        turn = 0.75 * turn + random.between(-14.0, 14.0)
        course = math.radians(heading + turn)
        north = latitude + degrees * math.sin(course)
        east = longitude + degrees * math.cos(course) / math.cos(math.radians(latitude))
        along = (index + 0.5) / steps
        taper = math.sqrt(max(0.12, 1.0 - (2.0 * along - 1.0) ** 4))
        width = half_width * taper * random.between(0.75, 1.25)
        yield Trough(latitude, longitude, north, east, width, depth * (0.6 + 0.4 * taper))
        if branching and index and random.unit() < 0.20:
            side = 1.0 if random.unit() < 0.5 else -1.0
            yield from canyon(
                random,
                latitude,
                longitude,
                heading + side * random.between(35.0, 80.0),
                length_km=length_km * random.between(0.06, 0.20),
                half_width=max(11.0, half_width * random.between(0.30, 0.5)),
                depth=depth * random.between(0.45, 0.75),
                branching=branching - 1,
            )
        latitude, longitude = north, east


def carve(sphere: Sphere, elevation: Array, troughs: list[Trough], ragged: Array) -> None:
    """Cut troughs into the ground: flat floors, steep ragged walls; where they meet, the deepest counts."""
    cut = np.zeros_like(elevation)
    for trough in troughs:
        middle = (
            0.5 * (trough.latitude_a + trough.latitude_b),
            0.5 * (trough.longitude_a + trough.longitude_b),
        )
        patch = sphere.patch(middle[0], middle[1] % 360.0, 60.0 + 2.2 * trough.half_width)
        distance = _distance_to_segment_km(sphere, patch, trough) * (1.0 + 0.28 * ragged[patch])
        wall = smoothstep(trough.half_width + 16.0, 0.72 * trough.half_width, distance)
        cut[patch] = np.maximum(cut[patch], trough.depth * wall)
    elevation -= cut * (1.0 + 0.05 * ragged)


def _distance_to_segment_km(
    sphere: Sphere, patch: tuple[np.ndarray[tuple[int, ...], np.dtype[np.intp]], ...], trough: Trough
) -> Array:
    """Kilometres from cells to a trough's axis, on a plane that touches the sphere at its start."""
    scale = math.pi / 180.0 * RADIUS_KM
    narrow = math.cos(math.radians(0.5 * (trough.latitude_a + trough.latitude_b)))
    rows, columns = patch
    north = (90.0 - (rows + 0.5) * 180.0 / sphere.rows - trough.latitude_a) * scale
    east = (columns + 0.5) * 360.0 / sphere.columns - trough.longitude_a
    east = (east - 360.0 * np.floor((east + 180.0) / 360.0)) * (scale * narrow)
    axis_north = (trough.latitude_b - trough.latitude_a) * scale
    axis_east = (trough.longitude_b - trough.longitude_a) * scale * narrow
    squared = axis_north**2 + axis_east**2
    along = np.minimum(np.maximum((north * axis_north + east * axis_east) / squared, 0.0), 1.0)
    distance: Array = np.sqrt((north - along * axis_north) ** 2 + (east - along * axis_east) ** 2)
    return distance
