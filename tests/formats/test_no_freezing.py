"""Headers are read while Blender waits: small files that are bad on purpose are answered at once."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from addon.formats.pds.pds4_array import read_pds4
from tests.formats import fuzz_readers
from tests.formats.raw_grids import Pds4Pair
from tests.formats.reading import complaint


@pytest.fixture
def alarm() -> Iterator[None]:
    """Stop what would take minutes; what is answered takes a small part of a second."""
    if not hasattr(signal, "setitimer"):
        pytest.skip("this system has no alarm that ends what goes on too long")
    before = signal.signal(signal.SIGALRM, fuzz_readers.ring)
    signal.setitimer(signal.ITIMER_REAL, fuzz_readers.SLOW_SECONDS)
    yield
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.usefixtures("alarm")
@pytest.mark.parametrize("name", fuzz_readers.SLOW_ONCE)
def test_small_files_that_took_long_are_refused(name: str, tmp_path: Path) -> None:
    fuzz_readers.SLOW_ONCE[name](tmp_path)
    for path in tmp_path.glob("grid.[hlx]*"):
        assert "expected" in complaint(path)


def test_a_label_of_too_many_assignments_is_not_followed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def follow(_text: str, **_options: object) -> None:
        raise AssertionError("the text was followed")

    fuzz_readers.pds3_of_empty_assignments(tmp_path)
    monkeypatch.setattr("addon.formats.pds.label.pvl.loads", follow)
    assert "12,001 equals signs" in complaint(tmp_path / "grid.lbl")


def test_a_later_file_area_may_have_the_array(tmp_path: Path) -> None:
    """File areas are told apart; what is looked at is not only the first."""
    label = Pds4Pair().write(tmp_path)
    area = "<File_Area_Observational><File><file_name>other.tab</file_name></File></File_Area_Observational>"
    text = label.read_text().replace("<File_Area_Observational>", f"{area}<File_Area_Observational>")
    label.write_text(text)
    assert read_pds4(label).data_path.name == "grid.img"
