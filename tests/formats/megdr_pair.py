"""Small MEGDR pairs for tests: a label beside raw 16-bit samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from struct import pack

Rows = Sequence[Sequence[int]]


@dataclass
class MegdrPair:
    """A pair that is right by default; tests spoil one thing each."""

    heights: Rows
    pixels_per_degree: float = 1.0
    north: float = 10.0
    """Maximum latitude, degrees."""
    west: float = 20.0
    """Westernmost longitude, degrees."""
    image: Mapping[str, object] = field(default_factory=dict)
    """Keywords of the IMAGE object to change; ``None`` leaves one out."""
    projection: Mapping[str, object] = field(default_factory=dict)
    """Keywords of IMAGE_MAP_PROJECTION to change."""
    header: Mapping[str, object] = field(default_factory=dict)
    """Keywords outside of objects to change."""
    sample: str = ">h"
    """Format of one sample, as in ``struct``."""
    name: str = "grid"

    @property
    def rows(self) -> int:
        """Number of lines."""
        return len(self.heights)

    @property
    def columns(self) -> int:
        """Number of samples a line."""
        return len(self.heights[0])

    def data(self) -> bytes:
        """The samples, row by row."""
        return b"".join(pack(self.sample, height) for row in self.heights for height in row)

    def label(self) -> str:
        """The label's text."""
        header = {
            "RECORD_TYPE": "FIXED_LENGTH",
            "RECORD_BYTES": 2 * self.columns,
            "^IMAGE": f'"{self.name.upper()}.IMG"',
            "DATA_SET_ID": '"MGS-M-MOLA-5-MEGDR-L3-V1.0"',
            "TARGET_NAME": "MARS",
            **self.header,
        }
        image = {
            "NAME": "MEDIAN_TOPOGRAPHY",
            "LINES": self.rows,
            "LINE_SAMPLES": self.columns,
            "SAMPLE_TYPE": "MSB_INTEGER",
            "SAMPLE_BITS": 16,
            **self.image,
        }
        projection = {
            "MAP_PROJECTION_TYPE": '"SIMPLE CYLINDRICAL"',
            "MAP_RESOLUTION": f"{self.pixels_per_degree} <PIXEL/DEGREE>",
            "A_AXIS_RADIUS": "3396.0 <KM>",
            "POSITIVE_LONGITUDE_DIRECTION": '"EAST"',
            "MAP_SCALE": "999.0 <KM/PIXEL>",  # wrong on purpose: never to be used
            "MAXIMUM_LATITUDE": self.north,
            "MINIMUM_LATITUDE": self.north - self.rows / self.pixels_per_degree,
            "WESTERNMOST_LONGITUDE": self.west,
            "EASTERNMOST_LONGITUDE": self.west + self.columns / self.pixels_per_degree,
            **self.projection,
        }
        lines = ["PDS_VERSION_ID = PDS3", *_keywords(header)]
        lines += ["OBJECT = IMAGE", *_keywords(image), "END_OBJECT = IMAGE"]
        lines += [
            "OBJECT = IMAGE_MAP_PROJECTION",
            *_keywords(projection),
            "END_OBJECT = IMAGE_MAP_PROJECTION",
        ]
        return "\r\n".join([*lines, "END", ""])

    def write(self, folder: Path) -> Path:
        """Write both files; gives the label's path."""
        (folder / f"{self.name}.img").write_bytes(self.data())
        label = folder / f"{self.name}.lbl"
        label.write_text(self.label(), encoding="ascii", newline="")
        return label


def rough(rows: int, columns: int) -> list[list[int]]:
    """Heights in metres that differ everywhere, without a pattern that a mistake could share."""
    return [
        [(row * 7919 + column * 104_729) % 4001 - 2000 for column in range(columns)] for row in range(rows)
    ]


def planet(rows_per_degree: int = 1) -> MegdrPair:
    """A whole planet, which wraps; 1 row a degree unless told."""
    heights = rough(180 * rows_per_degree, 360 * rows_per_degree)
    return MegdrPair(heights, pixels_per_degree=float(rows_per_degree), north=90.0, west=0.0, name="planet")


def _keywords(values: Mapping[str, object]) -> list[str]:
    return [f"{keyword} = {value}" for keyword, value in values.items() if value is not None]
