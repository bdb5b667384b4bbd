"""The proxy graph on real and on rough ground: what it costs, and how often it does what the paper says.

Prints tables, and writes all figures to build/bench/contact.json.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.bench import contact_quality, update_time  # noqa: E402
from tests.bench.grounds import Ground, planet, white_noise  # noqa: E402

OUTPUT = ROOT / "build" / "bench" / "contact.json"

Figures = dict[str, float | str]

PAPER = """\
The paper (section 4.4; 1/16 degree/pixel MOLA, a person's hand): 13.4 vertices per update on the fastest
swipe, 1.01 collision tests per update, no far-edge crossing unscaled; heights x20 on the walls of Valles
Marineris: far-edge crossings in 3.5% of updates, loops in 0.1% of the crossings. Section 3.4 claims that an
update ends at a local minimum, and that the distance never grows faster than the goal moves."""

QUALITY_NOTES = f"""\
Each line is a path of {contact_quality.UPDATES} updates; means and shares are of those in contact.
far edges: updates with at least one crossing. loops: share of the crossings. not minimal: judged by brute
force over the triangles that hold the proxy, and by whether the straight way to the goal is free. grew: the
distance grew by more than the goal moved. The hand is a script (0.2 cells above to 3 cells under a smoothed
surface): how deep it presses changes collision tests and far edges more than anything else does, so the
paper's figures are for comparison, not for equality."""

TIME_NOTES = f"""\
Session.step in blocks of {update_time.TICKS} ticks, {update_time.BLOCKS} blocks each, all shuffled in one
process; medians of ns per tick, and ratios to the same speed in the air. A tick is device read, contact,
spring, limits, record, histogram and two clock readings; in the air, ten cells up, contact is a ray only.
What this does not show: a live thread's wake-up and lateness; a real device's input and output (here it is a
script, whose lookup is part of every tick); cold memory, for the grid fits a processor's cache and is warm;
grids larger than that. Where the quartiles lie far apart, something else ran meanwhile: measure again on an
idle machine. Absolute numbers belong to this machine, ratios between lines of one run travel better."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grid", type=Path, help="label of MOLA topography at 4 pixels per degree")
    begin = time.monotonic()
    grounds = [*planet(parser.parse_args().grid), white_noise()]
    figures: Figures = {**machine(), "updates": contact_quality.UPDATES}
    print(f"{figures['cpu']}, {figures['cores']} cores, Python {figures['python']}")
    print(PAPER)
    for ground in grounds:
        figures |= show_quality(ground)
    print(f"\n{QUALITY_NOTES}")
    for ground in grounds:
        figures |= show_times(ground)
    print(f"\n{TIME_NOTES}")
    figures["bench_seconds"] = round(time.monotonic() - begin, 1)
    OUTPUT.parent.mkdir(parents=True, exist_ok=True)
    OUTPUT.write_text(json.dumps(figures, indent=1) + "\n")
    print(f"\nFigures: {OUTPUT.relative_to(ROOT)} ({figures['bench_seconds']} s)")
    deep = [name for name, value in figures.items() if name.endswith("under_surface_updates") and value]
    if deep:
        sys.exit(f"Updates ended under the surface, and there must be none: {', '.join(deep)}")


def machine() -> Figures:
    """What the figures were measured on."""
    model = platform.processor() or platform.machine()
    described = Path("/proc/cpuinfo")
    if described.is_file():
        for line in described.read_text().splitlines():
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    return {"cpu": model, "cores": os.cpu_count() or 0, "python": platform.python_version()}


def show_quality(ground: Ground) -> Figures:
    """A table of what the model does at each speed."""
    figures: Figures = {}
    print(f"\n{ground.title}: {ground.grid.layout.triangles} triangles")
    print(
        "     cells/  contact  vertices  tests     far   loops   cycles      not    grew   under\n"
        "     update        %       per update  edges%       %        %  minimal%       %   (count)"
    )
    for exaggeration in ground.exaggerations:
        for speed in contact_quality.SPEEDS:
            found = contact_quality.measure(ground, exaggeration, speed).figures()
            percent = {name: 100.0 * value for name, value in found.items()}
            print(
                f"x{exaggeration:<3}{speed:7g}{percent['in_contact_share']:9.1f}"
                f"{found['vertices_mean']:10.2f}{found['collision_tests_mean']:7.3f}"
                f"{percent['far_edge_updates_share']:8.2f}{percent['far_edge_loops_per_crossing']:8.2f}"
                f"{percent['cycles_ended_per_update']:9.3f}{percent['not_minimal_share']:10.3f}"
                f"{percent['grew_faster_than_goal_share']:8.3f}{found['under_surface_updates']:10.0f}"
            )
            key = f"{ground.key}_x{exaggeration}_{spoken(speed)}"
            figures |= {f"{key}_{name}": rounded(value) for name, value in found.items()}
    return figures


def show_times(ground: Ground) -> Figures:
    """A table of what a tick costs at each speed."""
    figures: Figures = {}
    contenders = update_time.measure(ground)
    in_air = {each.speed: each.median for each in contenders if not each.touches}
    print(f"\n{ground.title}: ns per tick (ratio to the air) [half the quartiles' distance, % of the median]")
    print(" " * 8 + "".join(f"{speed:>18g}" for speed in update_time.SPEEDS) + "  cells/update")
    for exaggeration in (0, *ground.exaggerations):
        line = f"x{exaggeration:<7}" if exaggeration else f"{'air':<8}"
        for each in contenders:
            if each.touches != bool(exaggeration) or (exaggeration and each.exaggeration != exaggeration):
                continue
            ratio = each.median / in_air[each.speed]
            line += f"{each.median:7.0f} ({ratio:4.2f}) [{100 * each.spread:2.0f}]"
            place = f"x{exaggeration}" if exaggeration else "air"
            key = f"{ground.key}_{place}_{spoken(each.speed)}"
            figures[f"{key}_tick_ns"] = round(each.median, 1)
            if exaggeration:
                figures[f"{key}_ratio_to_air"] = round(ratio, 3)
        print(line)
    return figures


def spoken(speed: float) -> str:
    """A speed as part of a name."""
    return f"{speed:g}".replace(".", "_") + "_cells"


def rounded(value: float) -> float:
    return value if isinstance(value, int) else round(value, 6)


if __name__ == "__main__":
    main()
