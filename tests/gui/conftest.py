"""The window, the extension's zip, and files to import."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

for folder in (ROOT, ROOT / "blender_scripts"):
    if str(folder) not in sys.path:
        sys.path.append(str(folder))

from sample_grid.megdr import write_pair  # noqa: E402
from sample_grid.planet import elevations  # noqa: E402

from tests.gui.window import CannotRunError, Outcome, make_window, run  # noqa: E402

OUTPUT = ROOT / "build" / "gui"

Play = Callable[..., Outcome]


@pytest.fixture(scope="session")
def window() -> Path:
    """Give the folder with Blender; skip where there can be none."""
    try:
        return make_window()
    except CannotRunError as reason:
        pytest.skip(str(reason))


@pytest.fixture(scope="session")
def package() -> Path:
    """Give the extension's zip, which ``make test-gui`` has built."""
    (zipped,) = (ROOT / "build" / "package").glob("*.zip")
    return zipped


@pytest.fixture(scope="session")
def planet(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Give label and image of a small synthetic planet, which is soon drawn."""
    label = write_pair(tmp_path_factory.mktemp("planet"), "planet", elevations(180, 360))
    return [label, label.with_suffix(".img")]


@pytest.fixture
def play(window: Path, package: Path) -> Play:
    """Play a scenario with the package and files, and fail as it did."""

    def played(scenario: str, *files: Path) -> Outcome:
        output = OUTPUT / scenario
        outcome = run(window, scenario, files=[package, *files], output=output)
        failure = outcome.failure
        if failure is None and "Traceback (most recent call last)" in outcome.log:
            failure = "Python failed somewhere in Blender: the log says where"
        if failure is not None:
            where = os.path.relpath(output, ROOT)
            pytest.fail(f"{failure}\nPictures and log: {where}", pytrace=False)
        return outcome

    return played
