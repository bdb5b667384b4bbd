"""Colours of heights and slopes, and the legend that says what they mean."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough


def look() -> Any:
    return module("terrain.terrain_material")


def import_on(body: str, heights: list[list[int]], tmp_path: Path) -> bpy.types.Object:
    return import_grid(MegdrPair(heights, header={"TARGET_NAME": body}).write(tmp_path))


def colour_at(terrain: bpy.types.Object, metres: float) -> tuple[float, ...]:
    """What the material's own nodes make of a height."""
    nodes = terrain.data.materials[0].node_tree.nodes
    span, colours = nodes["elevation range"], nodes["elevation colours"]
    low, high = (span.inputs[end].default_value for end in ("From Min", "From Max"))
    share = min(max((metres - low) / (high - low), 0.0), 1.0)
    return tuple(colours.color_ramp.evaluate(share))[:3]


def is_blue(colour: tuple[float, ...]) -> bool:
    return colour[2] > 1.3 * max(colour[:2])


def test_mars_is_rust_and_other_bodies_are_grey(tmp_path: Path) -> None:
    palettes = module("terrain.palettes")
    for body, palette in (("MARS", palettes.MARS), ("MOON", palettes.NEUTRAL)):
        terrain = import_on(body, rough(9, 13), tmp_path)
        elements = terrain.data.materials[0].node_tree.nodes["elevation colours"].color_ramp.elements
        found = [value for element in elements for value in (element.position, *tuple(element.color)[:3])]
        expected = [value for share, colour in palette for value in (share, *colour)]
        assert found == pytest.approx(expected)


@pytest.mark.parametrize(("low", "high"), [(-3000, 3000), (-10, 4000), (-6000, 20)])
def test_earth_is_blue_below_0_and_only_there(tmp_path: Path, low: int, high: int) -> None:
    heights = np.linspace(low, high, 40 * 40).astype(int).reshape(40, 40).tolist()
    terrain = import_on("EARTH", heights, tmp_path)
    span = terrain.data.materials[0].node_tree.nodes["elevation range"]
    step = (span.inputs["From Max"].default_value - span.inputs["From Min"].default_value) / 500.0
    for metres in (-step, -0.6 * step, low * 0.99):
        assert is_blue(colour_at(terrain, min(metres, -step)))
    for metres in (0.0, step, high * 0.99):
        assert not is_blue(colour_at(terrain, metres))


@pytest.mark.parametrize(("low", "high"), [(0, 3000), (680, 2540), (400, 400)])
def test_dry_land_has_no_sea(tmp_path: Path, low: int, high: int) -> None:
    heights = np.linspace(low, high, 400).astype(int).reshape(20, 20).tolist()
    terrain = import_on("EARTH", heights, tmp_path)
    assert not any(is_blue(colour_at(terrain, metres)) for metres in range(low, high + 1, 10))


def test_a_sea_without_land_is_all_blue(tmp_path: Path) -> None:
    heights = np.linspace(-5000, -10, 400).astype(int).reshape(20, 20).tolist()
    terrain = import_on("EARTH", heights, tmp_path)
    assert all(is_blue(colour_at(terrain, metres)) for metres in range(-5000, -10, 100))


def test_the_legend_is_what_the_material_does(tmp_path: Path) -> None:
    terrain = import_on("MARS", rough(9, 13), tmp_path)
    material = terrain.data.materials[0]
    swatches = look().legend(material)
    assert [swatch.value for swatch in swatches] == sorted(
        (swatch.value for swatch in swatches), reverse=True
    )
    for swatch in swatches:
        assert colour_at(terrain, swatch.value) == pytest.approx(tuple(swatch.element.color)[:3], abs=1e-3)
    shown = [value.value for value in terrain.data.attributes["elevation"].data]
    assert swatches[0].value == pytest.approx(np.percentile(shown, 99.0))
    assert swatches[-1].value == pytest.approx(np.percentile(shown, 1.0))


def test_the_legend_follows_a_ramp_that_a_person_changed(tmp_path: Path) -> None:
    material = import_on("MARS", rough(9, 13), tmp_path).data.materials[0]
    span = material.node_tree.nodes["elevation range"]
    span.inputs["From Min"].default_value, span.inputs["From Max"].default_value = 0.0, 100.0
    material.node_tree.nodes["elevation colours"].color_ramp.elements[1].position = 0.5
    assert 50.0 in [swatch.value for swatch in look().legend(material)]


def test_a_legend_without_its_nodes_is_empty(tmp_path: Path) -> None:
    material = import_on("MARS", rough(9, 13), tmp_path).data.materials[0]
    material.node_tree.nodes.remove(material.node_tree.nodes["elevation colours"])
    assert look().legend(material) == []


def test_colours_may_tell_slopes(tmp_path: Path) -> None:
    terrain = import_on("MARS", rough(9, 13), tmp_path)
    material = look().material_of(terrain)
    assert look().colour_by(material) == "ELEVATION"
    assert bpy.ops.haptic_terrain.colour_by(what="SLOPE") == {"FINISHED"}
    assert look().colour_by(material) == "SLOPE"
    assert look().legend(material)[-1].value == 0.0
    assert look().legend(material)[0].value in module("terrain.ramps").STEEPEST
    bpy.ops.haptic_terrain.colour_by(what="ELEVATION")
    assert look().colour_by(material) == "ELEVATION"


def test_a_terrain_with_another_material_is_left_alone(tmp_path: Path) -> None:
    terrain = import_on("MARS", rough(9, 13), tmp_path)
    terrain.data.materials[0] = bpy.data.materials.new("Mine")
    with pytest.raises(RuntimeError, match="another material"):
        bpy.ops.haptic_terrain.colour_by(what="SLOPE")


def slopes_of(terrain: bpy.types.Object) -> list[float]:
    return [value.value for value in terrain.data.attributes["slope"].data]


def test_slopes_are_of_the_true_ground(tmp_path: Path) -> None:
    """A plane that rises 30 degrees eastward: exaggeration and preview change nothing."""
    layout = (
        module("formats").read_grid(MegdrPair(rough(9, 13), pixels_per_degree=512.0).write(tmp_path)).layout
    )
    rise = layout.cell_width * math.tan(math.radians(30.0))
    heights = [[round(column * rise) for column in range(13)] for _ in range(9)]
    label = MegdrPair(heights, pixels_per_degree=512.0).write(tmp_path)
    for choice in ({}, {"exaggeration": 50.0}, {"vertex_budget": 20}, {"scale": "METRE"}):
        assert all(abs(slope - 30.0) < 0.2 for slope in slopes_of(import_grid(label, **choice)))


def test_slopes_north_count_as_slopes_east_do(tmp_path: Path) -> None:
    label = MegdrPair([[row * 1000] * 5 for row in range(5)], north=2.5).write(tmp_path)
    terrain = import_grid(label)
    layout = module("terrain.kept").recall(terrain).grid.layout
    expected = math.degrees(math.atan(1000.0 / layout.cell_height))
    assert slopes_of(terrain) == pytest.approx([expected] * 25)


def test_slopes_beside_a_void_come_from_the_other_side(tmp_path: Path) -> None:
    heights = [[1000 * column for column in range(5)] for _ in range(5)]
    heights[2][2] = -32768
    terrain = import_grid(MegdrPair(heights, image={"MISSING_CONSTANT": -32768}).write(tmp_path))
    layout = module("terrain.kept").recall(terrain).grid.layout
    expected = math.degrees(math.atan(1000.0 / layout.cell_width))
    assert slopes_of(terrain) == pytest.approx([expected] * 24)


def test_slopes_at_the_seam_of_a_planet_know_the_other_side(tmp_path: Path) -> None:
    pair = planet()
    terrain = import_grid(pair.write(tmp_path), vertex_budget=100_000)
    layout = module("terrain.kept").recall(terrain).grid.layout
    row = 90
    east = (pair.heights[row][1] - pair.heights[row][359]) / (2.0 * layout.cell_width)
    north = (pair.heights[row - 1][0] - pair.heights[row + 1][0]) / (2.0 * layout.cell_height)
    expected = math.degrees(math.atan(math.hypot(east, north)))
    slopes = slopes_of(terrain)
    assert slopes[row * 361] == slopes[row * 361 + 360] == pytest.approx(expected)


@pytest.mark.parametrize(("scale", "offset"), [(0.25, -8000.0), (0.1, 0.0), (1.0, 0.0)])
def test_heights_are_exact_and_not_terraced(tmp_path: Path, scale: float, offset: float) -> None:
    pair = MegdrPair(rough(9, 13), image={"SCALING_FACTOR": scale, "OFFSET": offset})
    terrain = import_grid(pair.write(tmp_path))
    found = np.array([value.value for value in terrain.data.attributes["elevation"].data], dtype=np.float32)
    expected = (np.array(pair.heights, dtype=np.float64) * scale + offset).astype(np.float32).ravel()
    assert found.tobytes() == expected.tobytes()
    assert len(set(found.tolist())) == len({height for row in pair.heights for height in row})
