"""Cache files in the making: ``NAME.PROCESS.NUMBER.part`` beside the name that the whole file gets.

The native ``Target`` names its own in the same way. The process is in the name so that what a dead one
left is told from what a living one writes.
"""

from __future__ import annotations

import os
import re
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path
from typing import BinaryIO

MOST_SECONDS = 24 * 60 * 60.0
"""That a decoding may take. What is older is left over, also where its process seems to live: numbers of
processes are given again, and not every system can be asked for them."""

_NAME = re.compile(r"\.(\d+)(?:\.\d+)?\.part$")

_numbers = count()


def is_unfinished(path: Path) -> bool:
    """Whether a file has the name of one in the making."""
    return _NAME.search(path.name) is not None


def is_left_over(path: Path) -> bool:
    """Whether nobody writes this unfinished file any more."""
    name = _NAME.search(path.name)
    if name is None:
        return False
    try:
        age = time.time() - path.stat().st_mtime
    except OSError:
        return False  # it got its own name, or is gone
    return age > MOST_SECONDS or not _lives(int(name[1]))


@contextmanager
def unfinished_file(path: Path) -> Iterator[BinaryIO]:
    """A file to write, which becomes ``path`` when the block ends well, and else is removed.

    Raises:
        OSError: it cannot be made or named.
    """
    file = _made(path)
    part = Path(file.name)
    try:
        with file:
            yield file
        part.replace(path)
    except BaseException:
        with suppress(OSError):
            part.unlink()
        raise


def _made(path: Path) -> BinaryIO:
    """Make a file that no other decoding has, in this process or in another."""
    while True:
        try:
            return path.with_name(f"{path.name}.{os.getpid()}.{next(_numbers)}.part").open("xb")
        except FileExistsError:
            continue


def _lives(process: int) -> bool:
    """Whether there is such a process; yes where the system cannot be asked."""
    if sys.platform == "win32" or process == 0:
        return process != 0  # signal 0 is none there: it would end the process
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True  # somebody else's
    return True
