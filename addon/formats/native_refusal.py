"""What the native decoders refuse, in the words of every reader."""

from __future__ import annotations

from pathlib import Path

from proxygraph import DecodeError

from .format_error import FormatError

MAXIMUM_FOUND = 160
"""Letters of what was found that a message repeats."""


def native_refusal(path: Path, error: Exception, way_out: str) -> FormatError:
    """Make the error for a file that a decoder, or the system, refused."""
    if isinstance(error, DecodeError) and len(error.args) == 3:
        field, found, expected = (str(part)[:MAXIMUM_FOUND] for part in error.args)
        return FormatError(path, field, found=found, expected=expected, way_out=way_out)
    if isinstance(error, OSError):
        return FormatError(
            path,
            "file",
            found=error.strerror or type(error).__name__,
            expected="a readable file",
            way_out="Check the path and its permissions.",
        )
    return FormatError(
        path, "grid", found=str(error)[:MAXIMUM_FOUND], expected="a grid that can be touched", way_out=way_out
    )
