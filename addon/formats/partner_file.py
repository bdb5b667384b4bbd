"""Finding a file whose name is written in another letter case."""

from __future__ import annotations

from pathlib import Path


def file_in_any_case(path: Path) -> Path | None:
    """Find ``path``, or a file in its folder whose name differs in letter case only."""
    if path.is_file():
        return path
    if not path.parent.is_dir():
        return None
    wanted = path.name.lower()
    found = sorted(
        entry for entry in path.parent.iterdir() if entry.name.lower() == wanted and entry.is_file()
    )
    return found[0] if found else None
