"""Names for what people choose by mistake, with a way out for each."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from .format_error import FormatError


@dataclass(frozen=True)
class FileKind:
    """What a file is instead of a grid."""

    name: str
    way_out: str


HTML = FileKind(
    "an HTML page",
    "The server sent a page instead of the grid, perhaps an error or a login: download it again.",
)
PICTURE = "A picture has no heights: choose the grid that it was made from."
PACKED = "Unpack it first, and choose the grid inside."

MAGICS: tuple[tuple[bytes, FileKind], ...] = (
    (b"\x89PNG\r\n\x1a\n", FileKind("a PNG picture", PICTURE)),
    (b"\xff\xd8\xff", FileKind("a JPEG picture", PICTURE)),
    (b"GIF8", FileKind("a GIF picture", PICTURE)),
    (b"#?RADIANCE", FileKind("a Radiance picture", PICTURE)),
    (b"#?RGBE", FileKind("a Radiance picture", PICTURE)),
    (b"\x76\x2f\x31\x01", FileKind("an OpenEXR picture", PICTURE)),
    (b"8BPS", FileKind("a Photoshop picture", PICTURE)),
    (b"PK\x03\x04", FileKind("a zip archive", PACKED)),
    (b"\x1f\x8b\x08", FileKind("a gzip archive", PACKED)),
    (b"BZh", FileKind("a bzip2 archive", PACKED)),
    (b"\xfd7zXZ\x00", FileKind("an xz archive", PACKED)),
    (b"7z\xbc\xaf\x27\x1c", FileKind("a 7z archive", PACKED)),
    (b"Rar!", FileKind("a rar archive", PACKED)),
    (b"\x1f\x9d\x90", FileKind("a compress (.Z) archive", PACKED)),
    (b"\x28\xb5\x2f\xfd", FileKind("a zstd archive", PACKED)),
    (b"%PDF", FileKind("a PDF document", "Choose the grid that it describes.")),
    (b"BLENDER", FileKind("a Blender file", "Open it with File > Open.")),
)

HTML_WORDS = (b"<!doctype html", b"<html", b"<head", b"<body")


def kind_of_file(head: bytes) -> FileKind | None:
    """What a file is that is surely no grid; ``None`` where it may be one."""
    for magic, kind in MAGICS:
        if head.startswith(magic):
            return kind
    begun = head[:1024].lstrip(b"\xef\xbb\xbf \t\r\n").lower()
    if begun.startswith(b"<") and any(word in begun for word in HTML_WORDS):
        return HTML
    if begun.startswith((b"<?xml", b"<")) and _is_text(head[:1024]):
        return FileKind("an XML file", "Choose the grid that it belongs to, or its PDS4 label.")
    return None


def without_header(path: Path, length: int) -> FormatError:
    """The error for bytes that nothing describes."""
    names = f"{path.stem}.lbl, {path.stem}.xml or {path.stem}.hdr"
    return FormatError(
        path,
        "format",
        found=f"{length:,} bytes of no kind that is known, and none of {names} beside them",
        expected="an elevation grid with its label or header",
        way_out=(
            "Put the label or header beside the data file and choose either (.lbl or .img of MOLA); "
            "for other formats install rasterio into Blender's Python."
        ),
    )


def _is_text(head: bytes) -> bool:
    return b"\0" not in head
