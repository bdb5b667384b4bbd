"""Where the synthetic planet's landforms are.

They are placed by hand where the demo's path and picture can use them, and not where Mars has its own.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sample_grid.features import Basin, Shield, Trough, add_craters, canyon, carve
from sample_grid.noise import Random, fractal
from sample_grid.sphere import Array, Sphere, smoothstep

SHIELDS = (
    Shield(17.0, 112.0, 19500.0, 420.0, 52.0),
    Shield(-8.0, 128.0, 10500.0, 300.0, 60.0),
    Shield(1.5, 135.0, 9000.0, 250.0, 42.0),
    Shield(11.0, 142.0, 10800.0, 280.0, 48.0),
    Shield(38.0, 146.0, 5200.0, 520.0, 60.0),
    Shield(24.0, 258.0, 9500.0, 260.0, 38.0),
)
BASINS = (
    Basin(-43.0, 262.0, 1150.0, 7600.0),
    Basin(-52.0, 170.0, 620.0, 4300.0),
    Basin(11.0, 300.0, 700.0, 2600.0),
)


def canyons() -> list[Trough]:
    """A great canyon east of the volcanoes: three troughs, which run together into a broad channel."""
    random = Random(2718)
    troughs = list(
        canyon(random, -4.0, 152.0, -6.0, length_km=3500.0, half_width=84.0, depth=6600.0, branching=2)
    )
    troughs += canyon(random, -0.5, 166.0, -5.0, length_km=1500.0, half_width=46.0, depth=5400.0, branching=1)
    troughs += canyon(random, -10.5, 172.0, 2.0, length_km=1300.0, half_width=40.0, depth=4800.0, branching=1)
    troughs += canyon(random, -9.5, 207.0, 58.0, length_km=2100.0, half_width=60.0, depth=2900.0, branching=1)
    return troughs


def elevations(rows: int, columns: int) -> NDArray[np.int16]:
    """The planet's elevations in whole metres, rows x columns, the first row northernmost, from 0 E."""
    sphere = Sphere.of_grid(rows, columns)
    broad = fractal(sphere, 1.4, 4, 0.55, seed=11)
    fine = fractal(sphere, 5.0, 6, 0.62, seed=47)

    lowland = smoothstep(-0.02, 0.24, sphere.z + 0.16 * sphere.x + 0.42 * broad)
    swell_distance = sphere.distance_km(2.0, 138.0) * (1.0 + 0.12 * broad)
    swell = smoothstep(3100.0, 500.0, swell_distance)
    polar = smoothstep(700.0, 520.0, sphere.distance_km(90.0, 0.0) * (1.0 + 0.15 * fine))
    southern = smoothstep(520.0, 380.0, sphere.distance_km(-88.0, 330.0) * (1.0 + 0.2 * fine))

    rough = 1.0 - np.maximum(0.80 * lowland, 0.65 * swell)
    old_ground = np.maximum(0.0, 1.0 - 0.90 * lowland) * (1.0 - 0.93 * swell)
    elevation: Array = 1900.0 - 6000.0 * lowland + 1100.0 * broad
    for basin in BASINS:
        basin.dig_into(sphere, elevation, broad + 0.5 * fine)
        old_ground *= 0.25 + 0.75 * smoothstep(
            0.7 * basin.radius, basin.radius, sphere.distance_km(basin.latitude, basin.longitude)
        )
    add_craters(sphere, elevation, old_ground, count=4200, smallest_km=42.0, largest_km=420.0, seed=31415)
    elevation += 1300.0 * rough * fine
    # Lava buries what lay under the swell, and steepens the ground toward it.
    elevation += swell * (3900.0 - 0.45 * (elevation + 1500.0))
    elevation += 2300.0 * polar + 1500.0 * southern

    carve(sphere, elevation, canyons(), fine)
    for shield in SHIELDS:
        shield.build_on(sphere, elevation, fine)
    add_craters(
        sphere,
        elevation,
        np.full_like(elevation, 0.5),
        count=300,
        smallest_km=36.0,
        largest_km=90.0,
        seed=16180,
    )
    return np.floor(elevation + 0.5).astype(np.int16)
