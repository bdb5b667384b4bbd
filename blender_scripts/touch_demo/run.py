"""The demo from import to picture, in a scene of its own."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from mathutils import Vector
from proxygraph import Grid, GridRange

from touch_demo.extension import Extension
from touch_demo.hand_path import Ground, hand_path, windows
from touch_demo.live_session import LiveTouch, touch_live
from touch_demo.picture import Frame, open_scene, render_picture, set_up_picture
from touch_demo.replay import replay
from touch_demo.report import report, table
from touch_demo.tour import MapPlace, Tour, tour_of

WORKSPACE = (0.16, 0.12, 0.12)
"""Metres: as wide as the hand's reach with common desktop devices."""


class GridRefusedError(ValueError):
    """The grid cannot be touched; the text says why."""


@dataclass(frozen=True)
class Stage:
    """A scene with a terrain in it, and what is known of its grid."""

    extension: Extension
    tour: Tour
    terrain: bpy.types.Object
    kept: Any
    """What the terrain object remembers of its grid (the extension's KeptTerrain)."""
    extent: GridRange
    ground: Ground


def stage(extension: Extension, grid_path: Path, preview_vertices: int, say: Callable[[str], None]) -> Stage:
    """Import a grid into an empty scene.

    Raises:
        GridRefusedError: the extension does not take the file.
    """
    _empty_scene()
    try:
        described = extension.formats.read_grid(grid_path)
        tour = tour_of(_map_place(described), synthetic=described.synthetic)
        say(f"Importing {grid_path.name}")
        bpy.ops.haptic_terrain.import_grid(
            filepath=str(grid_path.resolve()), vertex_budget=preview_vertices, exaggeration=tour.exaggeration
        )
    except extension.formats.FormatError as error:
        raise GridRefusedError(str(error)) from error
    except RuntimeError as error:  # what Blender makes of an operator's report
        raise GridRefusedError(str(error).removeprefix("Error: ").strip()) from error
    terrain = bpy.context.view_layer.objects.active
    kept = extension.kept.recall(terrain)
    grid: Grid = kept.grid.open()
    extent = grid.range()
    if terrain is None or extent is None:
        raise GridRefusedError("the import left no terrain")
    say(f"{kept.grid.title}: {kept.grid.samples:,} samples, {len(terrain.data.vertices):,} of them shown")
    return Stage(extension, tour, terrain, kept, extent, _ground(extension, kept, grid, extent))


def run(staged: Stage, folder: Path, say: Callable[[str], None]) -> str:
    """Touch, record and render; writes touch.png, touch.blend and touch.json, gives the table."""
    ground, tour = staged.ground, staged.tour
    chosen = windows(ground, tour, staged.kept.frame.exaggeration, WORKSPACE)
    path = hand_path(ground, tour, chosen, WORKSPACE[0])
    say(f"Touching for {path.seconds:.1f} s at 1 kHz, with {len(path.swipes)} fast swipes first")
    touched = touch_live(staged.extension, staged.terrain, path, chosen, WORKSPACE, say)
    say("Stepping two contact models along the same path")
    replayed = replay(ground.grid, path, chosen, WORKSPACE)
    figures = report(staged.kept, staged.extent, touched, replayed)

    _frame_range(touched)
    set_up_picture(staged.terrain, touched.trail, _picture_frame(staged.kept, ground, tour, touched))
    # The take stands where the cursor stands: one of them is enough in the picture.
    touched.take.hide_render = True
    say("Rendering the picture")
    render_picture(folder / "touch.png")
    touched.take.hide_render = False
    say("Saving the scene")
    bpy.ops.wm.save_as_mainfile(filepath=str((folder / "touch.blend").resolve()), compress=True)
    (folder / "touch.json").write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    say("Done")
    return "\n" + table(figures)


def _empty_scene() -> None:
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)


def _map_place(grid: Any) -> MapPlace:
    """Find the limits of a grid (the extension's ElevationGrid)."""
    georeference, layout = grid.georeference, grid.layout
    return MapPlace(
        body=georeference.body,
        west=georeference.x(-0.5),
        east=georeference.x(layout.columns - 0.5),
        south=georeference.y(layout.rows - 0.5),
        north=georeference.y(-0.5),
        spans_the_globe=layout.wraps,
    )


def _ground(extension: Extension, kept: Any, grid: Grid, extent: GridRange) -> Ground:
    georeference = kept.grid.georeference
    return Ground(
        laid=extension.workspace,
        grid=grid,
        west=georeference.x(-0.5),
        north=georeference.y(-0.5),
        cells_per_degree=1.0 / georeference.step_x,
        lowest=extent.minimum,
        highest=extent.maximum,
    )


def _frame_range(touched: LiveTouch) -> None:
    """Let playback cover the take, and stand at its end."""
    scene = open_scene()
    scene.frame_end = max(scene.frame_start, scene.frame_start + touched.keyframes // 3 - 1)
    scene.frame_set(scene.frame_end)


def _picture_frame(kept: Any, ground: Ground, tour: Tour, touched: LiveTouch) -> Frame:
    frame = kept.frame
    east, north = ground.terrain(*tour.centre)
    up = ground.grid.elevation_at(east, north)
    across = tour.picture_degrees * ground.cells_per_degree * ground.grid.layout.cell_width
    title = kept.grid.title.replace("_", " ")
    return Frame(
        centre=Vector(frame.to_object(east, north, frame.up if up is None else up)),
        across=across * frame.units_per_metre,
        caption=f"{title}   heights \N{MULTIPLICATION SIGN}{frame.exaggeration:g}   touched at 1 kHz",
        strongest=_strongest(touched),
    )


def _strongest(touched: LiveTouch) -> float:
    """Newtons at the end of the trail's colours."""
    if touched.trail is None:
        return 0.0
    force = touched.trail.data.attributes["force"].data
    values = np.empty(len(force), np.float32)
    force.foreach_get("value", values)
    return float(values.max())
