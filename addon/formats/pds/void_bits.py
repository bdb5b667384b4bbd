"""Voids that a label states as the bits of a sample: 16#8000#, 16#FF7FFFFB#, 0x8000.

Source: Planetary Data System Standards Reference, version 3.8 (JPL D-7669), chapter 12.
"""

from __future__ import annotations

import re
import struct

from ..raw.raw_samples import RAW_BYTES, RawSample

HEXADECIMAL = re.compile(r"(?:16#([0-9A-F]+)#?|0X([0-9A-F]+))", re.IGNORECASE)

MOST_BITS = 64


def hexadecimal(text: str) -> int | None:
    """The whole number that a text holds as 16#...# or 0x...; ``None``: it is none of these."""
    found = HEXADECIMAL.fullmatch(text.strip())
    return None if found is None else int(found[1] or found[2], 16)


def sample_of_bits(bits: int, stored: RawSample) -> float:
    """The sample that has these bits.

    Whole numbers below 0 may be written with more bits than they have (16#FFFF8000# for 16#8000#); double
    precision, by the bits of single precision.

    Raises:
        ValueError: no sample of this type has so many bits.
    """
    if stored in {"f32", "f64"}:
        return _real(bits, stored)
    size = 8 * RAW_BYTES[stored]
    high = bits >> size
    extended = high in {(1 << wider - size) - 1 for wider in (16, 32, MOST_BITS) if wider > size}
    negative = stored.startswith("i") and bits >> (size - 1) & 1 == 1
    if high and not (extended and negative):
        raise ValueError(f"{bits:X} has more than {size} bits")
    low = bits & (1 << size) - 1
    return float(low - (1 << size) if negative else low)


def _real(bits: int, stored: RawSample) -> float:
    """A number of single precision, or of double precision where there are more bits."""
    if bits < 1 << 32:
        (number,) = struct.unpack(">f", bits.to_bytes(4, "big"))
    elif bits < 1 << MOST_BITS and stored == "f64":
        (number,) = struct.unpack(">d", bits.to_bytes(8, "big"))
    else:
        raise ValueError(f"{bits:X} has more than {8 * RAW_BYTES[stored]} bits")
    return float(number)
