"""The bench of refreshes, on a small grid."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np

from tests.bench.measure_preview import hand_path
from tests.formats.megdr_pair import planet

BENCH = Path(__file__).with_name("measure_preview.py")


def test_figures_of_a_small_planet(tmp_path: Path) -> None:
    output = tmp_path / "preview.json"
    grid = planet(4).write(tmp_path)
    subprocess.run(
        [sys.executable, str(BENCH), str(output), "--grid", str(grid), "--refreshes", "6"],
        check=True,
        timeout=300,
    )
    figures = json.loads(output.read_text())
    assert figures["preview_refreshes"] == 6
    assert figures["preview_open_edges_inside"] == 0
    assert 1000 < figures["preview_vertices_max"] <= figures["preview_vertices_budget"]
    assert 0.0 < figures["preview_refresh_ms_p50"] <= figures["preview_refresh_ms_p99"]


def test_the_path_goes_on_and_comes_near() -> None:
    class Layout:
        rows, columns, cell_width, cell_height = 180, 360, 1.0, 1.0

    class Placement:
        @staticmethod
        def longest_side(_layout: object) -> float:
            return 10.0

    path = hand_path(Layout(), Placement())
    places = np.array([next(path) for _ in range(2000)])
    assert np.ptp(places[:, 0]) > 360.0
    assert places[:, 1].max() <= 0.0
    assert places[:, 1].min() >= -180.0
    assert places[:, 2].max() > 50.0 * places[:, 2].min()
