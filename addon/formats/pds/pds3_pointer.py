"""Where a PDS3 label says that the samples are."""

from __future__ import annotations

from pathlib import Path

from ..file_bytes import read_head
from ..partner_file import file_in_any_case
from ..raw.data_beside import first_beside, is_bare_file_name
from ..through_rasterio.jpeg2000 import looks_like_jpeg2000
from .label import MAXIMUM_COUNT, Label

DATA_SUFFIXES = (".img", ".dat", ".raw")


def data_place(label: Label, image: tuple[str, ...]) -> tuple[Path, int]:
    """Find the data file that ``^IMAGE`` points to, and the byte at which its samples begin.

    Args:
        image: place of the IMAGE object, beside which the pointer stands.
    """
    outer = image[:-1]
    name, offset = _pointer(label, outer)
    if name is None:
        return label.path, offset
    if not is_bare_file_name(name):
        # A label that was downloaded has no business in other folders.
        raise label.wrong(
            "^IMAGE", f'"{name}"', "the bare name of a file beside the label", "Mend the label."
        )
    named = label.path.with_name(name)
    found = file_in_any_case(named) or first_beside(label.path, DATA_SUFFIXES)
    if found is None:
        raise label.wrong(
            "^IMAGE",
            f"no file {named.name} beside the label",
            "the data file that the label describes",
            f"Put {named.name} into the folder of the label.",
        )
    if looks_like_jpeg2000(read_head(found, 12)):
        raise label.wrong(
            "^IMAGE",
            f"{found.name}, a JPEG 2000 file",
            "raw samples",
            "Get the .IMG file of the same product, or choose the JPEG 2000 file itself.",
        )
    return found, offset


def _pointer(label: Label, outer: tuple[str, ...]) -> tuple[str | None, int]:
    """Read ``^IMAGE``: a name, a place in the label's own file, or a name and a place in that file.

    Places count from 1: records, or bytes where that unit is written.
    """
    pointer = label.value(*outer, "^IMAGE", default=None)
    if pointer is None:
        pointer = label.value("^IMAGE")
    if isinstance(pointer, str):
        return pointer, 0
    if isinstance(pointer, list | tuple) and len(pointer) == 2 and isinstance(pointer[0], str):
        name, place = pointer
    else:
        name, place = None, pointer
    in_bytes = "BYTE" in str(getattr(place, "units", "")).upper()
    number = place.value if in_bytes else place
    if _counts(number):
        before = int(number) - 1
        return name, before if in_bytes else before * _record_bytes(label, outer)
    raise label.wrong(
        "^IMAGE",
        pointer,
        "the name of a data file, and where in it the samples begin",
        "Mend the label.",
    )


def _counts(number: object) -> bool:
    return (
        isinstance(number, int | float)
        and not isinstance(number, bool)
        and 1 <= number <= MAXIMUM_COUNT
        and number == int(number)
    )


def _record_bytes(label: Label, outer: tuple[str, ...]) -> int:
    inside = label.value(*outer, "RECORD_BYTES", default=None) is not None
    return label.whole(*(outer if inside else ()), "RECORD_BYTES")
