"""The one error that every reader raises."""

from __future__ import annotations

from pathlib import Path


class FormatError(ValueError):
    """A file cannot be used; the text names file, field, found, expected and a way out."""

    def __init__(self, file: Path, field: str, *, found: object, expected: object, way_out: str) -> None:
        super().__init__(f"{file.name}: {field}: found {found}, expected {expected}. {way_out}")
        self.file = file
        self.field = field
