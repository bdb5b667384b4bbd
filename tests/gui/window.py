"""Blender in a real window, on a screen in memory: runs one scenario, and tells what came of it.

``.ci/make-window`` makes the folder with Debian's Blender. What is run there is copied into it, and what it
leaves is copied out: no file system is mounted.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tests.gui.processes import Process, processes_with

ROOT = Path(__file__).resolve().parents[2]

WIDTH, HEIGHT = 1280, 800
"""Of the screen; Blender's window fills it."""

LONGEST = 600.0
"""Seconds that a scenario may take; most take a twentieth, where nothing else runs."""

BETWEEN_LOOKS = 0.1
"""Seconds between two looks at the threads of the Blender that runs."""


@dataclass
class Outcome:
    """What a scenario left."""

    failure: str | None
    """Why it failed, in words; ``None`` where it did not."""
    log: str
    """All that Blender printed."""
    marks: dict[str, float] = field(default_factory=dict)
    """When the scenario came to what, seconds since the epoch."""
    figures: dict[str, Any] = field(default_factory=dict)
    threads: list[tuple[float, frozenset[str]]] = field(default_factory=list)
    """Names of Blender's threads, look by look."""
    left_running: list[str] = field(default_factory=list)
    """Processes that were there when the screen had gone."""

    def threads_between(self, first: str, last: str) -> set[str]:
        """Names of all threads seen between two marks."""
        begin, end = self.marks[first], self.marks[last]
        return set().union(*(names for moment, names in self.threads if begin < moment < end))


class CannotRunError(RuntimeError):
    """There is no window on this machine; the text says what is missing."""


def make_window() -> Path:
    """Make the folder with Blender, or find it.

    Raises:
        CannotRunError: it cannot be made here.
        RuntimeError: it can, and was not.
    """
    made = subprocess.run([ROOT / ".ci/make-window"], capture_output=True, text=True, check=False)
    if made.returncode == 77:
        raise CannotRunError(made.stderr.strip())
    if made.returncode != 0:
        raise RuntimeError(made.stderr.strip())
    return Path(made.stdout.strip())


def run(
    window: Path,
    scenario: str,
    *,
    files: Iterable[Path],
    output: Path,
    options: Mapping[str, Any] | None = None,
) -> Outcome:
    """Run ``scenarios/<scenario>.py`` in a Blender with factory settings.

    Args:
        window: what ``make_window`` gave.
        files: that the scenario finds in its folder of files, by their names.
        output: folder for screenshots and whatever else the scenario writes; emptied first.
        options: for the scenario.
    """
    shutil.rmtree(output, ignore_errors=True)
    work = Path(tempfile.mkdtemp(prefix="haptic-", dir=window / "tmp"))
    try:
        _fill(work, files)
        (work / "options.json").write_text(json.dumps(dict(options or {})), encoding="utf-8")
        outcome = _watched(window, work, scenario)
        shutil.copytree(work / "output", output)
        (output / "blender.log").write_text(outcome.log, encoding="utf-8")
    finally:
        shutil.rmtree(work, ignore_errors=True)
    return outcome


def _fill(work: Path, files: Iterable[Path]) -> None:
    for folder in ("files", "output", "resources", "home", "temporary"):
        (work / folder).mkdir()
    for file in files:
        shutil.copy2(file, work / "files")
    here = Path(__file__).parent
    shutil.copytree(here, work / "code" / "tests" / "gui", ignore=shutil.ignore_patterns("__pycache__"))


def _watched(window: Path, work: Path, scenario: str) -> Outcome:
    inside = Path("/", work.relative_to(window))
    log = work / "blender.log"
    with log.open("wb") as out:
        command = _command(window, inside, scenario)
        running = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        threads = _look_on(running, inside)
    left = _end_all(inside)
    for crash in (work / "temporary").glob("*.crash.txt"):
        shutil.copy2(crash, work / "output")
    told = work / "output" / "outcome.json"
    if not told.is_file():
        last = "\n".join(log.read_text(encoding="utf-8", errors="replace").splitlines()[-20:])
        return Outcome(
            f"Blender ended with {running.returncode}, in the middle:\n{last}", last, left_running=left
        )
    outcome = Outcome(**json.loads(told.read_text(encoding="utf-8")), log=log.read_text(errors="replace"))
    outcome.threads, outcome.left_running = threads, left
    if outcome.failure is None and running.returncode != 0:
        outcome.failure = f"Blender ended with {running.returncode} after all was done"
    return outcome


def _command(window: Path, inside: Path, scenario: str) -> list[str]:
    environment = {
        "PATH": "/usr/bin:/bin",
        "HOME": str(inside / "home"),
        "TMPDIR": str(inside / "temporary"),
        "LANG": "C.UTF-8",
        "LIBGL_ALWAYS_SOFTWARE": "1",
        "MESA_SHADER_CACHE_DIR": "/var/cache/shaders",  # outlives a run: compiling takes most of the time
        "PYTHONDONTWRITEBYTECODE": "1",
        "BLENDER_USER_RESOURCES": str(inside / "resources"),
    }
    variables = [f"{name}={value}" for name, value in environment.items()]
    screen = ["xvfb-run", "--auto-servernum", "--server-args", f"-screen 0 {WIDTH}x{HEIGHT}x24"]
    blender = ["blender", "--factory-startup", "--offline-mode", "-noaudio", "--enable-event-simulate"]
    geometry = ["--window-geometry", "0", "0", str(WIDTH), str(HEIGHT)]
    script = ["--python-exit-code", "1", "--python", str(inside / "code/tests/gui/inside/run.py")]
    return [
        *("chroot", str(window), "env", "-i", *variables, *screen),
        *("timeout", "--kill-after", "5", str(LONGEST), *blender, *geometry, *script),
        *("--", scenario, str(inside)),
    ]


def _look_on(running: subprocess.Popen[bytes], inside: Path) -> list[tuple[float, frozenset[str]]]:
    """Note the names of Blender's threads until it has ended."""
    threads: list[tuple[float, frozenset[str]]] = []
    while running.poll() is None:
        blenders = [process for process in processes_with(str(inside)) if process.name == "blender"]
        threads += [(time.time(), blender.threads()) for blender in blenders]
        time.sleep(BETWEEN_LOOKS)
    return threads


def _end_all(inside: Path) -> list[str]:
    """End what is still there, and say what it was."""
    left: list[Process] = []
    for _ in range(20):  # the screen takes a moment to go
        left = list(processes_with(str(inside)))
        if not left:
            return []
        time.sleep(BETWEEN_LOOKS)
    for process in left:
        os.kill(process.id, signal.SIGKILL)
    return [process.name for process in left]
