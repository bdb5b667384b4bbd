"""The bench of the interface takes the figures of the scripts beside it, and puts bounds beside figures."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.bench.goals import Goal
from tests.bench.measured_by import measured_by, printed_figures
from tests.bench.random_modes import wander


def test_figures_are_what_a_script_prints_last() -> None:
    text = 'Info: {imported}\n{"first": 1}\nMore\n{\n  "overlay_draw_ms_p99": 0.5\n}\n'
    assert printed_figures(text, "script.py") == {"overlay_draw_ms_p99": 0.5}


@pytest.mark.parametrize("text", ["", "nothing\n", '{"cut": \n', '{"a": 1}\nand then words\n'])
def test_a_script_without_figures_is_named(text: str) -> None:
    with pytest.raises(SystemExit, match=r"script\.py should end with a JSON object"):
        printed_figures(text, "script.py")


def test_a_script_that_is_missing_or_fails_is_named(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match=r"absent\.py is not there"):
        measured_by(tmp_path / "absent.py")
    script = tmp_path / "fails.py"
    script.write_text("raise SystemExit(3)")
    with pytest.raises(SystemExit, match=r"fails\.py ended with 3"):
        measured_by(script)


@pytest.mark.parametrize(
    ("goal", "words"),
    [
        (Goal("figure"), ""),
        (Goal("figure", 2.0), "NOT MET"),
        (Goal("figure", 3.0), " met"),
        (Goal("figure", 4.0, at_least=True), "NOT MET"),
        (Goal("figure", 3.0, at_least=True), " met"),
    ],
)
def test_a_row_says_whether_the_bound_is_kept(goal: Goal, words: str) -> None:
    assert goal.row({"figure": 3.0}).endswith(words)


def test_modes_at_random_meet_everything_they_should() -> None:
    seen = wander(500)
    assert seen.mode_changes >= 500
    assert min(seen.zooms, seen.wall_touches, seen.drift_ticks, seen.contact_ticks) > 0
    assert seen.force_step > 0.9, "the slew limit was at work"
    assert seen.force_step <= 1.0 + 1e-9
    assert seen.energy_gain <= 0.0
