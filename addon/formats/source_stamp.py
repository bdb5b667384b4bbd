"""By what a file is known again: whether what was read from it still holds."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from .format_error import FormatError

MOST_HASHED = 256 << 20
"""Bytes of a file whose whole content is remembered: some tenths of a second. Pieces of a longer one would
not show what was changed between them, so there its time of change has to tell."""

READ_BYTES = 1 << 20


@dataclass(frozen=True)
class SourceStamp:
    """A file as it was."""

    size: int
    """Bytes."""
    modified: int
    """Nanoseconds, as the system counts them."""
    digest: str
    """Of the whole file; empty where that is longer than ``MOST_HASHED``."""

    @staticmethod
    def of(path: Path) -> SourceStamp:
        """Look at a file.

        Raises:
            OSError: it cannot be read.
        """
        status = path.stat()
        size, modified = status.st_size, status.st_mtime_ns
        return SourceStamp(size, modified, "" if size > MOST_HASHED else _digest(path, size, modified))

    def is_of(self, path: Path) -> bool:
        """Whether a file is still the same: by size and time, else (a copy has a new time) by its content.

        Raises:
            OSError: it cannot be read.
        """
        status = path.stat()
        if status.st_size != self.size:
            return False
        if status.st_mtime_ns == self.modified:
            return True
        return self._has_content and _digest(path, self.size, status.st_mtime_ns) == self.digest

    def check(self, path: Path) -> None:
        """Refuse a file that was changed; one that cannot be read is left to whoever reads it.

        Raises:
            FormatError: it is another file now, or may be one.
        """
        try:
            if self.is_of(path):
                return
            size = path.stat().st_size
        except OSError:
            return
        untold = size == self.size and not self._has_content
        raise FormatError(
            path,
            "data file",
            found=f"another {'time of change' if untold else 'content'} ({size:,} bytes)",
            expected=f"the file that was imported ({self.size:,} bytes)",
            way_out="It may have been changed, and is too long to compare: import the grid again."
            if untold
            else "It was changed since: import the grid again.",
        )

    @property
    def _has_content(self) -> bool:
        return self.digest != "" and self.size <= MOST_HASHED


@lru_cache(maxsize=8)
def _digest(path: Path, size: int, modified: int) -> str:
    """Hash a whole file; remembered as long as size and time stay, since touch asks at every mark.

    Args:
        path: of the file.
        size: no more than so many bytes are read, however the file grows meanwhile.
        modified: as in ``SourceStamp``; only tells one state of the file from another.
    """
    del modified
    digest = hashlib.blake2b(digest_size=16)
    with path.open("rb") as file:
        while size > 0 and (piece := file.read(min(size, READ_BYTES))):
            digest.update(piece)
            size -= len(piece)
    return digest.hexdigest()
