"""Decoded grids on the disk: what is large is decoded once, and mapped from then on.

A cache file holds nothing but samples, as the wanted layout packs them. Its name says what it was made of
(file, size, time of change, decoder, region): a changed file has another name, and the old one is removed
when room is needed. Decoders write it through ``Target``, which gives it its name when it is whole.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import sys
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path

from proxygraph import GridLayout

from .decoding import Decoding
from .layout_properties import layout_properties
from .unfinished import is_left_over, is_unfinished

MOST_IN_MEMORY = 512 << 20
"""Bytes of decoded samples that stay in memory; more go to a file."""

MOST_ON_DISK = 20 << 30
"""Bytes that all cache files together may take; the ones that were used longest ago go first."""

SUFFIX = ".samples"


@dataclass
class Cache:
    """Where cache files are, and how large they may be."""

    folder: Path
    most_in_memory: int = MOST_IN_MEMORY
    most_on_disk: int = MOST_ON_DISK


class CacheError(OSError):
    """A grid cannot be written to the cache: what was found, what was expected, and a way out."""

    def __init__(self, found: str, expected: str, way_out: str) -> None:
        super().__init__(f"found {found}, expected {expected}. {way_out}")
        self.found = found
        self.expected = expected
        self.way_out = way_out


def system_folder() -> Path:
    """The folder for caches that the system gives to a person's programs."""
    home = Path.home()
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = home / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache")
    return base / "haptic_terrain"


cache = Cache(system_folder())
"""In Blender the extension's own folder takes this one's place."""


def cache_file(path: Path, layout: GridLayout, decoding: Decoding) -> Path | None:
    """Where a decoder is to write; ``None``: into memory, the grid is small enough.

    The folder is there then, with room made in it.

    Args:
        path: the data file.
        layout: packed, as it is decoded.

    Raises:
        CacheError: the folder cannot be used, or is never large enough.
        OSError: the data file is gone.
    """
    place = _place(path, layout, decoding)
    if place is not None:
        _make_folder(layout.byte_length)
        _remove_what_was_left()
        make_room(layout.byte_length)
    return place


def refused_by_system(error: OSError, wanted: int) -> CacheError:
    """Say in words why so many bytes cannot be written to the cache folder."""
    return CacheError(
        f"the cache folder {cache.folder} cannot be used ({error.strerror or error})",
        f"{wanted:,} bytes of decoded samples to be written there",
        "Free space on its disk and let the folder be written to, or import a smaller region.",
    )


def is_full(error: OSError) -> bool:
    """Whether the system refused to write, for want of room or of leave, whatever was being read."""
    return error.errno in {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS}


def cached_file(path: Path, layout: GridLayout, decoding: Decoding) -> Path | None:
    """The cache file of an earlier decoding, where there is a whole one.

    Raises:
        OSError: the data file is gone.
    """
    place = _place(path, layout, decoding)
    if place is None or not place.is_file() or place.stat().st_size != layout.byte_length:
        return None
    with suppress(OSError):
        os.utime(place)  # it was used now
    return place


def make_room(wanted: int) -> None:
    """Remove cache files, the longest unused first, until so many bytes more keep to the total.

    One that is in use stays where the system does not let it go, and is read to its end elsewhere. One that
    is being written stays.

    Raises:
        CacheError: so many bytes never fit; nothing is removed then.
    """
    if wanted > cache.most_on_disk:
        raise CacheError(
            f"{wanted:,} bytes of decoded samples",
            f"at most {cache.most_on_disk:,} in the cache folder {cache.folder}",
            "Import a smaller region.",
        )
    files = sorted(_files(), key=lambda file: file[1])
    used = sum(size for _file, _time, size in files)
    for file, _time, size in files:
        if used + wanted <= cache.most_on_disk:
            return
        if is_unfinished(file):
            continue
        with suppress(OSError):
            file.unlink()
            used -= size


def _make_folder(wanted: int) -> None:
    try:
        cache.folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise refused_by_system(error, wanted) from error
    if not os.access(cache.folder, os.W_OK | os.X_OK):
        raise refused_by_system(PermissionError(errno.EACCES, os.strerror(errno.EACCES)), wanted)


def _remove_what_was_left() -> None:
    """Remove what decodings began that ended with their process: quitting during an import leaves it."""
    for file, _time, _size in _files():
        if is_left_over(file):
            with suppress(OSError):
                file.unlink()


def _files() -> list[tuple[Path, int, int]]:
    """Every cache file, also the unfinished ones, with its time and size."""
    found = []
    with suppress(OSError):
        for file in cache.folder.iterdir():
            if SUFFIX in file.suffixes:
                with suppress(OSError):
                    status = file.stat()
                    found.append((file, status.st_mtime_ns, status.st_size))
    return found


def _place(path: Path, layout: GridLayout, decoding: Decoding) -> Path | None:
    if layout.byte_length <= cache.most_in_memory:
        return None
    status = path.stat()
    source = [str(path.absolute()), status.st_size, status.st_mtime_ns]
    told = json.dumps([source, asdict(decoding), layout_properties(layout)], sort_keys=True, default=str)
    return cache.folder / f"{hashlib.blake2b(told.encode(), digest_size=20).hexdigest()}{SUFFIX}"
