"""Type, order and place of the samples of a PDS3 image."""

from __future__ import annotations

from ..raw.raw_samples import RAW_BYTES, ByteOrder, RawSample
from ..raw.stored_samples import StoredSamples
from .label import Label
from .pds3_values import Pds3Values
from .void_bits import hexadecimal, sample_of_bits

BIG_INTEGERS = ("MSB_INTEGER", "INTEGER", "SUN_INTEGER", "MAC_INTEGER")
LITTLE_INTEGERS = ("LSB_INTEGER", "PC_INTEGER", "VAX_INTEGER")
BIG_COUNTS = ("MSB_UNSIGNED_INTEGER", "UNSIGNED_INTEGER", "SUN_UNSIGNED_INTEGER", "MAC_UNSIGNED_INTEGER")
LITTLE_COUNTS = ("LSB_UNSIGNED_INTEGER", "PC_UNSIGNED_INTEGER", "VAX_UNSIGNED_INTEGER")
BIG_REALS = ("IEEE_REAL", "REAL", "FLOAT", "SUN_REAL", "MAC_REAL")
LITTLE_REALS = ("PC_REAL",)

SAMPLE_TYPES: dict[str, tuple[str, ByteOrder]] = {
    **dict.fromkeys(BIG_INTEGERS, ("i", "big")),
    **dict.fromkeys(LITTLE_INTEGERS, ("i", "little")),
    **dict.fromkeys(BIG_COUNTS, ("u", "big")),
    **dict.fromkeys(LITTLE_COUNTS, ("u", "little")),
    **dict.fromkeys(BIG_REALS, ("f", "big")),
    **dict.fromkeys(LITTLE_REALS, ("f", "little")),
}
"""Names of appendix C of the Standards Reference; VAX_REAL is no IEEE number and is refused."""

STORED: dict[tuple[str, int], RawSample] = {
    ("i", 8): "i8",
    ("u", 8): "u8",
    ("i", 16): "i16",
    ("u", 16): "u16",
    ("i", 32): "i32",
    ("u", 32): "u32",
    ("f", 32): "f32",
    ("f", 64): "f64",
}

VOIDS = ("MISSING_CONSTANT", "MISSING", "CORE_NULL", "NULL", "INVALID_CONSTANT")
"""Keywords for the value that means "no data", in the order in which they are believed."""


def pds3_samples(
    label: Label, image: tuple[str, ...], values: Pds3Values, offset: int
) -> tuple[StoredSamples, tuple[str, ...]]:
    """Say where the samples lie; and what a person should know of that.

    Args:
        offset: bytes before the image.
    """
    encoding = label.text(*image, "ENCODING_TYPE", default="N/A").upper()
    if encoding not in {"N/A", "NONE", "NULL"}:
        raise label.wrong("ENCODING_TYPE", encoding, "raw samples", "Unpack the image first.")
    stored, byte_order = _stored(label, image)
    rows, columns = label.whole(*image, "LINES"), label.whole(*image, "LINE_SAMPLES")
    prefix = label.whole(*image, "LINE_PREFIX_BYTES", default=0)
    suffix = label.whole(*image, "LINE_SUFFIX_BYTES", default=0)
    bands = label.whole(*image, "BANDS", default=1)
    storage = label.text(*image, "BAND_STORAGE_TYPE", default="BAND_SEQUENTIAL").upper()
    size = RAW_BYTES[stored]
    if bands > 1 and storage not in {"BAND_SEQUENTIAL", "LINE_INTERLEAVED", "SAMPLE_INTERLEAVED"}:
        raise label.wrong("BAND_STORAGE_TYPE", storage, "BAND_SEQUENTIAL", "Choose a grid of one band.")
    bands_in_line = bands if bands > 1 and storage != "BAND_SEQUENTIAL" else 1
    samples = StoredSamples(
        rows,
        columns,
        stored,
        byte_order,
        offset=offset + prefix,
        row_stride=prefix + bands_in_line * columns * size + suffix,
        sample_stride=bands_in_line * size if storage == "SAMPLE_INTERLEAVED" else None,
        scale=values.scale,
        value_offset=values.offset,
        void=_void(label, image, stored),
    )
    samples.check_size(label.wrong, "LINES", "LINE_SAMPLES")
    notes = (f"The file has {bands} bands: the first is read.",) if bands > 1 else ()
    return samples, notes


def _stored(label: Label, image: tuple[str, ...]) -> tuple[RawSample, ByteOrder]:
    """Translate ``SAMPLE_TYPE`` and ``SAMPLE_BITS``."""
    name = label.text(*image, "SAMPLE_TYPE").replace(" ", "_").upper()
    if name not in SAMPLE_TYPES:
        raise label.wrong(
            "SAMPLE_TYPE",
            name,
            "MSB_INTEGER, LSB_INTEGER, IEEE_REAL, PC_REAL and their kin",
            "Convert the grid, or mend the label.",
        )
    kind, byte_order = SAMPLE_TYPES[name]
    bits = label.whole(*image, "SAMPLE_BITS")
    if (kind, bits) not in STORED:
        sizes = ", ".join(str(size) for letter, size in STORED if letter == kind)
        raise label.wrong("SAMPLE_BITS", bits, f"{sizes} for {name}", "Convert the grid, or mend the label.")
    return STORED[kind, bits], byte_order


def _void(label: Label, image: tuple[str, ...], stored: RawSample) -> float | None:
    """The value that means "no data"; where its bits are stated (16#8000#) the sample that has them."""
    for keyword in VOIDS:
        value = label.value(*image, keyword, default=None)
        if value is None:
            continue
        if isinstance(value, str):
            bits = hexadecimal(value)
            if bits is not None:
                return _of_bits(label, keyword, bits, value, stored)
            continue  # N/A, NULL, UNK
        number = label.number(*image, keyword)
        if isinstance(value, int) and _may_be_bits(value, stored):
            return _of_bits(label, keyword, value, f"{value:,} (16#{value:X}#)", stored)
        return number
    return None


def _of_bits(label: Label, keyword: str, bits: int, written: str, stored: RawSample) -> float:
    try:
        return sample_of_bits(bits, stored)
    except ValueError as error:
        size = f"the {8 * RAW_BYTES[stored]} bits of a sample"
        raise label.wrong(keyword, written, size, "Mend the label.") from error


def _may_be_bits(number: int, stored: RawSample) -> bool:
    """Whether a whole number is the bits of a sample: pvl does not tell how it was written.

    Where it is a sample's value it has the same bits; as a value of real samples only numbers are believed
    that have neither bit 31 nor bit 63, the signs.
    """
    if stored == "f32":
        return 2**31 <= number < 2**32
    if stored == "f64":
        return 2**63 <= number < 2**64
    return number >= 0
