"""The time that Blender takes to import a grid."""

from __future__ import annotations

import statistics
import time
from pathlib import Path


def import_seconds(label: Path, *, rounds: int) -> float:
    """Median seconds from the file to a mesh of all its samples in the scene.

    ``BLENDER_USER_RESOURCES`` must be set, as for every script that enables the extension.
    """
    import bpy
    from enable_addon import enable

    enable()
    times = []
    for _ in range(rounds):
        began = time.perf_counter()
        bpy.ops.haptic_terrain.import_grid(filepath=str(label.resolve()), vertex_budget=1_100_000)
        times.append(time.perf_counter() - began)
        bpy.data.batch_remove([bpy.context.view_layer.objects.active])
        bpy.data.orphans_purge()
    return statistics.median(times)
