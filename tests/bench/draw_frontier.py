"""Draw the frontier of contact models, error against time, from the figures of ``make bench-contact``."""

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

SPEEDS = ("0_3", "1", "3_4", "13_4", "50")
"""Cells per update, as in the names of figures."""

PANELS = {"x20": "Mars-like ground, heights x20", "x20_canyon": "canyon walls, heights x20"}

LEAST_PERCENT = 0.03
"""Below this the scale is linear, so that an error of zero has a place."""


@dataclass(frozen=True)
class Curve:
    """A model in the picture."""

    key: str
    name: str
    colour: str
    """Of the palette of Okabe and Ito (2008), which the colour-blind can tell apart."""
    marker: str
    dashes: str = "-"


CURVES = (
    Curve("surface_walk", "surface walk", "#0072B2", "o"),
    Curve("surface_walk_sub_1", "surface walk, sub-steps of 1 cell", "#56B4E9", "s", "--"),
    Curve("surface_walk_sub_0_25", "surface walk, sub-steps of 1/4 cell", "#009E73", "D", ":"),
    Curve("proxy_graph", "proxy graph (the paper's)", "#D55E00", "^"),
    Curve("god_object_release", "god-object with release", "#CC79A7", "v", "-."),
    Curve("god_object", "god-object without release", "#000000", "x", ":"),
    Curve("virtual_proxy", "virtual proxy (sphere)", "#E69F00", "P", "--"),
)

LABELLED = {"surface_walk": (10, -13), "proxy_graph": (0, 7), "god_object_release": (0, -15)}
"""Curves whose points show the speed, and where beside a point, in points."""


def main() -> None:
    """Read figures, write the picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("figures", type=Path, help="contact.json")
    parser.add_argument("picture", type=Path, help="the PNG to write")
    options = parser.parse_args()
    try:
        draw(json.loads(options.figures.read_text()), options.picture)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"{options.figures} does not hold the figures of make bench-contact: {error!r}")


def draw(figures: Figures, picture: Path) -> None:
    """Write the picture.

    Raises:
        KeyError: a figure is missing.
    """
    mpl.use("Agg")
    plt.rcParams.update({"font.size": 11, "axes.spines.top": False, "axes.spines.right": False})
    figure, panels = plt.subplots(1, len(PANELS), figsize=(11, 5.6), sharey=True)
    for axes, (scene, title) in zip(panels, PANELS.items(), strict=True):
        _draw_panel(axes, figures, scene, title)
    panels[0].set_ylabel("updates over half a cell from the exact proxy, %")
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="lower center", ncols=3, frameon=False)
    figure.suptitle("Contact models: time of an update against where it ends", fontweight="bold")
    figure.tight_layout(rect=(0, 0.15, 1, 1))
    picture.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(picture, dpi=100)
    plt.close(figure)


def _draw_panel(axes: Axes, figures: Figures, scene: str, title: str) -> None:
    for curve in CURVES:
        times = [float(figures[f"{scene}_{speed}_{curve.key}_hot_ns"]) / 1e3 for speed in SPEEDS]
        errors = [100 * float(figures[f"{scene}_{speed}_{curve.key}_miss"]) for speed in SPEEDS]
        axes.plot(
            times,
            errors,
            curve.dashes,
            color=curve.colour,
            marker=curve.marker,
            markersize=7,
            linewidth=1.6,
            label=curve.name,
        )
        if curve.key in LABELLED:
            _label_speeds(axes, times, errors, curve)
    axes.set_xscale("log")
    axes.set_yscale("symlog", linthresh=LEAST_PERCENT, linscale=0.4)
    axes.set_ylim(-LEAST_PERCENT / 3, 100)
    ticks = [0, 0.1, 1, 10, 100]
    axes.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.grid(visible=True, alpha=0.25)
    axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200], minor=False)
    axes.xaxis.set_major_formatter(lambda value, _position: f"{value:g}")
    axes.set_xlabel("median time of an update, us, hot cache (labels: cells per update)")
    axes.set_title(title)


def _label_speeds(axes: Axes, times: list[float], errors: list[float], curve: Curve) -> None:
    for speed, time, error in zip(SPEEDS, times, errors, strict=True):
        axes.annotate(
            speed.replace("_", "."),
            (time, error),
            textcoords="offset points",
            xytext=LABELLED[curve.key],
            ha="center",
            fontsize=9,
            color=curve.colour,
        )


if __name__ == "__main__":
    main()
