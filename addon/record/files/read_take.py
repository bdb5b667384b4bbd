"""What every reader of takes gives, once it was looked over: files come from anywhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...formats.format_error import FormatError
from ...formats.refusal import shortened
from ..about_properties import read_about
from ..take_data import MODES, NEEDED, Numbers, TakeAbout, TakeData
from .columns import DERIVED, MAY_BE_UNKNOWN, MEANINGS

WAY_OUT = "Export the take again."

FEATURES = 4
"""Free, face, edge and vertex."""


@dataclass(frozen=True)
class ReadTake:
    """A take from a file."""

    data: TakeData
    notes: tuple[str, ...] = ()
    """What a person should know: what was lost."""


def about_of_text(path: Path, text: str) -> TakeAbout:
    """Read what a take was felt on.

    Raises:
        FormatError: that is damaged.
    """
    try:
        return read_about(text)[0]
    except ValueError as error:
        raise FormatError(
            path,
            "about",
            found=shortened(str(error)),
            expected="what the take was felt on, as JSON",
            way_out=WAY_OUT,
        ) from error


def is_kept(name: str) -> bool:
    """Whether a column is read: not what is worked out again, and nothing that nobody knows here."""
    return name in MEANINGS and name not in DERIVED


def looked_over(path: Path, columns: Mapping[str, Numbers], about: TakeAbout) -> TakeData:
    """Make a take of columns of one length.

    Raises:
        FormatError: naming the column with what cannot be.
    """
    missing = [name for name in NEEDED if name not in columns]
    if missing:
        raise FormatError(
            path,
            "columns",
            found=f"no {', '.join(missing)}",
            expected=", ".join(NEEDED),
            way_out=WAY_OUT,
        )
    if not len(columns["time"]):
        raise FormatError(path, "ticks", found="none", expected="at least one", way_out=WAY_OUT)
    for name, values in columns.items():
        known = np.isfinite(values) | (np.isnan(values) & (name in MAY_BE_UNKNOWN))
        _check(path, name, values, known, "finite numbers")
    time = columns["time"]
    _check(path, "time", time, np.diff(time, prepend=time[0]) >= 0.0, "seconds that never fall")
    _check(path, "feature", columns["feature"], _among(columns["feature"], FEATURES), "0 to 3")
    _check(path, "mode", columns["mode"], _among(columns["mode"], len(MODES)), "0 to 2")
    for name in ("window_width", "window_exaggeration"):
        _check(path, name, columns[name], columns[name] > 0.0, "numbers above 0")
    return TakeData(dict(columns), about)


def _among(values: Numbers, count: int) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    return np.isin(values, np.arange(count))


def _check(path: Path, name: str, values: Numbers, good: object, expected: str) -> None:
    bad = np.flatnonzero(~np.asarray(good))
    if len(bad):
        tick = int(bad[0])
        raise FormatError(
            path,
            f"column {name}, tick {tick + 1:,}",
            found=repr(float(values[tick])),
            expected=expected,
            way_out=WAY_OUT,
        )
