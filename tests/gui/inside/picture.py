"""What the screen shows, as pixels."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

Pixels = npt.NDArray[np.uint8]


@dataclass(frozen=True)
class Picture:
    """Of the whole screen, or of a part."""

    pixels: Pixels
    """Rows from above, columns, red green blue."""

    def around(self, x: float, y: float, *, radius: int) -> Picture:
        """Cut out a square around a place; x and y as Blender counts them, from the lower left."""
        row, column = self.pixels.shape[0] - round(y), round(x)
        top, left = max(row - radius, 0), max(column - radius, 0)
        return Picture(self.pixels[top : row + radius, left : column + radius])

    def differs_from(self, other: Picture, *, by: int = 24) -> npt.NDArray[np.bool_]:
        """Where one of the colours differs by more than so much of 255."""
        apart = np.abs(self.pixels.astype(np.int16) - other.pixels.astype(np.int16))
        return np.asarray(apart.max(axis=2) > by)

    def share_changed(self, before: Picture) -> float:
        """How much of it differs from an earlier picture of the same."""
        return float(self.differs_from(before).mean())

    def is_blank(self) -> bool:
        """Whether there is one colour only."""
        return bool((self.pixels == self.pixels[0, 0]).all())

    def save(self, path: Path) -> None:
        """Write a PNG."""
        rows, columns, _ = self.pixels.shape
        header = f"P6 {columns} {rows} 255\n".encode()
        data = header + np.ascontiguousarray(self.pixels).tobytes()
        subprocess.run(["magick", "ppm:-", str(path)], input=data, check=True)


def grab() -> Picture:
    """Take what the screen shows; Blender's own screenshots come out black here."""
    taken = subprocess.run(
        ["import", "-window", "root", "-depth", "8", "ppm:-"], capture_output=True, check=True
    ).stdout
    kind, columns, rows, depth = taken.split(maxsplit=4)[:4]
    if (kind, depth) != (b"P6", b"255"):
        raise ValueError(f"a screenshot of kind {kind!r} and depth {depth!r}")
    size = int(rows) * int(columns) * 3
    return Picture(np.frombuffer(taken[-size:], np.uint8).reshape(int(rows), int(columns), 3))
