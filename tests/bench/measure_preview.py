"""Measure what it costs Blender to show the ground finely around a hand that pans and zooms.

A scripted hand goes over a synthetic planet of 11520 x 5760 samples: swipes and slow creeping, across the
seam and along the map's edges, while the view comes nearer and goes away. Every refresh of the shown mesh is
timed on Blender's main thread, its evaluation of what was written included; drawing is not, without a screen.
Where other programs take the processor, the time of the clock is much longer than that of the thread's work.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

ROWS, COLUMNS = 5760, 11_520

PLACES = 12
"""Places on the way between two of the path's corners."""


@dataclass(frozen=True)
class Figures:
    """What was measured."""

    milliseconds: list[float]
    """That each refresh holds Blender's main thread up, by the clock."""
    busy_milliseconds: list[float]
    """That the thread worked meanwhile."""
    most_vertices: int
    budget: int
    """Vertices that the terrain may have."""
    shown_vertices: int
    """That were allowed at the end: as many as were written quickly."""
    open_edges_inside: int
    """Of all meshes together, apart from the map's edges."""


def main() -> None:
    """Measure, and print the figures as JSON; write them where a path is given."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, nargs="?", help="preview.json")
    parser.add_argument("--grid", type=Path, default=None, help="another grid than the synthetic one")
    parser.add_argument("--refreshes", type=int, default=400)
    options = parser.parse_args()
    folder = ROOT / "build" / "bench"
    figures = refresh_figures(options.grid or synthetic_grid(folder), refreshes=options.refreshes)
    result = {
        "preview_refresh_ms_p50": _percentile(figures.milliseconds, 50),
        "preview_refresh_ms_p99": _percentile(figures.milliseconds, 99),
        "preview_refresh_busy_ms_p50": _percentile(figures.busy_milliseconds, 50),
        "preview_refresh_busy_ms_p99": _percentile(figures.busy_milliseconds, 99),
        "preview_vertices_max": figures.most_vertices,
        "preview_vertices_budget": figures.budget,
        "preview_vertices_steered": figures.shown_vertices,
        "preview_open_edges_inside": figures.open_edges_inside,
        "preview_refreshes": len(figures.milliseconds),
    }
    text = json.dumps(result, indent=1)
    if options.output is not None:
        options.output.parent.mkdir(parents=True, exist_ok=True)
        options.output.write_text(f"{text}\n", encoding="utf-8")
    print(text)


def _percentile(milliseconds: list[float], share: float) -> float:
    return round(float(np.percentile(milliseconds, share)), 2)


def refresh_figures(grid: Path, *, refreshes: int) -> Figures:
    """Import a grid, lead a hand over it, and time every refresh.

    ``BLENDER_USER_RESOURCES`` must be set, as for every script that enables the extension.
    """
    import bpy
    from enable_addon import enable

    bpy.ops.wm.read_factory_settings(use_empty=True)
    enable()
    from tests.addon.scene import module

    bpy.ops.haptic_terrain.import_grid(filepath=str(grid.resolve()))
    terrain: Any = bpy.context.view_layer.objects.active
    kept = module("terrain.kept").recall(terrain)
    placement = module("touch.placement").Placement.of(terrain, kept.frame)
    detail = module("touch.detail").Detail(kept.grid.open(), kept)
    shown_mesh = module("terrain.levels_object").shown_levels
    milliseconds: list[float] = []
    busy_milliseconds: list[float] = []
    most_vertices = open_edges = 0
    before = None
    for east, north, pixels_per_unit in hand_path(kept.grid.layout, placement):
        detail.wait()
        began, began_work = time.perf_counter(), time.thread_time()
        detail.follow(terrain, placement, east, north, pixels_per_unit)
        bpy.context.view_layer.update()
        took, worked = time.perf_counter() - began, time.thread_time() - began_work
        if detail.surface is before:
            continue
        first, before = before is None, detail.surface
        if first:
            continue  # the mesh was made: that is part of starting touch
        milliseconds.append(1000.0 * took)
        busy_milliseconds.append(1000.0 * worked)
        mesh = shown_mesh(terrain)
        most_vertices = max(most_vertices, len(mesh.vertices))
        open_edges += open_edges_inside(mesh, kept.frame, kept.grid.layout)
        if len(milliseconds) >= refreshes:
            break
    detail.put_away()
    detail.end()
    steered = detail.steering.budget
    return Figures(milliseconds, busy_milliseconds, most_vertices, kept.vertex_budget, steered, open_edges)


def hand_path(layout: Any, placement: Any) -> Iterator[tuple[float, float, float]]:
    """Metres east and north, and pixels of a Blender unit, without an end."""
    random = np.random.default_rng(2003)
    across, down = layout.columns * layout.cell_width, layout.rows * layout.cell_height
    corner = np.array([0.5, 0.5, 0.0])
    while True:
        # East runs on over the seam, north stops at the edges; and the view is up to 256 times nearer.
        step = random.normal(0.0, 1.0, 3) * random.choice([0.002, 0.02, 0.2]) * [1.0, 1.0, 8.0]
        goal = corner + step
        goal[1], goal[2] = np.clip(goal[1], 0.0, 1.0), np.clip(goal[2], 0.0, 8.0)
        for share in np.linspace(0.0, 1.0, PLACES, endpoint=False):
            east, south, nearer = corner + share * (goal - corner)
            whole = 1000.0 / placement.longest_side(layout)
            yield float(east * across), float(-south * down), float(whole * 2.0**nearer)
        corner = goal


def open_edges_inside(mesh: Any, frame: Any, layout: Any) -> int:
    """Count the edges with one triangle that are not on the map's edge, folded triangles left out."""
    corners = read(mesh.attributes[".corner_vert"], "value", 3 * len(mesh.polygons), np.int32).reshape(-1, 3)
    edges = read(mesh.attributes[".corner_edge"], "value", 3 * len(mesh.polygons), np.int32).reshape(-1, 3)
    ends = read(mesh.attributes[".edge_verts"], "value", 2 * len(mesh.edges), np.int32).reshape(-1, 2)
    places = read(mesh.attributes["position"], "vector", 3 * len(mesh.vertices), np.float32).reshape(-1, 3)
    unfolded = edges[:, 0] != len(mesh.edges) - 3
    corners, edges = corners[unfolded], edges[unfolded]
    joined = np.sort(np.stack((corners, np.roll(corners, -1, axis=1)), axis=-1), axis=-1)
    if not (joined == np.sort(ends[edges], axis=-1)).all():
        raise ValueError("an edge of a triangle does not join its corners")
    opened = ends[np.bincount(edges.ravel(), minlength=len(ends)) == 1]
    unit = frame.units_per_metre
    columns = np.round((places[opened, 0] / unit + frame.east) / layout.cell_width)
    rows = np.round(-(places[opened, 1] / unit + frame.north) / layout.cell_height)
    last = layout.columns if layout.wraps else layout.columns - 1
    sides = (columns == 0, columns == last, rows == 0, rows == layout.rows - 1)
    on_edge = np.any([side.all(axis=1) for side in sides], axis=0)
    return int(np.count_nonzero(~on_edge))


def read(attribute: Any, name: str, count: int, kind: Any) -> npt.NDArray[Any]:
    """The values of a mesh's attribute."""
    values = np.empty(count, dtype=kind)
    attribute.data.foreach_get(name, values)
    return values


def synthetic_grid(folder: Path) -> Path:
    """Write a planet of hills in all sizes, once; gives its label."""
    label = folder / "preview.lbl"
    if not label.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        row, column = np.arange(ROWS)[:, None], np.arange(COLUMNS)
        heights = np.zeros((ROWS, COLUMNS), dtype=np.float32)
        for octave in range(1, 11):
            waves = 2**octave
            turn = 2.0 * math.pi * waves
            heights += (8000.0 / waves) * (
                np.sin(turn * column / COLUMNS + octave) * np.cos(turn * row / COLUMNS + 2.0 * octave)
            ).astype(np.float32)
        heights.astype(">i2").tofile(folder / "preview.img")
        label.write_text("\r\n".join(_label_lines()), encoding="ascii", newline="")
    return label


def _label_lines() -> list[str]:
    return [
        "PDS_VERSION_ID = PDS3",
        "RECORD_TYPE = FIXED_LENGTH",
        f"RECORD_BYTES = {2 * COLUMNS}",
        '^IMAGE = "PREVIEW.IMG"',
        'DATA_SET_ID = "SYNTHETIC"',
        'TARGET_NAME = "MARS"',
        "OBJECT = IMAGE",
        f"LINES = {ROWS}",
        f"LINE_SAMPLES = {COLUMNS}",
        "SAMPLE_TYPE = MSB_INTEGER",
        "SAMPLE_BITS = 16",
        "END_OBJECT = IMAGE",
        "OBJECT = IMAGE_MAP_PROJECTION",
        'MAP_PROJECTION_TYPE = "SIMPLE CYLINDRICAL"',
        f"MAP_RESOLUTION = {ROWS // 180} <PIXEL/DEGREE>",
        "A_AXIS_RADIUS = 3396.0 <KM>",
        'POSITIVE_LONGITUDE_DIRECTION = "EAST"',
        "MAXIMUM_LATITUDE = 90.0",
        "MINIMUM_LATITUDE = -90.0",
        "WESTERNMOST_LONGITUDE = 0.0",
        "EASTERNMOST_LONGITUDE = 360.0",
        "END_OBJECT = IMAGE_MAP_PROJECTION",
        "END",
        "",
    ]


if __name__ == "__main__":
    main()
