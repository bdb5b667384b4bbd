"""Hands that tests put on a terrain."""

from __future__ import annotations

import math

from proxygraph import ScriptedDevice

Path = list[tuple[float, float, float, float]]


def sweep(seconds: float = 2.0, *, width: float = 0.1, depth: float = 0.02) -> ScriptedDevice:
    """Go down from free space, from west to east under the surface, and up again."""
    half = width / 2.0
    path: Path = [
        (0.0, -half, 0.0, 0.05),
        (0.2 * seconds, -half, 0.0, -depth),
        (0.8 * seconds, half, 0.01, -depth),
        (seconds, half, 0.01, 0.05),
    ]
    return ScriptedDevice(path)


def circles(seconds: float = 3.0) -> ScriptedDevice:
    """Circle under the surface, faster than a frame can follow in straight lines."""
    steps = 300
    path: Path = []
    for step in range(steps):
        share = step / (steps - 1)
        angle = 2.0 * math.pi * 5.0 * share
        path.append((share * seconds, 0.04 * math.cos(angle), 0.03 * math.sin(angle), -0.02))
    return ScriptedDevice(path)
