"""The demo's figures: one flat JSON file, and a table for people."""

from __future__ import annotations

import os
import platform
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy
from proxygraph import GridRange

from touch_demo.live_session import LiveTouch

PAPER_VERTICES = 13.4
PAPER_COLLISION_TESTS = 1.01
"""Per update: vertices when moving "as fast as possible", tests while exploring (paper 4.4)."""

Figures = dict[str, float | int | str]


def table(f: Figures) -> str:
    """Rows of what was measured, the paper's figures beside them."""
    rows: list[tuple[str, str, str]] = [
        ("grid", str(f["grid"]), ""),
        ("samples", f"{f['samples']:,}", ""),
        ("triangles", f"{f['triangles']:,}", ""),
        ("highest", _where(f, "max"), ""),
        ("lowest", _where(f, "min"), ""),
        ("session", f"{f['session_s']:.2f} s", ""),
        ("ticks", f"{f['ticks']:,}", ""),
        ("missed ticks", f"{f['missed_ticks']:,}", ""),
        ("update, median", f"{f['update_us_median']:.1f} us", ""),
        ("update, p99", f"{f['update_us_p99']:.1f} us", ""),
        ("keyframes written", f"{f['keyframes']:,}", ""),
        ("whole session: cells per update", f"{f['cells_per_update_mean']:.2f}", ""),
        ("  vertices per update", f"{f['updates_vertices_mean']:.2f}", ""),
        (
            "  collision tests per update",
            f"{f['updates_collision_tests_mean']:.3f}",
            f"{PAPER_COLLISION_TESTS} exploring",
        ),
        ("fast swipes: cells per update", f"{f['swipe_cells_per_update_mean']:.2f}", ""),
        (
            "  vertices per update",
            f"{f['swipe_updates_vertices_mean']:.2f}",
            f"{PAPER_VERTICES} as fast as possible",
        ),
        ("  collision tests per update", f"{f['swipe_updates_collision_tests_mean']:.3f}", ""),
        ("machine", f"{f['machine']}, {f['cores']} cores", ""),
        ("Blender", str(f["blender"]), ""),
    ]

    return _aligned([("", "here", "paper"), *rows])


def report(kept: Any, extent: GridRange, touched: LiveTouch) -> Figures:
    """Collect the figures.

    Args:
        kept: what the terrain object remembers of its grid (the extension's KeptTerrain).
        extent: lowest and highest sample.
    """
    georeference, statistics = kept.grid.georeference, touched.statistics
    figures: Figures = {
        "grid": kept.grid.title,
        "synthetic": int(kept.grid.synthetic),
        "samples": kept.grid.samples,
        "triangles": kept.grid.triangles,
        **_place("max", extent.maximum, extent.maximum_cell, georeference),
        **_place("min", extent.minimum, extent.minimum_cell, georeference),
        "session_s": round(touched.seconds, 3),
        "ticks": statistics.ticks,
        "missed_ticks": statistics.missed_ticks,
        "contact_ticks": statistics.contact_ticks,
        "unfinished_updates": statistics.unfinished,
        "dropped_ticks": statistics.dropped,
        "update_us_median": round(statistics.update_us(0.5), 2),
        "update_us_p99": round(statistics.update_us(0.99), 2),
        "late_us_median": round(statistics.late_us(0.5), 2),
        "late_us_p99": round(statistics.late_us(0.99), 2),
        "keyframes": touched.keyframes,
        "machine": processor(),
        "cores": os.cpu_count() or 0,
        "python": platform.python_version(),
        "blender": bpy.app.version_string,
    }
    for prefix, counts in (("", touched.whole), ("swipe_", touched.swipes)):
        figures[f"{prefix}cells_per_update_mean"] = round(counts.per_tick(counts.goal_cells), 4)
        figures[f"{prefix}updates_vertices_mean"] = round(counts.per_tick(counts.vertices), 4)
        figures[f"{prefix}updates_collision_tests_mean"] = round(counts.per_tick(counts.collision_tests), 4)
    figures["swipe_ticks"] = touched.swipes.ticks
    return figures


def processor() -> str:
    """The processor's name, as far as the system tells."""
    told = Path("/proc/cpuinfo")
    if told.is_file():
        for line in told.read_text(encoding="utf-8", errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def _place(which: str, metres: float, cell: tuple[int, int], georeference: Any) -> Figures:
    column, row = cell
    return {
        f"grid_{which}_m": int(metres) if metres == int(metres) else metres,
        f"grid_{which}_lat_deg": georeference.latitude(row),
        f"grid_{which}_lon_e_deg": georeference.longitude(column),
    }


def _where(f: Figures, which: str) -> str:
    latitude = float(f[f"grid_{which}_lat_deg"])
    side = "N" if latitude >= 0.0 else "S"
    return f"{f[f'grid_{which}_m']:,} m at {abs(latitude)} {side} {f[f'grid_{which}_lon_e_deg']} E"


def _aligned(rows: Sequence[tuple[str, ...]]) -> str:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows
    )
