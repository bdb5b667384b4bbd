"""The picture of the servo's bench."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).with_name("draw_stability.py")

RATES = (250, 500, 1000, 2000, 4000)
DAMPINGS = ("0_5", "2", "8")
DELAYS = (0, 1, 2)
ENDINGS = ("", "_theory", "_still", "_exact", "_without_encoder")


def _drawn(figures: Path, picture: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(SCRIPT), str(figures), str(picture)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.fixture
def figures(tmp_path: Path) -> Path:
    """Figures as the bench names them."""
    named = {
        f"stiffness_{rate}hz_b{damping}_d{delay}{ending}": float(rate)
        for rate in RATES
        for damping in DAMPINGS
        for delay in DELAYS
        for ending in ENDINGS
    }
    path = tmp_path / "servo.json"
    path.write_text(json.dumps(named))
    return path


def test_it_draws_the_figures_of_the_bench(figures: Path, tmp_path: Path) -> None:
    picture = tmp_path / "new" / "stability.png"
    drawn = _drawn(figures, picture)
    assert (drawn.returncode, drawn.stdout) == (0, ""), drawn.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert picture.stat().st_size < 1 << 20


def test_a_missing_figure_is_named_in_a_line(figures: Path, tmp_path: Path) -> None:
    named = json.loads(figures.read_text())
    del named["stiffness_4000hz_b8_d2_still"]
    figures.write_text(json.dumps(named))
    drawn = _drawn(figures, tmp_path / "stability.png")
    assert drawn.returncode == 1
    assert "stiffness_4000hz_b8_d2_still" in drawn.stderr.splitlines()[-1]
    assert len(drawn.stderr.splitlines()) == 1
