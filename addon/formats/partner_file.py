"""Finding a file whose name is written in another letter case."""

from __future__ import annotations

from pathlib import Path


def file_in_any_case(path: Path) -> Path | None:
    """Find ``path``, or a file in its folder whose name differs in letter case only."""
    if is_file(path):
        return path
    wanted = path.name.lower()
    try:
        found = sorted(entry for entry in path.parent.iterdir() if entry.name.lower() == wanted)
    except OSError:  # no such folder, or one that may not be read
        return None
    return next((entry for entry in found if is_file(entry)), None)


def is_file(path: Path) -> bool:
    """Whether there is a file of that name; there is none where the system refuses the name itself."""
    try:
        return path.is_file()
    except OSError:
        return False
