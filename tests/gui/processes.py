"""Processes and threads of this machine, as Linux shows them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Process:
    """One that runs."""

    id: int
    name: str

    def threads(self) -> frozenset[str]:
        """Names of its threads; Linux keeps 15 letters of each."""
        names = set()
        with suppress(OSError):
            for thread in Path(f"/proc/{self.id}/task").iterdir():
                with suppress(OSError):
                    names.add((thread / "comm").read_text().strip())
        return frozenset(names)


def processes_with(text: str) -> Iterator[Process]:
    """Find the processes whose environment, which children inherit, names something."""
    for folder in Path("/proc").iterdir():
        if not folder.name.isdecimal():
            continue
        with suppress(OSError):  # it has ended, or is another person's
            if text.encode() in (folder / "environ").read_bytes():
                yield Process(int(folder.name), (folder / "comm").read_text().strip())
