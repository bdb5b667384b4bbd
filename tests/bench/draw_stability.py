"""Draw the map of stability, stiffness against servo rate, from the figures of ``make bench-servo``."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
from matplotlib.axes import Axes

Figures = Mapping[str, float | str]

RATES = (250, 500, 1000, 2000, 4000)
"""Hertz, as in the names of figures."""

DAMPINGS = {"0_5": "0.5", "2": "2", "8": "8"}
"""N s/m: as in the names of figures, and as people write them."""


@dataclass(frozen=True)
class Delay:
    """A delay from reading to pushing."""

    ticks: int
    name: str
    colour: str
    """Of the palette of Okabe and Ito (2008), which the colour-blind can tell apart."""
    marker: str


DELAYS = (
    Delay(0, "pushes in the same tick", "#0072B2", "o"),
    Delay(1, "one tick late", "#D55E00", "^"),
    Delay(2, "two ticks late", "#009E73", "s"),
)


def main() -> None:
    """Read figures, write the picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("figures", type=Path, help="servo.json")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    options = parser.parse_args()
    try:
        draw(json.loads(options.figures.read_text()), options.picture)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"{options.figures} does not hold the figures of make bench-servo: {error!r}")


def draw(figures: Figures, picture: Path) -> None:
    """Write the picture.

    Raises:
        KeyError: a figure is missing.
    """
    mpl.use("Agg")
    plt.rcParams.update({"font.size": 11, "axes.spines.top": False, "axes.spines.right": False})
    figure, panels = plt.subplots(1, len(DAMPINGS), figsize=(12, 5.6), sharey=True)
    for axes, (damping, title) in zip(panels, DAMPINGS.items(), strict=True):
        for delay in DELAYS:
            _draw_delay(axes, figures, damping, delay)
        _finish(axes, f"device damping {title} N s/m")
    panels[0].set_ylabel("virtual stiffness, N/m")
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="lower center", ncols=3, frameon=False)
    figure.suptitle("The stiffest stable spring: measured in closed loop, beside theory", fontweight="bold")
    figure.tight_layout(rect=(0, 0.17, 1, 1))
    picture.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(picture, dpi=100)
    plt.close(figure)


def _draw_delay(axes: Axes, figures: Figures, damping: str, delay: Delay) -> None:
    def stiffness(ending: str) -> list[float]:
        names = [f"stiffness_{rate}hz_b{damping}_d{delay.ticks}{ending}" for rate in RATES]
        return [float(figures[name]) for name in names]

    theory = f"2b/({2 * delay.ticks + 1}T)" if delay.ticks else "2b/T"
    axes.plot(
        RATES,
        stiffness("_theory"),
        "-",
        color=delay.colour,
        linewidth=1.4,
        label=f"{delay.name}: theory, {theory}",
    )
    measured, within_counts = axes.plot(
        *(RATES, stiffness("")),
        *(RATES, stiffness("_still")),
        color=delay.colour,
        marker=delay.marker,
        markersize=7,
        linestyle="none",
    )
    measured.set_label("measured: ends below 0.1 mm")
    within_counts.set_label("measured: ends within 20 um")
    within_counts.set_markerfacecolor("none")
    within_counts.set_markersize(11)


def _finish(axes: Axes, title: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.minorticks_off()
    axes.set_xticks(RATES, [f"{rate}" for rate in RATES])
    axes.yaxis.set_major_formatter(lambda value, _position: f"{value:g}")
    axes.grid(visible=True, alpha=0.25)
    axes.set_xlabel("servo rate, Hz")
    axes.set_title(title)


if __name__ == "__main__":
    main()
