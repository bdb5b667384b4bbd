"""Decoded grids on the disk: what is large is decoded once, and mapped from then on.

A cache file holds nothing but samples, as the wanted layout packs them. Its name says what it was made of
(file, size, time of change, decoder, region): a changed file has another name, and the old one is removed
when room is needed. Decoders write it through ``Target``, which gives it its name when it is whole.
"""

from __future__ import annotations

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
        OSError: the folder cannot be made, or the data file is gone.
    """
    place = _place(path, layout, decoding)
    if place is not None:
        place.parent.mkdir(parents=True, exist_ok=True)
        make_room(layout.byte_length)
    return place


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

    One that is in use stays where the system does not let it go, and is read to its end elsewhere.
    """
    files = sorted(_files(), key=lambda file: file[1])
    used = sum(size for _file, _time, size in files)
    for file, _time, size in files:
        if used + wanted <= cache.most_on_disk:
            return
        with suppress(OSError):
            file.unlink()
            used -= size


def _files() -> list[tuple[Path, int, int]]:
    """Every cache file, also what is left of an unfinished one, with its time and size."""
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
