"""By what a file is known again: whether what was read from it still holds."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from .format_error import FormatError

PIECES, PIECE_BYTES = 64, 4096
"""Of a file that are looked at where its time of change is another: a copied file has a new time."""


@dataclass(frozen=True)
class SourceStamp:
    """A file as it was."""

    size: int
    """Bytes."""
    modified: int
    """Nanoseconds, as the system counts them."""
    digest: str
    """Of pieces from the whole length of the file."""

    @staticmethod
    def of(path: Path) -> SourceStamp:
        """Look at a file.

        Raises:
            OSError: it cannot be read.
        """
        status = path.stat()
        return SourceStamp(status.st_size, status.st_mtime_ns, _digest(path, status.st_size))

    def is_of(self, path: Path) -> bool:
        """Whether a file is still the same, as far as its size, its time, or else its pieces tell.

        Raises:
            OSError: it cannot be read.
        """
        status = path.stat()
        if status.st_size != self.size:
            return False
        return status.st_mtime_ns == self.modified or _digest(path, self.size) == self.digest

    def check(self, path: Path) -> None:
        """Refuse a file that was changed; one that cannot be read is left to whoever reads it.

        Raises:
            FormatError: it is another file now.
        """
        try:
            if self.is_of(path):
                return
            size = path.stat().st_size
        except OSError:
            return
        raise FormatError(
            path,
            "data file",
            found=f"another content ({size:,} bytes)",
            expected=f"the file that was imported ({self.size:,} bytes)",
            way_out="It was changed since: import the grid again.",
        )


def _digest(path: Path, size: int) -> str:
    digest = hashlib.blake2b(digest_size=16)
    with path.open("rb") as file:
        last = max(0, size - PIECE_BYTES)
        for place in sorted({last * piece // (PIECES - 1) for piece in range(PIECES)}):
            file.seek(place)
            digest.update(file.read(PIECE_BYTES))
    return digest.hexdigest()
