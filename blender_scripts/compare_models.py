#!/usr/bin/env python3
"""Compare contact models: one path of goals through each of them, and how their proxies differ.

The path is a take from a file (with the grid that it was felt on; this needs no Blender), or an animated
object of a scene. Times are of this machine, and compared with those of the first model.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

# Blender does not look for modules beside the script that it runs.
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pipeline.command import RefusedError, Say, own_arguments, parser_of, run

if TYPE_CHECKING:
    from pipeline.comparison import Numbers

ROOT = Path(__file__).resolve().parents[1]

READERS = (".csv", ".npz")


def main(arguments: list[str]) -> int:
    """Exit codes: see ``--help``."""
    return run(_parser(), arguments, _compare)


def _parser() -> argparse.ArgumentParser:
    parser = parser_of("compare_models.py", __doc__)
    parser.add_argument("--take", type=Path, metavar="FILE", help="exported take (.csv, .npz)")
    parser.add_argument("--grid", type=Path, metavar="FILE", help="elevation grid of the take")
    parser.add_argument("--blend", type=Path, metavar="FILE", help="scene; else the one that is open")
    parser.add_argument("--goal", metavar="NAME", help="object of the scene that moves")
    parser.add_argument("--bone", default="", metavar="NAME", help="of the goal, whose end is followed")
    parser.add_argument("--tip", choices=("head", "tail"), default="tail", help="of the bone (%(default)s)")
    parser.add_argument("--terrain", default="", metavar="NAME", help="else the only one")
    parser.add_argument(
        "--frames", type=int, nargs=2, default=(0, 0), metavar=("FIRST", "LAST"), help="else the scene's"
    )
    parser.add_argument("--models", metavar="A,B,...", help="else all")
    return parser


def _compare(chosen: argparse.Namespace, say: Say) -> Mapping[str, Any]:
    import numpy as np
    from pipeline.comparison import figures, follow_all, table
    from pipeline.machine import processor
    from pipeline.models import known_models

    names = known_models(chosen.models)
    if chosen.take is not None:
        contact, answer, goals, about = _from_take(chosen)
    elif chosen.goal is not None:
        contact, answer, goals, about = _from_scene(chosen)
    else:
        raise RefusedError("Name a path: --take FILE with --grid FILE, or --goal NAME in a scene.")
    say(f"{len(goals):,} goals through {', '.join(names)}")
    found = figures(
        follow_all(contact, answer, names, goals),
        1000.0 * answer.scale * np.array((1.0, 1.0, answer.window.exaggeration)),
    )
    print(table(found), file=sys.stderr)
    return {
        "machine": processor(),
        **about,
        "ticks": len(goals),
        "window_width_metres": answer.window.width,
        "exaggeration": answer.window.exaggeration,
        **found,
    }


def _from_take(chosen: argparse.Namespace) -> tuple[Any, Any, Numbers, dict[str, Any]]:
    """Read the path of a take and the grid below it."""
    if chosen.grid is None:
        raise RefusedError("--take needs --grid: the elevation grid that it was felt on.")
    if chosen.take.suffix.lower() not in READERS:
        raise RefusedError(f"{chosen.take}: expected a take that was exported as {' or '.join(READERS)}.")
    import numpy as np
    from proxygraph import Window

    sys.path.append(str(ROOT))  # of ``addon``
    from addon.formats import FormatError, read_grid
    from addon.formats.source_stamp import SourceStamp
    from addon.record import bake_contact
    from addon.record.about_properties import OtherTerrainError, check_same_terrain
    from addon.record.files.csv_file import read_csv
    from addon.record.files.npz_file import read_npz
    from addon.record.take_data import TakeAbout

    try:
        take = (read_csv if chosen.take.suffix.lower() == ".csv" else read_npz)(chosen.take).data
        described = read_grid(chosen.grid)
        grid = described.open()
        extent = grid.range()
        layout = grid.layout
        check_same_terrain(
            take.about,
            TakeAbout(
                terrain=described.title,
                source=described.data_path.name,
                rows=layout.rows,
                columns=layout.columns,
                cell_width=layout.cell_width,
                cell_height=layout.cell_height,
                wraps=layout.wraps,
                georeference=described.georeference,
                workspace_width=take.about.workspace_width,
                digest=SourceStamp.of(described.data_path).digest,
            ),
        )
    except (FormatError, OtherTerrainError) as error:
        raise RefusedError(str(error)) from error
    if extent is None or not len(take):
        raise RefusedError(f"{chosen.take}: there is nothing to touch, or no tick.")
    first = {name: float(values[0]) for name, values in take.columns.items()}
    window = Window(
        first["goal_east"],
        first["goal_north"],
        0.0,
        width=first["window_width"],
        exaggeration=first["window_exaggeration"],
    )
    answer = bake_contact.Answer(grid, extent.maximum, window, take.about.workspace_width, "surface_walk")
    notes = []
    if np.ptp(take.columns["window_width"]) > 0.0:
        notes.append("The hand zoomed in this take: all of it is compared on the scale of its first tick.")
    return (
        bake_contact,
        answer,
        _goals(take),
        {
            "path": chosen.take.name,
            "source": described.data_path.name,
            "synthetic": described.synthetic,
            "notes": notes,
        },
    )


def _from_scene(chosen: argparse.Namespace) -> tuple[Any, Any, Numbers, dict[str, Any]]:
    """Follow an animated object through its frames."""
    from pipeline.scene import enabled_parts, open_blend, refused

    parts = enabled_parts()
    open_blend(chosen.blend)
    import bpy

    bake, choices = parts("record.bake"), parts("ui.goal_choices")
    with refused():
        goal = choices.chosen_goal(bpy.context, chosen.goal, chosen.bone, chosen.tip.upper())
        terrain = choices.terrain_under(bpy.context, chosen.terrain)
        frames = choices.chosen_frames(bpy.context, *chosen.frames, bake.SAMPLES_PER_FRAME)
        described = bake.bake_of(bpy.context, goal, terrain, frames)
        result = parts("terrain.progress").finished(bake.baked(described))
    grid = parts("terrain.kept").recall(terrain).grid
    return (
        parts("record.bake_contact"),
        result.answer,
        _goals(result.data),
        {
            "path": goal.name,
            "frames": [frames.first, frames.last],
            "source": grid.data_path.name,
            "synthetic": grid.synthetic,
            "blender": bpy.app.version_string,
            "notes": [],
        },
    )


def _goals(take: Any) -> Numbers:
    import numpy as np

    return np.stack([take.columns[f"goal_{axis}"] for axis in ("east", "north", "up")], axis=1)


if __name__ == "__main__":
    sys.exit(main(own_arguments()))
