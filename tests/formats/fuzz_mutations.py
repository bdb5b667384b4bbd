"""Ways to spoil files: bytes, numbers, lines, lengths, names."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

NUMBER = re.compile(rb"[-+]?\d+(?:\.\d+)?")
WORD = re.compile(rb"[A-Za-z_][A-Za-z0-9_:]{2,}")

NUMBERS = (
    *("0", "-1", "1", "2", "3", "-0.0", "0.5", "1e-320", "1e300", "-1e300", "1e400", "nan", "inf", "-inf"),
    *("255", "65536", "2147483647", "2147483648", "4294967296", "1000000000000", "9007199254740993"),
    *(
        "18446744073709551616",
        "9" * 400,
        "1" + "0" * 5000,
        "90",
        "-90",
        "180",
        "360",
        "-9999",
        "16#FF#",
        "''",
        "N/A",
    ),
)

PIECES = (
    *(
        b"(",
        b")",
        b"{",
        b"}",
        b"<",
        b">",
        b'"',
        b"'",
        b"=",
        b"\0",
        b"\r",
        b"\n",
        b"/*",
        b"*/",
        b"&a;",
        b"<!--",
    ),
    *(
        b"<!DOCTYPE a>",
        b"\xff\xfe",
        b"END\r\n",
        b"OBJECT = IMAGE\r\n",
        b"../",
        b"((((((((",
        b"#",
        b"\x1a",
        b",",
    ),
)

MOST_BYTES_SPOILT = 1 << 16
"""Of a file: what comes after is samples."""


def spoil(folder: Path, chance: random.Random) -> None:
    """Change one file, seldom more."""
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        files = [path for path in sorted(folder.iterdir()) if path.is_file()]
        # Headers have more to spoil than samples.
        files.sort(key=lambda path: path.suffix.lower() in {".img", ".dem", ".flt"})
        path = files[0] if chance.random() < 0.75 else chance.choice(files)
        if chance.random() < 0.03:
            path.rename(
                folder / chance.choice(("grid.hdr", "grid.dem", "grid.xml", "N91W999.hgt", "a.lbl", "grid"))
            )
            continue
        content = path.read_bytes()
        head, rest = content[:MOST_BYTES_SPOILT], content[MOST_BYTES_SPOILT:]
        path.write_bytes(chance.choice(WAYS)(head, chance) + rest)


def _number(content: bytes, chance: random.Random) -> bytes:
    return _replaced(content, NUMBER, chance.choice(NUMBERS).encode(), chance)


def _word(content: bytes, chance: random.Random) -> bytes:
    words = WORD.findall(content)
    return _replaced(content, WORD, chance.choice(words) if words else b"X", chance)


def _replaced(content: bytes, pattern: re.Pattern[bytes], new: bytes, chance: random.Random) -> bytes:
    found = list(pattern.finditer(content))
    if not found:
        return _bits(content, chance)
    match = chance.choice(found)
    return content[: match.start()] + new + content[match.end() :]


def _bits(content: bytes, chance: random.Random) -> bytes:
    spoilt = bytearray(content)
    for _ in range(chance.randint(1, 8)):
        if spoilt:
            spoilt[chance.randrange(len(spoilt))] = chance.randrange(256)
    return bytes(spoilt)


def _cut(content: bytes, chance: random.Random) -> bytes:
    return content[: chance.randint(0, len(content))]


def _piece(content: bytes, chance: random.Random) -> bytes:
    place = chance.randint(0, len(content))
    return content[:place] + chance.choice(PIECES) * chance.choice((1, 1, 2, 500)) + content[place:]


def _without_line(content: bytes, chance: random.Random) -> bytes:
    lines = content.splitlines(keepends=True)
    if lines:
        del lines[chance.randrange(len(lines))]
    return b"".join(lines)


def _line_twice(content: bytes, chance: random.Random) -> bytes:
    lines = content.splitlines(keepends=True)
    if lines:
        lines.insert(chance.randrange(len(lines)), chance.choice(lines))
    return b"".join(lines)


def _line_ends(content: bytes, chance: random.Random) -> bytes:
    return content.replace(b"\r\n", b"\n").replace(
        b"\n", chance.choice((b"\r\n", b"\r", b"\n\n", b" ", b"\0"))
    )


def _case(content: bytes, chance: random.Random) -> bytes:
    return content.swapcase() if chance.random() < 0.5 else content.lower()


def _grown(content: bytes, chance: random.Random) -> bytes:
    return content + bytes([chance.randrange(256)]) * chance.choice((1, 7, 512, 70_000))


WAYS: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    _number,
    _number,
    _number,
    _word,
    _bits,
    _bits,
    _cut,
    _piece,
    _without_line,
    _line_twice,
    _line_ends,
    _case,
    _grown,
)
