"""Measure recording, what a take becomes, and baking; ``make bench-recording`` runs this.

Each part needs a process of its own, and is measured by a script beside this one.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

from tests.bench.goals import Figures, Goal, print_goals  # noqa: E402
from tests.bench.machine import machine_figures, machine_line  # noqa: E402
from tests.bench.measured_by import measured_by  # noqa: E402

BESIDE = ("measure_spool.py", "measure_takes.py", "measure_bake.py")

GOALS = [
    Goal("ticks_lost_in_10_min", 0.0),
    Goal("ticks_lost_on_disk_in_10_min", 0.0),
    Goal("record_bytes_per_minute"),
    Goal("memory_bytes_per_minute"),
    Goal("fcurves_seconds_per_recorded_minute", 0.1),
    Goal("reduced_keys_share", 0.05),
    Goal("reduced_keys_share_of_scene_frames"),
    Goal("reduced_error_over_bound_max", 1.0),
    Goal("reduced_frames_under_ground", 0.0),
    Goal("bake_realtime_factor", 50.0, at_least=True),
]
"""``reduced_keys_share`` is of the recorded ticks, each of them a frame that is checked."""


def main() -> None:
    """Measure, print and write the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, help="recording.json")
    output = parser.parse_args().output
    figures: Figures = {**machine_figures()}
    for script in BESIDE:
        figures |= measured_by(Path(__file__).with_name(script))
    at_scene_rate = float(figures["reduced_keys_at_scene_rate"]) / float(figures["frames_at_scene_rate"])
    figures["reduced_keys_share_of_scene_frames"] = round(at_scene_rate, 4)
    output.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    print_goals(f"Recording and baking ({machine_line()}; the synthetic grid)", GOALS, figures)
    print(f"Figures: {output}")


if __name__ == "__main__":
    main()
