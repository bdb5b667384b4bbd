"""The window, the extension's zip, and files to import."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.gui.window import ROOT, CannotRunError, Outcome, make_window, run

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


@pytest.fixture
def play(window: Path, package: Path) -> Play:
    """Play a scenario with the package and files, and fail as it did."""

    def played(scenario: str, *files: Path) -> Outcome:
        output = OUTPUT / scenario
        outcome = run(window, scenario, files=[package, *files], output=output)
        if outcome.failure is not None:
            pytest.fail(f"{outcome.failure}\nPictures and log: {os.path.relpath(output, ROOT)}", pytrace=False)
        return outcome

    return played
