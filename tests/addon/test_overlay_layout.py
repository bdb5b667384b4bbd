"""Where the overlay puts what, and what it says: without drawing."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from proxygraph import GridLayout, Window

from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough

WORKSPACE = (0.16, 0.12, 0.12)


def rect(*sides: float) -> Any:
    return module("overlay.rect").Rect(*sides)


def layout(*, wraps: bool = True) -> GridLayout:
    """A planet of 360 x 180 km, or a map of nearly that."""
    return GridLayout(181, 360, cell_width=1000.0, cell_height=1000.0, wraps=wraps)


def chart(*, wraps: bool = True) -> Any:
    """A map of 240 x 120 pixels with its upper right corner at (1000, 700)."""
    return module("overlay.overview_map").overview_map(
        rect(0.0, 0.0, 1000.0, 700.0), layout(wraps=wraps), 1.0
    )


def test_what_covers_a_region_is_left_free() -> None:
    uncovered = module("overlay.rect").uncovered
    region = rect(0.0, 20.0, 1000.0, 700.0)
    sidebar, toolbar = rect(800.0, 20.0, 1000.0, 650.0), rect(0.0, 100.0, 60.0, 650.0)
    header, beside = rect(0.0, 660.0, 1000.0, 700.0), rect(0.0, 0.0, 1000.0, 20.0)
    covering = [("RIGHT", sidebar), ("LEFT", toolbar), ("TOP", header), ("BOTTOM", beside)]
    assert uncovered(region, covering) == rect(60.0, 20.0, 800.0, 660.0)
    assert uncovered(region, []) == region


def test_a_line_is_cut_at_the_edges_of_a_rectangle() -> None:
    clipped = module("overlay.rect").clipped
    box = rect(0.0, 0.0, 10.0, 10.0)
    assert clipped(((-5.0, 5.0), (15.0, 5.0)), box) == ((0.0, 5.0), (10.0, 5.0))
    assert clipped(((2.0, 2.0), (3.0, 4.0)), box) == ((2.0, 2.0), (3.0, 4.0))
    assert clipped(((-5.0, 5.0), (5.0, 15.0)), box) is None or box.contains(0.0, 10.0)
    assert clipped(((-5.0, 20.0), (15.0, 20.0)), box) is None
    assert clipped(((20.0, -5.0), (20.0, 15.0)), box) is None


def test_the_map_is_in_the_upper_right_corner_and_has_the_shape_of_the_grid() -> None:
    shown = chart().rect
    assert (shown.right, shown.top) == (1000.0, 700.0)
    assert (shown.width, shown.height) == (240.0, 120.0)


def test_the_map_shrinks_with_its_region_and_goes_where_it_would_be_too_small() -> None:
    overview_map = module("overlay.overview_map").overview_map
    narrow = overview_map(rect(0.0, 0.0, 400.0, 300.0), layout(), 1.0).rect
    assert narrow.width == pytest.approx(140.0)
    assert narrow.height == pytest.approx(70.0)
    assert overview_map(rect(0.0, 0.0, 100.0, 100.0), layout(), 1.0) is None
    assert overview_map(rect(0.0, 0.0, -5.0, 100.0), layout(), 1.0) is None
    assert overview_map(rect(0.0, 0.0, 2000.0, 1400.0), layout(), 2.0).rect.width == pytest.approx(480.0)


def test_pixels_of_the_map_and_terrain_places_are_each_others_inverse() -> None:
    shown = chart()
    for east, north in ((0.0, 0.0), (90_000.0, -45_000.0), (359_000.0, -180_000.0)):
        assert shown.place(*shown.at(east, north)) == pytest.approx((east, north))
    assert shown.at(360_000.0 + 90_000.0, 0.0) == pytest.approx(shown.at(90_000.0, 0.0))


def ends(segments: list[Any]) -> list[tuple[float, float]]:
    return [end for segment in segments for end in segment]


def test_a_window_is_a_turned_rectangle_on_the_map() -> None:
    shown = chart()
    window = Window(180_000.0, -90_000.0, 0.0, width=80_000.0, turn=math.pi / 2.0)
    segments = shown.outline(window, WORKSPACE, 1.0)
    assert len(segments) == 4
    xs, ys = zip(*ends(segments), strict=True)
    middle = shown.at(180_000.0, -90_000.0)
    pixel = 240.0 / 360_000.0
    assert (min(xs), max(xs)) == pytest.approx((middle[0] - 30_000 * pixel, middle[0] + 30_000 * pixel))
    assert (min(ys), max(ys)) == pytest.approx((middle[1] - 40_000 * pixel, middle[1] + 40_000 * pixel))


@pytest.mark.parametrize("turns", [-2, 0, 3])
def test_a_window_on_the_seam_is_drawn_at_both_sides_of_the_map(turns: int) -> None:
    shown = chart()
    window = Window(turns * 360_000.0 + 5_000.0, -90_000.0, 0.0, width=60_000.0)
    segments = shown.outline(window, WORKSPACE, 1.0)
    assert all(shown.rect.contains(round(x, 6), round(y, 6)) for x, y in ends(segments))
    xs = [x for x, _y in ends(segments)]
    assert min(xs) == pytest.approx(shown.rect.left)
    assert max(xs) == pytest.approx(shown.rect.right)
    upright = {round(one[0], 3) for one, other in segments if one[0] == pytest.approx(other[0])}
    west, east = shown.at(335_000.0, 0.0)[0], shown.at(35_000.0, 0.0)[0]
    assert upright == {round(west, 3), round(east, 3)}, "the seam itself is no edge of the window"


def test_a_window_beside_a_map_with_edges_is_cut_and_does_not_come_back() -> None:
    shown = chart(wraps=False)
    segments = shown.outline(Window(0.0, -90_000.0, 0.0, width=60_000.0), WORKSPACE, 1.0)
    assert max(x for x, _y in ends(segments)) < shown.rect.left + 0.1 * shown.rect.width
    assert shown.outline(Window(-1e6, -90_000.0, 0.0, width=60_000.0), WORKSPACE, 1.0) == []


def test_a_window_that_holds_the_whole_planet_has_no_outline() -> None:
    assert chart().outline(Window(180_000.0, -90_000.0, 0.0, width=400_000.0), WORKSPACE, 1.0) == []


def test_a_tiny_window_can_still_be_seen() -> None:
    xs = [x for x, _y in ends(chart().outline(Window(9e4, -9e4, 0.0, width=10.0), WORKSPACE, 1.0))]
    assert max(xs) - min(xs) == pytest.approx(16.0)


@pytest.mark.parametrize("power", range(-3, 6))
@pytest.mark.parametrize("digit", [1.0, 3.0, 7.0])
def test_a_scale_bar_is_as_long_as_fits_and_stands_for_1_2_or_5(power: int, digit: float) -> None:
    metres_per_pixel = digit * 10.0**power
    bar = module("overlay.scale_bar").scale_bar(metres_per_pixel, 160.0)
    assert 160.0 / 2.5 - 1e-6 <= bar.pixels <= 160.0 * (1.0 + 1e-6)
    assert bar.metres == pytest.approx(bar.pixels * metres_per_pixel)
    first = bar.metres / 10.0 ** math.floor(math.log10(bar.metres * (1.0 + 1e-9)))
    assert any(first == pytest.approx(step) for step in (1.0, 2.0, 5.0))


def test_no_scale_bar_stands_for_nothing() -> None:
    scale_bar = module("overlay.scale_bar").scale_bar
    assert scale_bar(0.0, 160.0) is None
    assert scale_bar(math.nan, 160.0) is None
    assert scale_bar(math.inf, 160.0) is None


def test_a_scale_bar_says_how_far_the_hand_goes() -> None:
    bars = module("overlay.scale_bar")
    words = {
        bars.ScaleBar(500_000.0, 1.0).words(0.16 / 3e6): "500 km = 27 mm of hand",
        bars.ScaleBar(20.0, 1.0).words(0.001): "20 m = 20 mm of hand",
        bars.ScaleBar(0.5, 1.0).words(0.16): "50 cm = 80 mm of hand",
        bars.ScaleBar(1e6, 1.0).words(0.16 / 21e6): "1,000 km = 7.6 mm of hand",
        bars.ScaleBar(1e3, 1.0).words(0.16 / 21e6): "1 km = 0.0076 mm of hand",
        bars.ScaleBar(5e3, 1.0).words(0.16 / 100.0): "5 km = 8,000 mm of hand",
    }
    assert {word: word for word in words} == words


def test_the_length_of_a_pixel_is_that_at_the_place_looked_at() -> None:
    """A camera at (0, 0, 10) that looks down and sees 2 units for each unit of distance."""
    units_per_pixel = module("overlay.scale_bar").units_per_pixel
    lens = Matrix(((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, -1.0, -0.2), (0.0, 0.0, -1.0, 0.0)))
    perspective = lens @ Matrix.Translation((0.0, 0.0, -10.0))
    right = Vector((1.0, 0.0, 0.0))
    assert units_per_pixel(perspective, right, Vector((3.0, 1.0, 0.0)), 1000.0) == pytest.approx(0.02)
    assert units_per_pixel(perspective, right, Vector((0.0, 0.0, 5.0)), 1000.0) == pytest.approx(0.01)
    assert units_per_pixel(perspective, right, Vector((0.0, 0.0, 11.0)), 1000.0) is None


@pytest.fixture
def touch(tmp_path: Path) -> Any:
    import_grid(MegdrPair(rough(40, 60)).write(tmp_path))
    touch = module("touch.start").start_touch(bpy.context, on_the_clock=False)
    touch.session.step(500)
    module("touch.tick").tick()
    return touch


def rows_of(touch: Any, **changes: Any) -> dict[str, Any]:
    readout = replace(touch.readout, **changes)
    return {row.name: row for row in module("overlay.readout_rows").readout_rows(touch, readout)}


def test_the_readout_says_what_the_panel_says(touch: Any) -> None:
    rows = rows_of(touch, held=None)
    panel = dict(
        module("ui.panel").readout_lines(
            replace(touch.readout, held=None), touch.readout.window.exaggeration, in_degrees=True
        )
    )
    for name in ("Longitude", "Latitude", "Elevation", "Force"):
        assert rows[name].value == panel[name]
    assert "Held back" not in rows


def test_what_takes_the_force_away_is_a_warning(touch: Any) -> None:
    row = rows_of(touch, held="below")["Held back"]
    assert (row.value, row.is_warning) == ("Hand is under the ground", True)
    assert next(iter(rows_of(touch, on_map=False))) == "Place"


def test_the_title_names_mode_and_contact(touch: Any) -> None:
    title = module("overlay.readout_rows").title
    readout = replace(touch.readout, mode="normal", in_contact=False)
    assert title(readout) == "Normal: free"
    assert title(replace(readout, in_contact=True)) == "Normal: touching"
    assert title(replace(readout, mode="pan", in_contact=True)) == "Pan: ground held"


def test_the_legend_has_a_line_for_each_thing_that_the_hand_can_do() -> None:
    lines = module("overlay.legend").legend_lines
    words = [meaning for _shape, meaning in lines("E", has_modes=True)]
    assert words == ["In the air", "On the ground", "Pan: E on the ground", "Zoom: E in the air"]
    assert len({shape.name for shape, _meaning in lines("E", has_modes=True)}) == 4
    assert len(lines("E", has_modes=False)) == 2


def picture(surface: Any, *, exaggeration: float = 1.0) -> Any:
    red, blue = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    colours = [(0.0, blue), (1000.0, red)]
    return module("overlay.overview_picture").overview_picture(surface, colours, exaggeration)


def surface(heights: Any) -> Any:
    preview = module("terrain.preview")
    rows, columns = heights.shape
    cells = preview.PreviewCells(tuple(range(columns)), tuple(range(rows)))
    shape = GridLayout(rows, columns, cell_width=1000.0, cell_height=1000.0)
    return preview.PreviewSurface(cells, shape, heights)


def test_the_picture_has_the_terrains_colours_and_north_above() -> None:
    heights = np.full((50, 100), 1000.0)
    heights[25:] = 0.0
    painted = picture(surface(heights))
    assert painted.shape == (50, 100, 4)
    assert painted[-10, 50] == pytest.approx((1.0, 0.0, 0.0, 1.0))
    assert painted[10, 50] == pytest.approx((0.0, 0.0, 1.0, 1.0))


def test_the_picture_is_lit_from_the_north_west() -> None:
    ridge = 500.0 - np.abs(np.arange(100.0) - 50.0)[None, :] * 10.0 + np.zeros((50, 1))
    painted = picture(surface(ridge), exaggeration=50.0)
    west, east = painted[25, 40], painted[25, 60]
    assert west[:3].sum() > 1.2 * east[:3].sum()


def test_holes_are_dark_in_the_picture() -> None:
    heights = np.full((50, 100), 1000.0)
    heights[:, :20] = np.nan
    assert picture(surface(heights))[25, 5, :3].max() < 0.35


def test_the_picture_of_a_large_preview_stays_small() -> None:
    assert picture(surface(np.zeros((400, 900)))).shape[1] == 480


def test_the_force_points_in_the_scene_as_it_is_felt(touch: Any) -> None:
    """A quarter turn by the window, and another one by the terrain."""
    shown, placements = module("touch.shown"), module("touch.placement")
    terrain = touch.terrain.find()
    terrain.rotation_euler = (0.0, 0.0, math.pi / 2.0)
    terrain.scale = (3.0, 3.0, 3.0)
    bpy.context.view_layer.update()
    placement = placements.Placement.of(terrain, touch.frame)
    state = _State(proxy=(1e5, -1e5, 0.0), window=Window(1e5, -1e5, 0.0, width=1e5, turn=math.pi / 2.0))
    force = shown.force_in_scene(placement, state, 0.16)
    assert tuple(force) == pytest.approx((-2.0, 0.0, 0.0), abs=1e-5)


class _State:
    """As much of a state as a force needs."""

    force = (2.0, 0.0, 0.0)

    def __init__(self, proxy: tuple[float, float, float], window: Window) -> None:
        self.proxy, self.window = proxy, window


def test_the_way_to_the_hand_goes_on_across_the_seam(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    kept = module("terrain.kept").recall(terrain)
    placement = module("touch.placement").Placement.of(terrain, kept.frame)
    turn = kept.frame.turn
    way = placement.between((turn - 1000.0, -1e6, 0.0), (turn + 1000.0, -1e6, 0.0))
    assert way.x == pytest.approx(2000.0 * kept.frame.units_per_metre, rel=1e-4)


def test_a_view_of_the_screen_is_found_in_a_context(touch: Any) -> None:
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    view_of = module("overlay.view").view_of
    assert view_of(bpy.context) is None
    with bpy.context.temp_override(window=window, area=area, region=region):
        view = view_of(bpy.context)
    assert view.has_text
    assert view.width == region.width
    assert view.rotation.determinant() == pytest.approx(1.0, abs=1e-4)
    assert view.has_buttons
    assert 0.0 < view.free.width <= region.width
