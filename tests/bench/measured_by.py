"""Figures of other scripts that measure, each in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from tests.bench.goals import Figures


def measured_by(script: Path) -> Figures:
    """Run a script that measures, and take its figures.

    Raises:
        SystemExit: it is not there, or failed, or printed something else.
    """
    if not script.is_file():
        raise SystemExit(f"{script.name} is not there: without it these figures cannot be measured")
    done = subprocess.run([sys.executable, str(script)], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{script.name} ended with {done.returncode}")
    return printed_figures(done.stdout, script.name)


def printed_figures(text: str, name: str) -> Figures:
    """Take the JSON object at the end of what a script printed; Blender's own lines may stand before it.

    Raises:
        SystemExit: there is none.
    """
    lines = text.splitlines()
    begins = [number for number, line in enumerate(lines) if line.startswith("{")]
    try:
        figures: Figures = json.loads("\n".join(lines[begins[-1] :]))
    except (IndexError, json.JSONDecodeError):
        raise SystemExit(f"{name} should end with a JSON object of figures, not {lines[-1:]}") from None
    return figures
