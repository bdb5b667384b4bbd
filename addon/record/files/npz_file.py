"""A take as NPZ: an array of doubles for each column, and texts ``about`` and ``units`` (JSON).

``numpy.load`` reads it. It is not read with that here: a header may ask for any amount of memory, or for
objects whose making runs code.
"""

from __future__ import annotations

import json
import re
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any

import numpy as np

from ...formats.format_error import FormatError
from ...formats.refusal import first_line, shortened
from ...formats.unfinished import unfinished_file
from ..about_properties import about_properties
from ..take_data import Numbers, TakeData
from .columns import meanings
from .read_take import WAY_OUT, ReadTake, about_of_text, is_kept, looked_over

ABOUT, UNITS = "about", "units"

SUFFIX = ".npy"

MOST_BYTES = 8 << 30
"""Of all arrays once they are unpacked: half a day of ticks."""

MOST_MEMBERS = 1000

MAGIC = b"\x93NUMPY\x01\x00"

HEADER = re.compile(
    r"\{'descr': '(<f8|<U\d{1,6})', 'fortran_order': (?:False|True), 'shape': \((?:(\d{1,12}),)?\), \} *\n"
)
"""Of the only arrays that belong here, as numpy writes it: a row of doubles, or a text.

https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
"""


def write_npz(path: Path, data: TakeData, derived: Mapping[str, Numbers]) -> None:
    """Write the arrays; where that fails, nothing is left and an older file stays as it was.

    Raises:
        OSError: it cannot be written.
    """
    columns = {**data.columns, **derived}
    texts = {ABOUT: about_properties(data.about), UNITS: meanings(list(columns))}
    arrays: dict[str, Any] = {name: np.array(json.dumps(text)) for name, text in texts.items()}
    arrays.update((name, np.asarray(values, dtype="<f8")) for name, values in columns.items())
    with unfinished_file(path) as file:
        np.savez(file, **arrays)


def read_npz(path: Path) -> ReadTake:
    """Read the arrays.

    Raises:
        FormatError: naming what cannot be used; also for a file that was cut short, which has lost its index.
        OSError: it cannot be read.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            arrays = _arrays(path, archive)
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError) as error:
        raise FormatError(
            path,
            "archive",
            found=first_line(error),
            expected="a whole NPZ file",
            way_out="It was cut short or damaged, or is something else: export the take again.",
        ) from error
    about = arrays.pop(ABOUT, None)
    if about is None or about.dtype.kind != "U":
        raise FormatError(path, ABOUT, found="nothing", expected="a text", way_out=WAY_OUT)
    columns = {name: values for name, values in arrays.items() if is_kept(name)}
    lengths = {name: values.shape for name, values in columns.items()}
    if len(set(lengths.values())) > 1 or () in lengths.values():
        found = shortened(", ".join(f"{name} {shape}" for name, shape in lengths.items()))
        raise FormatError(path, "columns", found=found, expected="columns of one length", way_out=WAY_OUT)
    return ReadTake(looked_over(path, columns, about_of_text(path, str(about))))


def _arrays(path: Path, archive: zipfile.ZipFile) -> dict[str, Any]:
    members = archive.infolist()
    size = sum(member.file_size for member in members)
    if len(members) > MOST_MEMBERS or size > MOST_BYTES:
        raise FormatError(
            path,
            "size",
            found=f"{len(members):,} arrays of {size:,} bytes",
            expected=f"{MOST_MEMBERS:,} of {MOST_BYTES:,} at the most",
            way_out=WAY_OUT,
        )
    arrays = {}
    for member in members:
        with archive.open(member) as file:
            arrays[member.filename.removesuffix(SUFFIX)] = _array(path, member, file)
    return arrays


def _array(path: Path, member: zipfile.ZipInfo, file: IO[bytes]) -> Any:
    """Read one array whose header tells of no more than there is."""
    start = file.read(len(MAGIC) + 2)
    length = int.from_bytes(start[len(MAGIC) :], "little")
    header = file.read(length).decode("latin-1") if start.startswith(MAGIC) else ""
    found = HEADER.fullmatch(header)
    kind = np.dtype(found[1]) if found is not None else np.dtype("<f8")
    count = int(found[2] or 1) if found is not None else -1
    is_column = found is not None and found[2] is not None and kind.kind == "f"
    is_text = found is not None and found[2] is None and kind.kind == "U"
    if not (is_column or is_text) or count * kind.itemsize != member.file_size - len(start) - length:
        raise FormatError(
            path,
            member.filename,
            found=shortened(f"{member.file_size:,} bytes: {header or start!r}"),
            expected="a row of doubles, or a text",
            way_out=WAY_OUT,
        )
    values = np.frombuffer(file.read(), dtype=kind)
    return values if is_column else values[0]
