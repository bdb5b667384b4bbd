"""A decoding as text, and back.

Text, since what decoders need to know may be nested, and may have large numbers.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import Any

from .decoders import DECODERS
from .decoding import Decoding
from .raw.raw_decoder import raw_samples

MOST = 2**63
"""Columns and rows stay below."""


def decoding_text(decoding: Decoding) -> str:
    """Write a decoding down."""
    return json.dumps(asdict(decoding))


def decoding_from(kept: str) -> Decoding:
    """Make the decoding again.

    Raises:
        KeyError, TypeError, ValueError, OverflowError: it was changed, and no decoder could use it.
    """
    decoding = Decoding(**json.loads(kept))
    if decoding.kind not in DECODERS:
        raise ValueError(f"decoding: found {decoding.kind!r}, expected one of {', '.join(DECODERS)}")
    for name, first in (("first_column", decoding.first_column), ("first_row", decoding.first_row)):
        if type(first) is not int or not 0 <= first < MOST:
            raise ValueError(f"{name}: found {first!r}, expected a whole number from 0 on")
    if not isinstance(decoding.options, dict):
        raise TypeError(f"options: found {decoding.options!r}, expected names and values")
    check = OPTIONS.get(decoding.kind)
    if check is not None:
        check(decoding.options)
    return decoding


def _geotiff_options(options: Mapping[str, Any]) -> None:
    if type(options["south_up"]) is not bool:
        raise TypeError(f"south_up: found {options['south_up']!r}, expected true or false")
    float(options["fill"])


OPTIONS: dict[str, Callable[[Mapping[str, Any]], object]] = {
    "geotiff": _geotiff_options,
    "raw": raw_samples,
}
"""What raises where a decoder's options lack something; the other decoders have none."""
