"""Measure touch in a real Blender window; ``make test-gui`` runs this after the scenarios.

The window is drawn by the processor (no graphics card), in plain shading, with a small planet: Blender's own
work is as little as can be, so that what touch adds weighs the most.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

from sample_grid.megdr import write_pair  # noqa: E402
from sample_grid.planet import elevations  # noqa: E402

from tests.bench.goals import Figures, Goal, print_goals  # noqa: E402
from tests.bench.machine import machine_figures, machine_line  # noqa: E402
from tests.gui.window import CannotRunError, make_window, run  # noqa: E402

GOALS = [
    Goal("tick_ms_p50"),
    Goal("tick_ms_p99"),
    Goal("tick_ms_max"),
    Goal("frames_per_s_with"),
    Goal("frames_per_s_without"),
    Goal("frames_per_s_with_over_without", 0.9, at_least=True),
]


def main() -> int:
    """Measure, print and write the figures; where there can be no window, say why."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, help="gui.json")
    parser.add_argument("--package", type=Path, required=True, help="folder of the extension's zip")
    parser.add_argument("--rounds", type=int, default=8, help="blocks with touch, and as many without")
    parser.add_argument("--seconds", type=float, default=2.0, help="of each block")
    options = parser.parse_args()
    try:
        window = make_window()
    except CannotRunError as reason:
        print(f"skipped: {reason}")
        return 0
    (package,) = options.package.glob("*.zip")
    with tempfile.TemporaryDirectory() as folder:
        label = write_pair(Path(folder), "planet", elevations(180, 360))
        files = [package, label, label.with_suffix(".img")]
        blocks = {"rounds": options.rounds, "seconds": options.seconds}
        outcome = run(window, "timing", files=files, output=ROOT / "build" / "gui" / "timing", options=blocks)
    if outcome.failure is not None:
        raise SystemExit(outcome.failure)
    figures = _figures(outcome.figures) | machine_figures()
    options.output.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    print_goals(f"Touch in a window ({machine_line()})", GOALS, figures)
    print(f"Figures: {options.output}")
    return 0


def _figures(measured: dict[str, dict[str, float] | list[float] | int]) -> Figures:
    ticks, with_touch, without = (
        measured["tick_ms"],
        measured["frames_per_s_with"],
        measured["frames_per_s_without"],
    )
    assert isinstance(ticks, dict)
    assert isinstance(with_touch, list)
    assert isinstance(without, list)
    ours, bare = statistics.median(with_touch), statistics.median(without)
    return {
        "tick_ms_p50": ticks["0.5"],
        "tick_ms_p99": ticks["0.99"],
        "tick_ms_max": ticks["1.0"],
        "frames_per_s_with": ours,
        "frames_per_s_without": bare,
        "frames_per_s_with_over_without": ours / bare,
    }


if __name__ == "__main__":
    sys.exit(main())
