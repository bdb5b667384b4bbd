"""Voids that are filled, and seen to be."""

from __future__ import annotations

from pathlib import Path

import bpy
import pytest

from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough

VOID = -32768


@pytest.fixture
def label(tmp_path: Path) -> Path:
    heights = rough(9, 13)
    heights[4][5] = heights[4][6] = VOID
    return MegdrPair(heights, image={"MISSING_CONSTANT": VOID}).write(tmp_path)


def filled_heights(label: Path) -> list[float]:
    """What the native module makes of the two holes."""
    grid = module("formats").read_grid(label).open().filled()
    return [grid.elevation(column, 4) for column in (5, 6)]


def test_holes_stay_holes_unless_they_are_to_be_filled(label: Path) -> None:
    mesh = import_grid(label).data
    assert len(mesh.vertices) == 9 * 13 - 2
    assert "filled" not in mesh.attributes


def test_filled_land_is_marked_and_has_a_colour_of_its_own(label: Path) -> None:
    terrain = import_grid(label, fill_voids=True)
    mesh = terrain.data
    marks = [value.value for value in mesh.attributes["filled"].data]
    assert [number for number, mark in enumerate(marks) if mark] == [4 * 13 + 5, 4 * 13 + 6]
    assert [mesh.attributes["elevation"].data[4 * 13 + column].value for column in (5, 6)] == filled_heights(
        label
    )
    material = module("terrain.terrain_material")
    colour = material.filled_colour(mesh.materials[0])
    assert tuple(colour.default_value)[:3] == pytest.approx(module("terrain.palettes").FILLED)
    assert colour.node.inputs["Factor"].links[0].from_node.attribute_name == "filled"


def test_the_hand_feels_what_was_filled(label: Path) -> None:
    terrain = import_grid(label, fill_voids=True)
    assert module("terrain.kept").recall(terrain).filled
    bpy.ops.haptic_terrain.touch_start()
    touch = module("touch.live").live.touch
    assert touch.grid.elevation(5, 4) == filled_heights(label)[0]


def test_a_loaded_file_fills_again(label: Path, tmp_path: Path) -> None:
    import_grid(label, fill_voids=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "kept.blend"))
    bpy.ops.haptic_terrain.touch_start()
    assert module("touch.live").live.touch.grid.elevation(6, 4) == filled_heights(label)[1]


def test_a_grid_without_holes_has_no_colour_for_filled_land(tmp_path: Path) -> None:
    terrain = import_grid(MegdrPair(rough(9, 13)).write(tmp_path), fill_voids=True)
    assert "filled" not in terrain.data.attributes
    assert module("terrain.terrain_material").filled_colour(terrain.data.materials[0]) is None
