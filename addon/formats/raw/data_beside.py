"""Data files beside their header, and headers beside their data, whatever the letter case."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path, PureWindowsPath

from ..partner_file import file_in_any_case

LONGEST_NAME = 255
"""Bytes of a file name that common file systems take."""


def is_bare_file_name(name: str) -> bool:
    """Whether a name leads to no other folder, on any system, and may be one at all."""
    return (
        name not in {"", ".", ".."}
        and PureWindowsPath(name).name == name
        and name.isprintable()
        and len(name.encode(errors="replace")) <= LONGEST_NAME
    )


def first_beside(path: Path, suffixes: Iterable[str]) -> Path | None:
    """The first file beside ``path`` that is named like it, its ending replaced by one of these."""
    for suffix in suffixes:
        found = file_in_any_case(path.parent / f"{path.stem}{suffix}")
        if found is not None and found != path:
            return found
    return None


def header_beside(data_path: Path, suffix: str) -> Path | None:
    """``name.hdr`` or ``name.dat.hdr`` for ``name.dat``."""
    whole = file_in_any_case(data_path.parent / f"{data_path.name}{suffix}")
    return whole or first_beside(data_path, [suffix])
