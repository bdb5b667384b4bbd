"""The planet's cells as directions on the unit sphere: there no map edge and no pole is special."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

RADIUS_KM = 3396.0


@dataclass(frozen=True)
class Sphere:
    """Unit vectors to the centres of a simple cylindrical grid's cells.

    Attributes:
        rows, columns: of the grid; the first row is the northernmost, the first column begins at 0 E.
        x, y, z: components of the unit vectors, rows x columns; z points north.
    """

    rows: int
    columns: int
    x: Array
    y: Array
    z: Array

    @classmethod
    def of_grid(cls, rows: int, columns: int) -> Sphere:
        """The sphere of a global grid, samples at cell centres."""
        latitudes = [math.pi * (0.5 - (row + 0.5) / rows) for row in range(rows)]
        longitudes = [2.0 * math.pi * (column + 0.5) / columns for column in range(columns)]
        ring = np.array([math.cos(latitude) for latitude in latitudes])[:, None]
        x = ring * np.array([math.cos(longitude) for longitude in longitudes])[None, :]
        y = ring * np.array([math.sin(longitude) for longitude in longitudes])[None, :]
        z = np.broadcast_to(np.array([math.sin(latitude) for latitude in latitudes])[:, None], x.shape)
        return cls(rows, columns, x, y, z)

    def distance_km(self, latitude: float, longitude: float) -> Array:
        """Chords (not arcs: exact by a square root alone) from a place (degrees) to every cell."""
        px, py, pz = direction(latitude, longitude)
        return RADIUS_KM * np.sqrt((self.x - px) ** 2 + (self.y - py) ** 2 + (self.z - pz) ** 2)

    def patch(
        self, latitude: float, longitude: float, reach_km: float
    ) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Indices (rows, columns; for broadcasting) of a box that holds all cells within ``reach_km``."""
        reach = math.degrees(reach_km / RADIUS_KM) + 1.0
        per_degree = self.rows / 180.0
        first = max(0, math.floor((90.0 - latitude - reach) * per_degree))
        last = min(self.rows, math.ceil((90.0 - latitude + reach) * per_degree) + 1)
        farthest = min(abs(latitude) + reach, 90.0)
        half = 180.0 if farthest >= 89.0 else min(180.0, reach / math.cos(math.radians(farthest)))
        centre = math.floor(longitude * per_degree)
        cells = math.ceil(half * per_degree)
        if 2 * cells + 1 >= self.columns:
            across = np.arange(self.columns)
        else:
            across = np.arange(centre - cells, centre + cells + 1) % self.columns
        return np.arange(first, last)[:, None], across[None, :]

    def patch_distance_km(
        self, patch: tuple[NDArray[np.intp], NDArray[np.intp]], latitude: float, longitude: float
    ) -> Array:
        """Chords from a place (degrees) to the cells of a patch."""
        px, py, pz = direction(latitude, longitude)
        return RADIUS_KM * np.sqrt(
            (self.x[patch] - px) ** 2 + (self.y[patch] - py) ** 2 + (self.z[patch] - pz) ** 2
        )


def direction(latitude: float, longitude: float) -> tuple[float, float, float]:
    """The unit vector to a place (degrees north and east)."""
    north, east = math.radians(latitude), math.radians(longitude)
    return math.cos(north) * math.cos(east), math.cos(north) * math.sin(east), math.sin(north)


def smoothstep(low: float, high: float, value: Array) -> Array:
    """0 below ``low``, 1 above ``high``, a cubic between; falling where ``low > high``."""
    t = np.minimum(np.maximum((value - low) / (high - low), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)
