"""What people do in Blender's window, played by simulated keys and mouse: ``make test-gui`` runs this."""

from __future__ import annotations

from pathlib import Path

import pytest
from sample_grid.megdr import write_pair
from sample_grid.planet import elevations

from tests.formats.megdr_pair import rough
from tests.formats.raw_grids import EhdrPair
from tests.formats.tiff_file import TiffFile
from tests.gui.conftest import ROOT, Play

SERVO = "haptic-servo"
"""The thread's name."""


def test_a_first_touch_from_the_zip_to_pan_and_zoom(play: Play, planet: list[Path]) -> None:
    outcome = play("first_touch", *planet)
    assert SERVO in outcome.threads_between("touching", "touched")
    assert SERVO not in outcome.threads_between("stopped", "quits")
    assert outcome.left_running == []


def test_files_that_blender_takes_for_pictures_are_offered_as_terrain(
    play: Play, planet: list[Path], tmp_path: Path
) -> None:
    tiff = TiffFile(heights=rough(40, 60)).write(tmp_path)
    header = EhdrPair(heights=rough(40, 60), suffixes=(".hdr", ".dem")).write(tmp_path)
    play("drops", tiff, header, header.with_suffix(".dem"), *planet)


def test_a_take_is_undone_saved_and_loaded_and_blender_quits_in_mid_touch(
    play: Play, planet: list[Path]
) -> None:
    outcome = play("takes", *planet)
    assert SERVO in outcome.threads_between("touching again", "quits")
    assert outcome.left_running == []


def test_olympus_mons_is_touched_for_the_picture_in_the_readme(play: Play) -> None:
    label = ROOT.parent / "shared" / "data" / "mola" / "megt90n000cb.lbl"
    if not label.is_file():
        pytest.skip("the real MOLA grid is not beside the checkout")
    play("olympus", label, label.with_suffix(".img"))


def test_undo_in_mid_touch_goes_back_beyond_its_start(play: Play, planet: list[Path]) -> None:
    play("undo", *planet)


def test_undo_in_mid_touch_leaves_nothing_of_the_levels_that_the_timer_made(
    play: Play, tmp_path: Path
) -> None:
    label = write_pair(tmp_path, "planet", elevations(540, 1080))  # more samples than are drawn
    play("undo", label, label.with_suffix(".img"))
