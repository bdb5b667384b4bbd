"""The picture of the bench."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).with_name("draw_frontier.py")

SCENES = ("x20", "x20_canyon")
SPEEDS = ("0_3", "1", "3_4", "13_4", "50")
MODELS = (
    "surface_walk",
    "surface_walk_sub_1",
    "surface_walk_sub_0_25",
    "proxy_graph",
    "god_object",
    "god_object_release",
    "virtual_proxy",
)


def _drawn(figures: Path, picture: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SCRIPT), str(figures), str(picture)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.fixture
def figures(tmp_path: Path) -> Path:
    """Figures as the bench names them."""
    named = {}
    for scene in SCENES:
        for speed in SPEEDS:
            for model in MODELS:
                named[f"{scene}_{speed}_{model}_hot_ns"] = 300.0
                named[f"{scene}_{speed}_{model}_miss"] = 0.0
    path = tmp_path / "contact.json"
    path.write_text(json.dumps(named))
    return path


def test_it_draws_the_figures_of_the_bench(figures: Path, tmp_path: Path) -> None:
    picture = tmp_path / "new" / "frontier.png"
    drawn = _drawn(figures, picture)
    assert (drawn.returncode, drawn.stdout) == (0, ""), drawn.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert picture.stat().st_size < 1 << 20


def test_a_missing_figure_is_named_in_a_line(figures: Path, tmp_path: Path) -> None:
    named = json.loads(figures.read_text())
    del named["x20_canyon_50_proxy_graph_miss"]
    figures.write_text(json.dumps(named))
    drawn = _drawn(figures, tmp_path / "frontier.png")
    assert drawn.returncode == 1
    assert "x20_canyon_50_proxy_graph_miss" in drawn.stderr.splitlines()[-1]
    assert len(drawn.stderr.splitlines()) == 1
