"""The demo's way over a map, and what it says of grids that it cannot use."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from proxygraph import Grid, GridLayout, Window
from touch_demo.hand_path import SWIPE_CELLS_PER_UPDATE, Ground, HandPath, hand_path, windows
from touch_demo.replay import MODELS, parts, replay
from touch_demo.tour import MARS, SYNTHETIC, MapPlace, Tour, tour_of

ROOT = Path(__file__).resolve().parents[2]

if str(ROOT) not in sys.path:
    sys.path.append(str(ROOT))

from addon.touch import workspace  # noqa: E402

WORKSPACE = (0.16, 0.12, 0.12)
EXAGGERATION = 15.0


def whole(body: str, west: float = 0.0, east: float = 360.0) -> MapPlace:
    """A map from pole to pole."""
    return MapPlace(body, west, east, south=-90.0, north=90.0, spans_the_globe=east - west == 360.0)


@pytest.fixture(scope="module")
def ground() -> Ground:
    rows, columns, cell = 720, 1440, 14_818.0
    heights = np.zeros((rows, columns), dtype=">i2")
    heights[300:320] = 8000
    layout = GridLayout(rows, columns, cell_width=cell, cell_height=cell, wraps=True)
    return Ground(workspace, Grid.from_buffer(heights.tobytes(), layout), 0.0, 90.0, 4.0, 0.0, 8000.0)


@pytest.fixture(scope="module", params=[MARS, SYNTHETIC], ids=["mars", "synthetic"])
def tour(request: pytest.FixtureRequest) -> Tour:
    chosen: Tour = request.param
    return chosen


@pytest.fixture(scope="module")
def chosen(ground: Ground, tour: Tour) -> list[Window]:
    return windows(ground, tour, EXAGGERATION, WORKSPACE)


@pytest.fixture(scope="module")
def path(ground: Ground, tour: Tour, chosen: list[Window]) -> HandPath:
    return hand_path(ground, tour, chosen, WORKSPACE[0])


def test_time_only_goes_forward_and_lasts_for_five_seconds(path: HandPath) -> None:
    assert all(earlier[0] < later[0] for earlier, later in pairwise(path.points))
    assert path.seconds == pytest.approx(path.points[-1][0])
    assert path.seconds > 5.0


def test_swipes_are_as_fast_as_the_papers(path: HandPath, ground: Ground, chosen: list[Window]) -> None:
    cell = WORKSPACE[0] / chosen[0].width * ground.grid.layout.cell_width
    for begin, end in path.swipes:
        within = [point for point in path.points if begin <= point[0] <= end]
        travelled = sum(math.dist(a[1:3], b[1:3]) for a, b in pairwise(within))
        assert travelled / cell > 0.9 * ground.grid.layout.columns
        updates = (end - begin) * 1000.0
        assert travelled / cell / updates == pytest.approx(SWIPE_CELLS_PER_UPDATE, rel=0.01)


def test_the_replay_has_every_millisecond_of_the_path_once(path: HandPath) -> None:
    cut = list(parts(path))
    assert sum(part.ticks for part in cut) == round(path.seconds * 1000.0)
    assert all(part.ticks > 0 for part in cut)
    swiped = [part.ticks for part in cut if part.is_swipe]
    assert swiped == [round(1000.0 * (end - begin)) for begin, end in path.swipes]
    assert [part.window for part in cut] == [0] * (len(cut) - 1) + [1]
    assert sum(part.ticks for part in cut[:-1]) == round(path.explore_at * 1000.0)


def test_replayed_models_get_the_same_goals(path: HandPath, ground: Ground, chosen: list[Window]) -> None:
    found = replay(ground.grid, path, chosen, WORKSPACE)
    assert tuple(found) == MODELS
    walk, graph = (found[model] for model in MODELS)
    for one, other in ((walk.statistics, graph.statistics), (walk.swipes, graph.swipes)):
        assert (one.ticks, one.goal_cells) == (other.ticks, other.goal_cells)
        assert 0 < one.contact_ticks <= one.ticks
    assert graph.swipes.goal_cells / graph.swipes.ticks == pytest.approx(SWIPE_CELLS_PER_UPDATE, rel=0.01)
    assert graph.swipes.vertices > graph.swipes.ticks


def test_hand_stays_within_reach(path: HandPath) -> None:
    for _time, *place in path.points:
        for where, reach in zip(place, WORKSPACE, strict=True):
            assert abs(where) <= 0.5 * reach


def test_window_changes_only_in_the_air(path: HandPath, ground: Ground, chosen: list[Window]) -> None:
    around = [(a, b) for a, b in pairwise(path.points) if a[0] <= path.explore_at <= b[0]]
    assert around
    for a, b in around:
        for window in chosen:
            summit = (ground.highest - window.up) * EXAGGERATION * WORKSPACE[0] / window.width
            assert min(a[3], b[3]) > summit


def test_tour_presses_lifts_and_presses_again(tour: Tour) -> None:
    touching = [stop.press > 0.0 for stop in tour.stops]
    changes = [touching[0], *(a != b for a, b in pairwise(touching))]
    assert sum(changes) >= 3
    assert touching[-1], "the picture shows the cursor in contact"


def test_tour_follows_the_body() -> None:
    assert tour_of(whole("Mars"), synthetic=False) is MARS
    assert tour_of(whole("Anything"), synthetic=True) is SYNTHETIC
    region = tour_of(whole("Mars", 10.0, 20.0), synthetic=False)
    assert all(10.0 < stop.longitude < 20.0 for stop in region.stops)


@pytest.mark.parametrize("name", ["missing.lbl", "empty.lbl", "picture.png"])
def test_wrong_grid_is_one_line_and_leaves_nothing(name: str, tmp_path: Path) -> None:
    grid, output = tmp_path / name, tmp_path / "results" / "demo"
    if name != "missing.lbl":
        grid.write_text("")
    ended = subprocess.run(
        [sys.executable, ROOT / "blender_scripts/demo.py", "--grid", grid, "--output", output],
        env=os.environ | {"BLENDER_USER_RESOURCES": str(tmp_path / "blender")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert ended.returncode == 2
    assert ended.stderr.count("\n") == 1
    assert ended.stderr.startswith("GRID: ")
    assert name in ended.stderr
    assert not output.parent.exists()


def test_make_demo_writes_nothing_into_the_home_folder(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    # The flags of a make that runs these tests must not reach this one.
    clean = {
        key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MFLAGS", "XDG_"))
    }
    wrong_grid = tmp_path / "missing.lbl"
    planned = subprocess.run(
        ["make", "--dry-run", "demo", f"PYTHON={sys.executable}", f"GRID={wrong_grid}"],
        cwd=ROOT,
        env=clean,
        capture_output=True,
        text=True,
        check=True,
    )
    (recipe,) = [line for line in planned.stdout.splitlines() if "demo.py" in line]
    ended = subprocess.run(
        ["bash", "-c", recipe],
        cwd=ROOT,
        env=clean | {"HOME": str(home), "BLENDER_USER_RESOURCES": str(tmp_path / "blender")},
        check=False,
    )
    assert ended.returncode == 2, "it went as far as refusing the grid"
    assert list(home.rglob("*")) == []
