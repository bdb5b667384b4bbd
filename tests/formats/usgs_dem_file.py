"""Small USGS DEMs for tests, in every form that such files have."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

VOID = -32767


@dataclass(frozen=True)
class ProfileOfHeights:
    """Heights from south to north."""

    x: float
    y: float
    heights: Sequence[int | None]
    """``None`` is a blank field."""
    local_datum: float = 0.0


def staggered() -> list[ProfileOfHeights]:
    """Profiles that begin and end elsewhere each; the middle one takes three records."""
    return [
        ProfileOfHeights(500_010.0, 4_000_020.0, [100 + row for row in range(5)]),
        ProfileOfHeights(500_040.0, 3_999_990.0, [200 + row for row in range(350)]),
        ProfileOfHeights(500_070.0, 4_000_050.0, [300, VOID, 302, -32000, -7]),
    ]


@dataclass
class DemFile:
    """A file that is right by default; tests spoil one thing each."""

    profiles: Sequence[ProfileOfHeights] = field(default_factory=staggered)
    header_bytes: int = 1024
    """Of the A record: 864, 893, 918 or 1024."""
    line: str = ""
    """What ends a record."""
    trimmed: bool = False
    """Whether blanks before the end of a line are gone."""
    exponent: str = "D"
    fields: Mapping[int, str] = field(default_factory=dict)
    """Texts to put into the A record, by their first byte from 1."""

    def header(self) -> str:
        """The A record."""
        record = [" "] * 1024
        fields = {
            1: "A QUADRANGLE, NOWHERE",
            145: "     1     1     1    10",
            529: "     2     2     4",
            547: "".join(self.real(number, 24) for number in self.corners()),
            817: self.real(30.0, 12) + self.real(30.0, 12) + self.real(1.0, 12),
            853: f"{1:6}{len(self.profiles):6}",
            **({889: " 2 4"} if self.header_bytes > 892 else {}),
            **self.fields,
        }
        for first, text in fields.items():
            record[first - 1 : first - 1 + len(text)] = text
        return "".join(record)[: self.header_bytes]

    def corners(self) -> list[float]:
        """South-west, north-west, north-east and south-east."""
        return [
            500_000.0,
            4_000_000.0,
            500_000.0,
            4_010_000.0,
            500_080.0,
            4_010_000.0,
            500_080.0,
            4_000_000.0,
        ]

    def real(self, number: float, width: int) -> str:
        """A number as FORTRAN writes it: 0.5D+06."""
        mantissa, _, power = f"{number:.{width - 10}e}".partition("e")
        digits = mantissa.replace(".", "").lstrip("-")
        whole = f"{'-' if number < 0.0 else ''}0.{digits}"
        return f"{whole}{self.exponent}{int(power) + 1:+03d}".rjust(width)[:width]

    def records(self, number: int) -> list[str]:
        """The records of a profile, without their ends."""
        profile = self.profiles[number]
        known = [height for height in profile.heights if height is not None] or [0]
        facts = [profile.x, profile.y, profile.local_datum, min(known), max(known)]
        head = f"{1:6}{number + 1:6}{len(profile.heights):6}{1:6}" + "".join(self.real(f, 24) for f in facts)
        texts = ["      " if height is None else f"{height:6}" for height in profile.heights]
        pieces = [head + "".join(texts[:146])]
        return pieces + ["".join(texts[first : first + 170]) for first in range(146, len(texts), 170)]

    def data(self) -> bytes:
        """The whole file."""
        return b"".join(self.pieces())

    def pieces(self) -> list[bytes]:
        """The A record, then every record of every profile, then the C record."""
        records = [record for number in range(len(self.profiles)) for record in self.records(number)]
        accuracy = "".join(f"{number:6}" for number in (1, 3, 3, 3, 0, 1, 1, 1, 3, 20))
        return [self.ended(self.header(), self.header_bytes)] + [
            self.ended(record, 1024) for record in [*records, accuracy]
        ]

    def ended(self, record: str, length: int) -> bytes:
        """A record with its end."""
        text = record.rstrip() if self.trimmed else record.ljust(length)
        return (text + self.line).encode("ascii")

    def write(self, folder: Path) -> Path:
        """Write it; gives its path."""
        path = folder / "quadrangle.dem"
        path.write_bytes(self.data())
        return path
