"""Random numbers and fractal noise that are the same on every machine."""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from sample_grid.sphere import Array, Sphere

Words = NDArray[np.uint32]

_MASK_64 = (1 << 64) - 1


class Random:
    """The SplitMix64 generator (Steele, Lea, Flood 2014): integers only, so exact everywhere."""

    def __init__(self, seed: int) -> None:
        self._state = seed & _MASK_64

    def unit(self) -> float:
        """The next number of [0, 1)."""
        self._state = (self._state + 0x9E3779B97F4A7C15) & _MASK_64
        z = self._state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK_64
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK_64
        return ((z ^ (z >> 31)) >> 11) / (1 << 53)

    def between(self, low: float, high: float) -> float:
        """The next number of [low, high)."""
        return low + (high - low) * self.unit()


def _mixed(x: Words, y: Words, z: Words, seed: int) -> Words:
    """A hash of lattice points; unsigned products wrap, which is what mixes the bits."""
    h: Words = x * np.uint32(0x8DA6B343) + y * np.uint32(0xD8163841) + z * np.uint32(0xCB1AB31F)
    h = h + np.uint32((seed * 0x9E3779B1) & 0xFFFFFFFF)
    h ^= h >> np.uint32(15)
    h *= np.uint32(0x2C1B3C6D)
    h ^= h >> np.uint32(12)
    h *= np.uint32(0x297A2D39)
    h ^= h >> np.uint32(15)
    return h


def gradient_noise(sphere: Sphere, frequency: float, seed: int) -> Array:
    """Smooth noise on the sphere, about -1 to 1, with ``frequency`` lattice cells per planet radius."""
    base: list[Words] = []
    inside: list[Array] = []
    fade: list[Array] = []
    # The shift keeps lattice points off the poles and the coordinates positive.
    for axis, shift in ((sphere.x, 8.37), (sphere.y, 8.61), (sphere.z, 8.13)):
        position = (axis + shift) * frequency
        whole = np.floor(position)
        t = position - whole
        base.append(whole.astype(np.uint32))
        inside.append(t)
        fade.append(t * t * t * (t * (t * 6.0 - 15.0) + 10.0))
    total = np.zeros_like(sphere.x)
    for corner in product((0, 1), repeat=3):
        i, j, k = (b + np.uint32(c) for b, c in zip(base, corner, strict=True))
        h = _mixed(i, j, k, seed)
        weight: Array | float = 1.0
        slope: Array | float = 0.0
        for axis_index, c in enumerate(corner):
            bits = (h >> np.uint32(10 * axis_index)) & np.uint32(1023)
            slope = slope + (bits.astype(np.float64) / 511.5 - 1.0) * (inside[axis_index] - c)
            weight = weight * (fade[axis_index] if c else 1.0 - fade[axis_index])
        total += weight * slope
    return total


def fractal(sphere: Sphere, frequency: float, octaves: int, roughness: float, seed: int) -> Array:
    """Octaves of noise, each twice as fine and ``roughness`` times as high as the one before."""
    total = np.zeros_like(sphere.x)
    height = 1.0
    for octave in range(octaves):
        total += height * gradient_noise(sphere, frequency, seed + 101 * octave)
        frequency *= 2.0
        height *= roughness
    return total
