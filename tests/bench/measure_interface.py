"""Measure MarsView's interface in Blender; ``make bench-interface`` runs this.

The timer's tick is measured here on a live session, forces and momentum through the native module in
stepped time. What is drawn needs a Blender of its own each: overlay and preview are measured by scripts
beside this one, each of which ends by printing its figures as a JSON object. *Busy* is the time of the
thread's own work: by the clock, a tick also takes what other programs have of the processor meanwhile.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

from tests.bench.goals import Figures, Goal, print_goals  # noqa: E402
from tests.bench.machine import machine_figures, machine_line  # noqa: E402
from tests.bench.measured_by import measured_by  # noqa: E402
from tests.bench.random_modes import wander  # noqa: E402
from tests.bench.timer_tick import tick_milliseconds  # noqa: E402

BESIDE = ("measure_overlay.py", "measure_preview.py")
"""Scripts that measure what is drawn."""

CHANGES = 10_000
"""Of the mode, at random."""

GOALS = [
    Goal("timer_tick_ms_p50"),
    Goal("timer_tick_ms_p99", 1.0),
    Goal("timer_tick_busy_ms_p50"),
    Goal("timer_tick_busy_ms_p99"),
    Goal("overlay_draw_ms_p99", 1.0),
    Goal("preview_refresh_ms_p99", 16.0),
    Goal("preview_open_edges_inside", 0.0),
    Goal("force_step_over_slew_limit_max", 1.0),
    Goal("pan_drift_energy_gain", 0.0),
    Goal("mode_changes", CHANGES, at_least=True),
    Goal("zoom_ticks"),
    Goal("wall_touches"),
    Goal("drift_ticks"),
]


def main() -> None:
    """Measure, print and write the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, help="interface.json")
    parser.add_argument("--grid", type=Path, required=True, help="label of the grid that is touched")
    parser.add_argument("--seconds", type=float, default=30.0, help="of live touch")
    options = parser.parse_args()
    figures: Figures = {**machine_figures(), "grid": options.grid.name}
    for script in BESIDE:
        figures |= measured_by(Path(__file__).with_name(script))
    figures |= _modes()
    figures |= _ticks(options.grid, options.seconds)
    options.output.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    vertices = Goal("preview_vertices_max", float(figures["preview_vertices_budget"]))
    print_goals(f"The interface ({machine_line()}; {options.grid.name})", [*GOALS, vertices], figures)
    print(f"Figures: {options.output}")


def _modes() -> Figures:
    """Forces and momentum, while modes change at random."""
    seen = wander(CHANGES)
    return {
        # The slew limit's own arithmetic rounds in the last digit.
        "force_step_over_slew_limit_max": round(seen.force_step, 12),
        "pan_drift_energy_gain": seen.energy_gain,
        "mode_changes": seen.mode_changes,
        "zoom_ticks": seen.zooms,
        "wall_touches": seen.wall_touches,
        "drift_ticks": seen.drift_ticks,
    }


def _ticks(grid: Path, seconds: float) -> Figures:
    """The timer's."""
    clock, busy = np.array(tick_milliseconds(grid, seconds=seconds)).T
    return {
        "timer_tick_ms_p50": float(np.quantile(clock, 0.5)),
        "timer_tick_ms_p99": float(np.quantile(clock, 0.99)),
        "timer_tick_ms_max": float(clock.max()),
        "timer_tick_busy_ms_p50": float(np.quantile(busy, 0.5)),
        "timer_tick_busy_ms_p99": float(np.quantile(busy, 0.99)),
    }


if __name__ == "__main__":
    main()
