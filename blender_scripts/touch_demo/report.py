"""The demo's figures: one flat JSON file, and a table for people."""

from __future__ import annotations

import math
import os
import platform
from collections.abc import Sequence
from typing import Any

import bpy
from pipeline.machine import processor
from proxygraph import GridRange

from touch_demo.counts import Counts
from touch_demo.live_session import LiveTouch
from touch_demo.replay import MODELS, TURN, Replay

PAPER_VERTICES = 13.4
PAPER_COLLISION_TESTS = 1.01
"""Per update: vertices when moving "as fast as possible", tests while exploring (paper 4.4)."""

PAPER_FAR_EDGES = "0; 3.5% on walls x20"
"""Updates with a step over a far edge: unscaled, and on Valles Marineris with heights x20 (paper 4.4)."""

Figures = dict[str, float | int | str]

COMPARED = f"""\
Both were stepped along every millisecond of the hand's path, in turns of {TURN} ticks, on memory that the
live session had warmed; that one may have missed ticks. An update is a whole tick, the script's look-up
included. The paper's figures are of a person's hand on a finer grid: how deep a hand presses changes
collision tests and far edges more than anything else does."""


def table(f: Figures) -> str:
    """Rows of what was measured live, and of two models side by side with the paper's figures."""
    return f"{_aligned(_live(f))}\n\n{_aligned(_side_by_side(f))}\n\n{COMPARED}"


def _live(f: Figures) -> list[tuple[str, ...]]:
    return [
        ("grid", str(f["grid"])),
        ("samples", f"{f['samples']:,}"),
        ("triangles", f"{f['triangles']:,}"),
        ("highest", _where(f, "max")),
        ("lowest", _where(f, "min")),
        ("live session", f"{f['session_s']:.2f} s, with {f['contact_model']}"),
        ("ticks", f"{f['ticks']:,}"),
        ("missed ticks", f"{f['missed_ticks']:,}"),
        ("update, median", f"{f['update_us_median']:.1f} us"),
        ("update, p99", f"{f['update_us_p99']:.1f} us"),
        ("keyframes written", f"{f['keyframes']:,}"),
        ("machine", f"{f['machine']}, {f['cores']} cores"),
        ("Blender", str(f["blender"])),
    ]


def _side_by_side(f: Figures) -> list[tuple[str, ...]]:
    def row(title: str, key: str, shown: str, paper: str = "") -> tuple[str, ...]:
        return (title, *(shown.format(f[f"{model}_{key}"]) for model in MODELS), paper)

    return [
        ("the same path, stepped", *MODELS, "paper"),
        row("update, median", "update_us_median", "{:.2f} us"),
        row("update, p99", "update_us_p99", "{:.2f} us"),
        row("whole path: cells per update", "cells_per_update_mean", "{:.2f}"),
        row("  in contact", "in_contact_share", "{:.1%}"),
        row("  vertices per update", "updates_vertices_mean", "{:.2f}"),
        row("  faces per update", "updates_faces_mean", "{:.2f}"),
        row(
            "  collision tests per update",
            "updates_collision_tests_mean",
            "{:.3f}",
            f"{PAPER_COLLISION_TESTS} exploring",
        ),
        row("  far edges per update", "updates_far_edges_mean", "{:.3%}", PAPER_FAR_EDGES),
        row("fast swipes: cells per update", "swipe_cells_per_update_mean", "{:.2f}"),
        row("  in contact", "swipe_in_contact_share", "{:.1%}"),
        row(
            "  vertices per update",
            "swipe_updates_vertices_mean",
            "{:.2f}",
            f"{PAPER_VERTICES} as fast as possible",
        ),
        row("  faces per update", "swipe_updates_faces_mean", "{:.2f}"),
        row("  collision tests per update", "swipe_updates_collision_tests_mean", "{:.3f}"),
        row("  far edges per update", "swipe_updates_far_edges_mean", "{:.3%}"),
    ]


def report(kept: Any, extent: GridRange, touched: LiveTouch, replayed: dict[str, Replay]) -> Figures:
    """Collect the figures.

    Args:
        kept: what the terrain object remembers of its grid (the extension's KeptTerrain).
        extent: lowest and highest sample.
        replayed: the same path stepped, by contact model.
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
        "contact_model": touched.contact_model,
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
    figures |= Counts.of(statistics).figures("") | touched.swipes.figures("swipe_")
    figures["swipe_ticks"] = touched.swipes.ticks
    for model, found in replayed.items():
        figures |= _replay_figures(f"{model}_", found)
    return figures


def _replay_figures(prefix: str, found: Replay) -> Figures:
    statistics = found.statistics
    return {
        f"{prefix}ticks": statistics.ticks,
        f"{prefix}swipe_ticks": found.swipes.ticks,
        f"{prefix}update_us_median": round(statistics.update_us(0.5), 3),
        f"{prefix}update_us_p99": round(statistics.update_us(0.99), 3),
        f"{prefix}far_edge_loops": statistics.far_edge_loops,
        f"{prefix}cycles_ended": statistics.cycles_ended,
        f"{prefix}unfinished_updates": statistics.unfinished,
        **Counts.of(statistics).figures(prefix),
        **found.swipes.figures(f"{prefix}swipe_"),
    }


def _place(which: str, metres: float, cell: tuple[int, int], georeference: Any) -> Figures:
    longitude, latitude = georeference.longitude_latitude(*cell) or (math.nan, math.nan)
    return {
        f"grid_{which}_m": int(metres) if metres == int(metres) else metres,
        f"grid_{which}_lat_deg": latitude,
        f"grid_{which}_lon_e_deg": longitude,
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
