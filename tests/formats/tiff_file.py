"""Small TIFF files for tests, of every kind that the reader takes, and a few that it must refuse.

Written here from the format's description ("TIFF Revision 6.0", "OGC GeoTIFF Standard" 1.1), so that the
tests need no other software.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from struct import calcsize, pack
from typing import Any, Literal

Rows = Sequence[Sequence[float]]
Value = tuple[int, Sequence[Any] | str]
"""A field type of TIFF, and the values (a text for ASCII)."""

BYTE, ASCII, SHORT, LONG, DOUBLE, LONG8 = 1, 2, 3, 4, 12, 16
FORMATS = {BYTE: "B", SHORT: "H", LONG: "I", DOUBLE: "d", LONG8: "Q"}

SAMPLES = {
    "u8": ("B", 1),
    "i8": ("b", 2),
    "u16": ("H", 1),
    "i16": ("h", 2),
    "u32": ("I", 1),
    "i32": ("i", 2),
    "f32": ("f", 3),
    "f64": ("d", 3),
}
"""Format as in ``struct``, and the tag SampleFormat."""

WGS_84: Mapping[int, Any] = {1024: 2, 1025: 1, 2048: 4326}
"""Geo keys of longitudes and latitudes."""


@dataclass
class TiffFile:
    """A file that is right by default; tests spoil one thing each."""

    heights: Rows
    sample: str = "i16"
    order: Literal["<", ">"] = "<"
    big: bool = False
    compression: int = 1
    predictor: int = 1
    tile: tuple[int, int] | None = None
    """Columns and rows of a tile; strips where there is none."""
    rows_per_strip: int = 3
    bands: int = 1
    """Beyond the first, bands hold 1, 2 ..."""
    planar: bool = False
    keys: Mapping[int, Any] = field(default_factory=lambda: dict(WGS_84))
    """Geo keys: whole numbers are codes, others doubles, texts texts; none leaves the directory out."""
    tags: Mapping[int, Value | None] = field(default_factory=dict)
    """Tags to add or change; ``None`` leaves one out."""
    absent: frozenset[int] = frozenset()
    """Chunks that are left out."""
    name: str = "grid.tif"

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.heights)

    @property
    def columns(self) -> int:
        """Samples in a row."""
        return len(self.heights[0])

    def write(self, folder: Path) -> Path:
        """Write the file; gives its path."""
        path = folder / self.name
        path.write_bytes(self.data())
        return path

    def data(self) -> bytes:
        """The whole file: header, chunks, values, directory."""
        header = 16 if self.big else 8
        body = bytearray()
        offsets, lengths = [], []
        for index, chunk in enumerate(self._chunks()):
            packed = b"" if index in self.absent else self._packed(chunk)
            offsets.append(header + len(body) if packed else 0)
            lengths.append(len(packed))
            body += packed
        tags = self._tags(offsets, lengths)
        return self._header(header, body, tags)

    def _header(self, header: int, body: bytearray, tags: Mapping[int, Value]) -> bytes:
        """Put the directory behind the body, and values that do not fit into it before it."""
        count, place, room = ("Q", "Q", 8) if self.big else ("I", "I", 4)
        entries = bytearray()
        for tag, (kind, values) in sorted(tags.items()):
            raw, number = self._raw(kind, values)
            if len(raw) <= room:
                value = raw.ljust(room, b"\0")
            else:
                value = pack(self.order + place, header + len(body))
                body += raw
            entries += pack(self.order + "HH" + count, tag, kind, number) + value
        start = header + len(body)
        mark = b"II" if self.order == "<" else b"MM"
        if self.big:
            head = mark + pack(self.order + "HHHQ", 43, 8, 0, start)
            return bytes(head + body + pack(self.order + "Q", len(tags)) + entries + bytes(8))
        head = mark + pack(self.order + "HI", 42, start)
        return bytes(head + body + pack(self.order + "H", len(tags)) + entries + bytes(4))

    def _raw(self, kind: int, values: Sequence[Any] | str) -> tuple[bytes, int]:
        if isinstance(values, str):
            text = values.encode() + b"\0"
            return text, len(text)
        return pack(f"{self.order}{len(values)}{FORMATS[kind]}", *values), len(values)

    def _tags(self, offsets: list[int], lengths: list[int]) -> dict[int, Value]:
        size = calcsize(self._format()) * 8
        place = LONG8 if self.big else LONG
        tags: dict[int, Value | None] = {
            256: (LONG, [self.columns]),
            257: (LONG, [self.rows]),
            258: (SHORT, [size] * self.bands),
            259: (SHORT, [self.compression]),
            262: (SHORT, [1]),
            277: (SHORT, [self.bands]),
            284: (SHORT, [2 if self.planar else 1]),
            317: (SHORT, [self.predictor]),
            339: (SHORT, [SAMPLES[self.sample][1]] * self.bands),
            33550: (DOUBLE, [0.5, 0.25, 0.0]),
            33922: (DOUBLE, [0.0, 0.0, 0.0, 10.0, 20.0, 0.0]),
            **self._key_tags(),
        }
        if self.tile:
            tags |= {322: (LONG, [self.tile[0]]), 323: (LONG, [self.tile[1]])}
            tags |= {324: (place, offsets), 325: (place, lengths)}
        else:
            tags |= {273: (place, offsets), 278: (LONG, [self.rows_per_strip]), 279: (place, lengths)}
        tags |= self.tags
        return {tag: value for tag, value in tags.items() if value is not None}

    def _key_tags(self) -> dict[int, Value | None]:
        """The geo keys in their three tags."""
        if not self.keys:
            return {}
        directory, doubles, texts = [1, 1, 1, len(self.keys)], list[float](), ""
        for key, value in sorted(self.keys.items()):
            if isinstance(value, str):
                directory += [key, 34737, len(value) + 1, len(texts)]
                texts += f"{value}|"
            elif isinstance(value, float):
                directory += [key, 34736, 1, len(doubles)]
                doubles.append(value)
            else:
                directory += [key, 0, 1, value]
        tags: dict[int, Value | None] = {34735: (SHORT, directory)}
        if doubles:
            tags[34736] = (DOUBLE, doubles)
        if texts:
            tags[34737] = (ASCII, texts)
        return tags

    def _format(self) -> str:
        return self.order + SAMPLES[self.sample][0]

    def _chunks(self) -> Iterator[list[list[list[float]]]]:
        """Give each chunk as rows of places of bands."""
        bands = [self.heights, *([[float(band)] * self.columns] * self.rows for band in range(1, self.bands))]
        for planes in [[band] for band in bands] if self.planar else [bands]:
            width, height = self.tile or (self.columns, self.rows_per_strip)
            for top in range(0, self.rows, height):
                for left in range(0, self.columns, width):
                    yield self._chunk(planes, left, top, width, height)

    def _chunk(
        self, planes: Sequence[Rows], left: int, top: int, width: int, height: int
    ) -> list[list[list[float]]]:
        bottom = top + height if self.tile else min(top + height, self.rows)
        return [
            [
                # Tiles go on beyond the raster: the last sample again.
                [plane[min(row, self.rows - 1)][min(column, self.columns - 1)] for plane in planes]
                for column in range(left, left + width)
            ]
            for row in range(top, bottom)
        ]

    def _packed(self, chunk: list[list[list[float]]]) -> bytes:
        raw = b"".join(self.packed_row(row) for row in chunk)
        return COMPRESSIONS[self.compression](raw)

    def packed_row(self, row: list[list[float]]) -> bytes:
        """Apply the predictor to a row."""
        code = self._format()
        size, bands = calcsize(code), len(row[0])
        number = float if self.sample.startswith("f") else int
        samples = [pack(code, number(value)) for place in row for value in place]
        if self.predictor == 2:
            order: Literal["little", "big"] = "little" if self.order == "<" else "big"
            numbers = [int.from_bytes(sample, order) for sample in samples]
            before = [0] * bands + numbers
            differences = (number - last for number, last in zip(numbers, before, strict=False))
            return b"".join((number % 256**size).to_bytes(size, order) for number in differences)
        if self.predictor == 3:
            highest_first = [sample if self.order == ">" else sample[::-1] for sample in samples]
            planes = bytes(sample[weight] for weight in range(size) for sample in highest_first)
            before_bytes = bytes(bands) + planes
            return bytes((byte - last) % 256 for byte, last in zip(planes, before_bytes, strict=False))
        return b"".join(samples)


def packbits(data: bytes) -> bytes:
    """Runs of equal bytes, and of others (TIFF 6.0, section 9)."""
    packed = bytearray()
    place = 0
    while place < len(data):
        run = 1
        while place + run < len(data) and run < 128 and data[place + run] == data[place]:
            run += 1
        if run > 1:
            packed += bytes([257 - run, data[place]])
        else:
            packed += bytes([0, data[place]])
        place += run
    return bytes(packed)


def lzw(data: bytes) -> bytes:
    """Lempel, Ziv and Welch's compression (TIFF 6.0, section 13): codes of 9 to 12 bits, highest first."""
    clear, end = 256, 257
    bits: list[str] = []
    strings: dict[bytes, int] = {}
    width = 9

    def start_again() -> None:
        nonlocal strings, width
        bits.append(format(clear, f"0{width}b"))
        strings, width = {bytes([byte]): byte for byte in range(256)}, 9

    start_again()
    known = b""
    for byte in data:
        longer = known + bytes([byte])
        if longer in strings:
            known = longer
            continue
        bits.append(format(strings[known], f"0{width}b"))
        strings[longer] = len(strings) + 2
        # Codes grow as soon as the table has the last that fits, not when it is written: unlike GIF's.
        if len(strings) + 2 in {512, 1024, 2048}:
            width += 1
        if len(strings) + 2 == 4094:
            start_again()
        known = bytes([byte])
    if known:
        bits.append(format(strings[known], f"0{width}b"))
        if len(strings) + 3 in {512, 1024, 2048}:
            width += 1
    bits.append(format(end, f"0{width}b"))
    text = "".join(bits)
    text += "0" * (-len(text) % 8)
    return int(text, 2).to_bytes(len(text) // 8, "big")


COMPRESSIONS: dict[int, Callable[[bytes], bytes]] = {
    1: bytes,
    5: lzw,
    8: zlib.compress,
    32946: zlib.compress,
    32773: packbits,
}
"""By the number in the file."""
