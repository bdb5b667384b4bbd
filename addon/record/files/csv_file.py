"""A take as a table: comments that say what it is, a line of names, and a line for each tick.

Comments begin with ``#``, as numpy and pandas leave them out. Numbers are written so that they come back to
their last bit. What cannot be told (a longitude beside the map) is left empty.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

import numpy as np

from ...formats.format_error import FormatError
from ...formats.refusal import first_line, shortened
from ...formats.unfinished import unfinished_file
from ..about_properties import about_properties
from ..take_data import Numbers, TakeAbout, TakeData
from .columns import meanings
from .read_take import WAY_OUT, ReadTake, about_of_text, is_kept, looked_over

FIRST = "# haptic_terrain take 1"
"""Of every such file; the number is that of this way of writing."""

ABOUT, TICKS = "# about: ", "# ticks: "

LINES_AT_ONCE = 4096

MOST_IN_LINE = 1 << 16
"""Letters: no line that is written here comes near."""


def write_csv(
    path: Path,
    data: TakeData,
    derived: Mapping[str, Numbers],
    tell: Callable[[float], None] = lambda _share: None,
) -> None:
    """Write the table; where that fails, nothing is left and an older file stays as it was.

    Args:
        derived: columns beside those of the take.
        tell: is told the share that is written, again and again.

    Raises:
        OSError: it cannot be written.
    """
    columns = {**data.columns, **derived}
    with unfinished_file(path) as file:
        for line in _head(data, list(columns)):
            file.write(f"{line}\n".encode())
        for first in range(0, len(data), LINES_AT_ONCE):
            some = [_texts(values[first : first + LINES_AT_ONCE]) for values in columns.values()]
            file.write("".join(f"{','.join(line)}\n" for line in zip(*some, strict=True)).encode())
            tell(first / len(data))


def read_csv(path: Path) -> ReadTake:
    """Read the table. Of a file that was cut short the whole lines are read, and the loss is told.

    Raises:
        FormatError: naming what cannot be used.
        OSError: it cannot be read.
    """
    try:
        with path.open(encoding="utf-8", newline="\n") as file:
            head = _read_head(path, file)
            lines = _WholeLines(path, file)
            kept = [number for number, name in enumerate(head.names) if is_kept(name)]
            table = _table(path, lines, kept)
    except UnicodeDecodeError as error:
        raise FormatError(
            path,
            "text",
            found=f"bytes that are no UTF-8 ({error.reason})",
            expected="a take",
            way_out=WAY_OUT,
        ) from error
    columns = {head.names[number]: table[:, at].copy() for at, number in enumerate(kept)}
    if len(table) > head.ticks:
        raise FormatError(
            path,
            "ticks",
            found=f"{len(table):,}",
            expected=f"{head.ticks:,} as the head says",
            way_out=WAY_OUT,
        )
    lost = head.ticks - len(table)
    notes = (
        (f"{path.name} was cut short: the last {lost:,} of {head.ticks:,} ticks are lost.",) if lost else ()
    )
    return ReadTake(looked_over(path, columns, head.about), notes)


@dataclass(frozen=True)
class _Head:
    about: TakeAbout
    ticks: int
    names: list[str]


def _head(data: TakeData, names: list[str]) -> Iterator[str]:
    yield FIRST
    yield ABOUT + json.dumps(about_properties(data.about))
    yield f"{TICKS}{len(data)}"
    for name, meaning in meanings(names).items():
        yield f"# {name}: {meaning}"
    yield ",".join(names)


def _texts(values: Numbers) -> list[str]:
    texts = list(map(repr, values.tolist()))
    for unknown in np.flatnonzero(np.isnan(values)).tolist():
        texts[unknown] = ""
    return texts


def _read_head(path: Path, file: TextIO) -> _Head:
    first = file.readline(MOST_IN_LINE).rstrip("\r\n")
    if first != FIRST:
        raise FormatError(
            path,
            "first line",
            found=repr(shortened(first)),
            expected=repr(FIRST),
            way_out="Choose a take that was exported as CSV.",
        )
    about = ticks = None
    line = file.readline(MOST_IN_LINE)
    while line.startswith("#"):
        if line.startswith(ABOUT):
            about = about_of_text(path, line.removeprefix(ABOUT))
        elif line.startswith(TICKS):
            ticks = _count(path, line.removeprefix(TICKS))
        line = file.readline(MOST_IN_LINE)
    if about is None or ticks is None or not line.endswith("\n"):
        raise FormatError(
            path,
            "head",
            found="a part of it",
            expected="about, ticks and the columns' names",
            way_out=WAY_OUT,
        )
    names = line.rstrip("\r\n").split(",")
    if len(set(names)) < len(names):
        raise FormatError(
            path, "names of columns", found=shortened(line), expected="each of them once", way_out=WAY_OUT
        )
    return _Head(about, ticks, names)


def _count(path: Path, text: str) -> int:
    digits = text.strip()
    if not (digits.isascii() and digits.isdigit() and len(digits) < 16):
        raise FormatError(path, "ticks", found=shortened(digits), expected="a whole number", way_out=WAY_OUT)
    return int(digits)


@dataclass
class _WholeLines:
    """The lines that have their end; the last one lacks it where a file was cut short."""

    path: Path
    file: TextIO

    def __iter__(self) -> Iterator[str]:
        while (line := self.file.readline(MOST_IN_LINE)).endswith("\n"):
            yield _filled(line) if ",," in line or line[0] == "," else line
        if len(line) == MOST_IN_LINE:
            raise FormatError(
                self.path,
                "line",
                found=f"more than {MOST_IN_LINE:,} letters",
                expected="the numbers of a tick",
                way_out=WAY_OUT,
            )


def _filled(line: str) -> str:
    """Write out what was left empty, as numpy reads it."""
    fields = line.rstrip("\r\n").split(",")
    return ",".join(field or "nan" for field in fields) + "\n"


def _table(path: Path, lines: _WholeLines, kept: list[int]) -> Numbers:
    """Read the numbers of the kept columns, ticks x columns."""
    first = next(iter(lines), None)
    if first is None:
        return np.zeros((0, len(kept)))

    def every() -> Iterator[str]:
        yield first
        yield from lines

    try:
        table: Numbers = np.loadtxt(every(), delimiter=",", usecols=kept, ndmin=2, comments=None)
    except FormatError:
        raise
    except (ValueError, IndexError) as error:
        raise FormatError(
            path, "numbers", found=first_line(error), expected="a number in each column", way_out=WAY_OUT
        ) from error
    return table
