"""How JPEG 2000 files begin (ISO/IEC 15444-1, annexes A and I)."""

from __future__ import annotations

MAGICS = (b"\x00\x00\x00\x0cjP  ", b"\xff\x4f\xff\x51")
"""In a box file, and as a bare codestream."""


def looks_like_jpeg2000(head: bytes) -> bool:
    """Whether a file is a JPEG 2000, whatever its name."""
    return head.startswith(MAGICS)
