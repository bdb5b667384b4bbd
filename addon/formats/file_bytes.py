"""The beginning and the length of a file, with errors that people understand."""

from __future__ import annotations

from pathlib import Path

from .format_error import FormatError


def read_head(path: Path, limit: int) -> bytes:
    """Read the first bytes of a file, ``limit`` of them at the most."""
    try:
        with path.open("rb") as file:
            return file.read(limit)
    except OSError as error:
        raise _unreadable(path, error) from error


def file_length(path: Path) -> int:
    """How many bytes a file has."""
    try:
        return path.stat().st_size
    except OSError as error:
        raise _unreadable(path, error) from error


def check_length(data_path: Path, needed: int, described_by: str, *, exact: bool = False) -> None:
    """Refuse a data file that ends before its header says.

    Args:
        needed: bytes that the header speaks of.
        described_by: where the header says so, for people.
        exact: whether more bytes are wrong too, because nothing but samples belongs into such a file.
    """
    found = file_length(data_path)
    if found < needed:
        raise FormatError(
            data_path,
            "length",
            found=f"{found:,} bytes",
            expected=f"{needed:,} bytes for {described_by}",
            way_out="The file is cut short: download it again.",
        )
    if exact and found > needed:
        raise FormatError(
            data_path,
            "length",
            found=f"{found:,} bytes",
            expected=f"{needed:,} bytes for {described_by}",
            way_out="It has bytes beyond the samples, as after a transfer as text: get it again as binary.",
        )


def _unreadable(path: Path, error: OSError) -> FormatError:
    return FormatError(
        path,
        "file",
        found=error.strerror or error,
        expected="a readable file",
        way_out="Check the path and its permissions.",
    )
