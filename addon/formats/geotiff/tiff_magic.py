"""How TIFF files begin.

Source: "TIFF Revision 6.0" (Adobe, 1992), section 2; "The BigTIFF File Format" (AWare Systems).
"""

from __future__ import annotations

MAGICS = (b"II*\x00", b"MM\x00*", b"II+\x00", b"MM\x00+")
"""Little-endian, big-endian, and the same of BigTIFF."""


def looks_like_tiff(head: bytes) -> bool:
    """Whether a file is a TIFF, whatever its name."""
    return head[:4] in MAGICS
