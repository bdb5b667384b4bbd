"""What people do in Blender's window, played by simulated keys and mouse: ``make test-gui`` runs this."""

from __future__ import annotations

from pathlib import Path

from tests.formats.megdr_pair import rough
from tests.formats.raw_grids import EhdrPair
from tests.formats.tiff_file import TiffFile
from tests.gui.conftest import Play

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


def test_undo_in_mid_touch_goes_back_beyond_its_start(play: Play, planet: list[Path]) -> None:
    play("undo", *planet)
