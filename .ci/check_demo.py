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
]

# Both grids have 720 rows of 1440 columns that wrap: 719 x 1440 cells of two triangles.
EVERY_GRID = {"samples": 1_036_800, "triangles": 2_070_720}

# MOLA MEGDR, 4 pixels per degree, as published.
MARS = {
    "grid_max_m": 21134,
    "grid_max_lat_deg": 17.375,
    "grid_max_lon_e_deg": 226.875,
    "grid_min_m": -8068,
    "grid_min_lat_deg": -32.875,
    "grid_min_lon_e_deg": 62.125,
}

MEBIBYTE = 1 << 20


def faults(folder: Path, expected: dict[str, float]) -> list[str]:
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
    if not figures.get("keyframes", 0) > 0:
        found.append("touch.json: no keyframe was written")
    if not figures.get("session_s", 0) >= 5:
        found.append("touch.json: the session lasted less than 5 s")
    return found


def main(arguments: list[str]) -> int:
    """Exit code 0 where all holds, 1 where something does not."""
    expected = EVERY_GRID | (MARS if "mars" in arguments[1:] else {})
    found = faults(Path(arguments[0]), expected)
    for fault in found:
        print(fault, file=sys.stderr)
    if not found:
        print("The demo's results are as they should be.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
