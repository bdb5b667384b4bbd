"""What Blender runs: ``-- SCENARIO FOLDER``. The rest is done by timers, so that Blender draws in between."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

NAME, FOLDER = sys.argv[sys.argv.index("--") + 1 :]

sys.path.insert(0, str(Path(FOLDER, "code")))

from tests.gui.inside.blender import Blender  # noqa: E402
from tests.gui.inside.script import play  # noqa: E402

scenario = importlib.import_module(f"tests.gui.scenarios.{NAME}").scenario
play(scenario, Blender(Path(FOLDER)))
