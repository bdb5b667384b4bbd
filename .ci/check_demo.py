"""Usage: check_demo.py FOLDER [mars]: holds what the demo wrote against figures that are exact.

Rates and times belong to the machine and are only asked to be there.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

KEYS = [
    "grid_max_m",
    "grid_max_lat_deg",
    "grid_max_lon_e_deg",
    "grid_min_m",
    "grid_min_lat_deg",
    "grid_min_lon_e_deg",
    "samples",
    "triangles",
    "ticks",
    "missed_ticks",
    "session_s",
    "cells_per_update_mean",
    "updates_vertices_mean",
    "updates_collision_tests_mean",
    "keyframes",
    "update_us_median",
    "update_us_p99",
    "surface_walk_update_us_median",
    "proxy_graph_update_us_median",
]

MODELS = ("surface_walk", "proxy_graph")
"""Stepped along the same path."""

Expected = dict[str, float | str]

# Both grids have 720 rows of 1440 columns that wrap: 719 x 1440 cells of two triangles.
EVERY_GRID: Expected = {
    "samples": 1_036_800,
    "triangles": 2_070_720,
    "contact_model": "surface_walk",
    **{f"{model}_ticks": 8598 for model in MODELS},
    **{f"{model}_swipe_ticks": 840 for model in MODELS},
    **{f"{model}_unfinished_updates": 0 for model in MODELS},
}

# MOLA MEGDR, 4 pixels per degree, as published.
MARS: Expected = {
    "grid_max_m": 21134,
    "grid_max_lat_deg": 17.375,
    "grid_max_lon_e_deg": 226.875,
    "grid_min_m": -8068,
    "grid_min_lat_deg": -32.875,
    "grid_min_lon_e_deg": 62.125,
}

# What the paper counted (13.4 vertices on the fastest swipes, 1.01 collision tests), on our hand's path.
SYNTHETIC_COUNTS = {
    "proxy_graph_updates_vertices_mean": 2.0591,
    "proxy_graph_updates_collision_tests_mean": 1.0059,
    "proxy_graph_swipe_updates_vertices_mean": 14.1512,
    "proxy_graph_swipe_updates_collision_tests_mean": 1.0548,
}
MARS_COUNTS = {
    "proxy_graph_updates_vertices_mean": 2.0582,
    "proxy_graph_updates_collision_tests_mean": 1.0085,
    "proxy_graph_swipe_updates_vertices_mean": 14.269,
    "proxy_graph_swipe_updates_collision_tests_mean": 1.0738,
}

NEAR = 0.002
"""Share by which counts may differ: another processor's arithmetic may break ties of distances otherwise."""

SWIPE = 13.4
"""Cells per update."""

MEBIBYTE = 1 << 20


def faults(folder: Path, expected: Expected, counts: dict[str, float]) -> list[str]:
    """What is wrong with the demo's results, a line each."""
    found = []
    picture = folder / "touch.png"
    if not picture.is_file() or picture.read_bytes()[:8] != b"\x89PNG\r\n\x1a\n":
        found.append(f"{picture} is no PNG picture")
    elif picture.stat().st_size >= MEBIBYTE:
        found.append(f"{picture} is not under 1 MiB")
    scene = folder / "touch.blend"
    if not scene.is_file() or scene.stat().st_size == 0:
        found.append(f"{scene} is missing or empty")
    figures = json.loads((folder / "touch.json").read_text(encoding="utf-8"))
    found += [f"touch.json lacks {key}" for key in KEYS if key not in figures]
    for key, value in expected.items():
        if figures.get(key) != value:
            found.append(f"touch.json: {key} is {figures.get(key)}, not {value}")
    found += [f"touch.json: {fault}" for fault in count_faults(figures, counts)]
    if not figures.get("keyframes", 0) > 0:
        found.append("touch.json: no keyframe was written")
    if not figures.get("session_s", 0) >= 5:
        found.append("touch.json: the session lasted less than 5 s")
    return found


def count_faults(figures: dict[str, float], counts: dict[str, float]) -> list[str]:
    """What is wrong with the two models on the same path, a line each."""
    found = []
    for key, value in counts.items():
        if not abs(figures.get(key, 0.0) - value) <= NEAR * value:
            found.append(f"{key} is {figures.get(key)}, not {value}")
    for model in MODELS:
        cells = figures.get(f"{model}_swipe_cells_per_update_mean", 0.0)
        if not abs(cells - SWIPE) <= NEAR * SWIPE:
            found.append(f"{model} was swiped at {cells} cells per update, not {SWIPE}")
        passed = sum(figures.get(f"{model}_swipe_updates_{kind}_mean", 0.0) for kind in ("vertices", "faces"))
        if not passed >= SWIPE:
            found.append(f"{model} passed {passed} vertices and faces per update, less than {SWIPE} cells")
    walk, graph = (figures.get(f"{model}_in_contact_share", 0.0) for model in MODELS)
    if not (0.5 < walk < 1.0 and abs(walk - graph) < 0.01):
        found.append(f"the models were in contact in {walk} and {graph} of the updates")
    return found


def main(arguments: list[str]) -> int:
    """Exit code 0 where all holds, 1 where something does not."""
    is_mars = "mars" in arguments[1:]
    expected = EVERY_GRID | (MARS if is_mars else {})
    found = faults(Path(arguments[0]), expected, MARS_COUNTS if is_mars else SYNTHETIC_COUNTS)
    for fault in found:
        print(fault, file=sys.stderr)
    if not found:
        print("The demo's results are as they should be.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
