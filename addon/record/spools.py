"""Takes on the disk: until they are in the scene, and after a crash; without Blender."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from datetime import datetime
from itertools import count
from pathlib import Path

from proxygraph import Take, TakeError, TakeInUseError, claim_take

SUFFIX = ".touch"

_numbers = count()


def new_spool(folder: Path) -> Path:
    """Name a file for a take that begins; its folder is there then.

    Raises:
        OSError: the folder cannot be made.
    """
    folder.mkdir(parents=True, exist_ok=True)
    now = datetime.now().astimezone().strftime("%Y-%m-%d-%H-%M-%S")
    return folder / f"take-{now}-{os.getpid()}-{next(_numbers)}{SUFFIX}"


def left_takes(folder: Path, unreadable: list[str]) -> Iterator[tuple[Path, Take]]:
    """Claim what crashes left, one after the other, the newest first; what is empty is removed.

    Args:
        unreadable: gets a sentence for each file that cannot be read, and stays where it is.
    """
    for path in _newest_first(folder):
        try:
            take = claim_take(path)
            if not len(take):
                _leave_empty(path, take, unreadable)
                continue
        except TakeInUseError:
            continue  # it is recorded now, here or in another Blender
        except (TakeError, OSError) as error:
            unreadable.append(str(error))
            continue
        yield path, take


def _leave_empty(path: Path, take: Take, unreadable: list[str]) -> None:
    """Remove a take in which nothing was felt; what was felt and is damaged stays."""
    if take.lost is None:
        take.discard_spool()
    else:
        take.release_spool()
        unreadable.append(f"{path}: {take.lost}.")


def _newest_first(folder: Path) -> list[Path]:
    found = []
    with suppress(OSError):
        for path in folder.glob(f"*{SUFFIX}"):
            with suppress(OSError):
                found.append((path.stat().st_mtime_ns, path))
    return [path for _time, path in sorted(found, reverse=True)]
