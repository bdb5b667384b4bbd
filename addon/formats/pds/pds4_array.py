"""Elevation arrays of the Planetary Data System, version 4: a label in XML beside raw samples.

Format: "PDS4 Information Model Specification" (NASA Planetary Data System): Array_2D, Array_2D_Image,
Array_2D_Map; Element_Array; Special_Constants.
"""

from __future__ import annotations

from pathlib import Path
from xml.etree.ElementTree import Element

from ..elevation_grid import ElevationGrid
from ..file_bytes import check_length
from ..partner_file import file_in_any_case
from ..raw.data_beside import first_beside, is_bare_file_name
from ..raw.raw_samples import RAW_BYTES, ByteOrder, RawSample
from ..raw.stored_samples import StoredSamples
from .label import Units
from .pds4_label import Pds4Label, local_name, read_pds4_label
from .pds4_projection import pds4_georeference
from .void_bits import hexadecimal, sample_of_bits

ARRAYS = ("Array_2D_Image", "Array_2D_Map", "Array_2D", "Array_3D_Image", "Array_3D")

DATA_TYPES: dict[str, tuple[RawSample, ByteOrder]] = {
    "SignedByte": ("i8", "big"),
    "UnsignedByte": ("u8", "big"),
    "SignedMSB2": ("i16", "big"),
    "SignedLSB2": ("i16", "little"),
    "UnsignedMSB2": ("u16", "big"),
    "UnsignedLSB2": ("u16", "little"),
    "SignedMSB4": ("i32", "big"),
    "SignedLSB4": ("i32", "little"),
    "UnsignedMSB4": ("u32", "big"),
    "UnsignedLSB4": ("u32", "little"),
    "SignedMSB8": ("i64", "big"),
    "SignedLSB8": ("i64", "little"),
    "UnsignedMSB8": ("u64", "big"),
    "UnsignedLSB8": ("u64", "little"),
    "IEEE754MSBSingle": ("f32", "big"),
    "IEEE754LSBSingle": ("f32", "little"),
    "IEEE754MSBDouble": ("f64", "big"),
    "IEEE754LSBDouble": ("f64", "little"),
}

LENGTHS: Units = {
    "m": 1.0,
    "meter": 1.0,
    "meters": 1.0,
    "metre": 1.0,
    "metres": 1.0,
    "km": 1000.0,
    "kilometer": 1000.0,
    "kilometers": 1000.0,
}
"""To metres, of an Element_Array's unit."""

VOIDS = ("missing_constant", "invalid_constant", "unknown_constant", "not_applicable_constant")


def read_pds4(path: Path) -> ElevationGrid:
    """Read a label, given it or the data file that it describes."""
    label = read_pds4_label(_label_path(path))
    area, array = _array(label)
    data_path = _data_path(label, area)
    samples, reference, notes = _samples(label, array)
    samples.check_size(label.wrong, "elements of axis Line", "elements of axis Sample")
    georeference, place_notes = pds4_georeference(label, samples.rows, samples.columns, reference)
    layout, decoding = samples.placed(georeference, label.wrong)
    check_length(data_path, samples.byte_length, f"the Axis_Arrays in {label.path.name}")
    told = " ".join(label.text(name, default="") for name in ("title", "description", "comment")).upper()
    synthetic = "SYNTHETIC" in told
    title = f"{georeference.body} {label.path.stem}".strip()
    return ElevationGrid(
        path=label.path,
        data_path=data_path,
        layout=layout,
        georeference=georeference,
        title=f"{title} (synthetic)" if synthetic else title,
        format="PDS4",
        synthetic=synthetic,
        decoding=decoding,
        notes=(*notes, *place_notes),
    )


def _label_path(path: Path) -> Path:
    """Find the label that belongs to the chosen file."""
    if path.suffix.lower() in {".xml", ".lblx"}:
        return file_in_any_case(path) or path
    return first_beside(path, [".xml", ".lblx"]) or path


def _array(label: Pds4Label) -> tuple[Element, Element]:
    """The first array of elevations, and the file area that it is in."""
    areas = _file_areas(label.root)
    for name in ARRAYS:
        for area in areas:
            found = label.first(name, within=area)
            if found is not None:
                return area, found
    raise label.wrong(
        "Array_2D_Image",
        "no array in a File_Area",
        "Array_2D_Image, Array_2D_Map or Array_2D",
        "Choose the label of an elevation grid.",
    )


def _file_areas(root: Element) -> list[Element]:
    """The file areas, in the label's order; what is inside one belongs to it."""
    areas = []
    waiting = [root]
    while waiting:
        element = waiting.pop()
        if local_name(element).startswith("File_Area_"):
            areas.append(element)
        else:
            waiting.extend(reversed(element))
    return areas


def _data_path(label: Pds4Label, area: Element) -> Path:
    """The data file, which lies beside its label."""
    name = label.text("file_name", within=area)
    if not is_bare_file_name(name):
        # A label that was downloaded has no business in other folders.
        raise label.wrong(
            "file_name", f'"{name}"', "the bare name of a file beside the label", "Mend the label."
        )
    found = file_in_any_case(label.path.with_name(name))
    if found is None:
        raise label.wrong(
            "file_name",
            f"no file {name} beside the label",
            "the data file that the label describes",
            f"Put {name} into the folder of the label.",
        )
    return found


def _samples(label: Pds4Label, array: Element) -> tuple[StoredSamples, str, tuple[str, ...]]:
    """Where the samples lie, what elevation 0 means, and notes."""
    sizes = _axes(label, array)
    element = label.first("Element_Array", within=array)
    if element is None:
        raise label.wrong("Element_Array", "nothing", "it in the array", "Mend the label.")
    stored, byte_order = _stored(label, element)
    unit = label.text("unit", within=element, default="m").lower()
    if unit not in LENGTHS:
        raise label.wrong("unit", unit, "m or km", "Choose a grid of elevations.")
    metres = LENGTHS[unit]
    scale = label.optional_number("scaling_factor", within=element)
    offset = label.optional_number("value_offset", within=element) or 0.0
    samples = StoredSamples(
        sizes["line"],
        sizes["sample"],
        stored,
        byte_order,
        offset=_offset(label, array),
        scale=metres * (1.0 if scale is None else scale),
        value_offset=metres * offset,
        void=_void(label, array, stored),
    )
    bands = sizes.get("band", 1)
    notes = (f"The file has {bands} bands: the first is read.",) if bands > 1 else ()
    return samples, _reference(label, metres * offset), notes


def _reference(label: Pds4Label, offset: float) -> str:
    """What elevation 0 means; an offset that is the radius makes planetary radii of the samples."""
    radius = label.optional_number("a_axis_radius", "semi_major_radius", units={"m": 1.0, "km": 1000.0})
    if radius is not None and radius > 0.0 and abs(offset - radius) < 1e-3 * radius:
        return "centre of the body"
    return "reference surface of the body"


def _axes(label: Pds4Label, array: Element) -> dict[str, int]:
    """Elements of each axis; the last axis runs fastest, and must be the samples of a line."""
    order = label.text("axis_index_order", within=array, default="Last Index Fastest")
    if order.lower() != "last index fastest":
        raise label.wrong("axis_index_order", order, "Last Index Fastest", "Convert the grid.")
    numbered = []
    axes = [child for child in array if local_name(child) == "Axis_Array"]
    for position, axis in enumerate(axes):
        name = label.text("axis_name", within=axis).lower()
        sequence = label.optional_number("sequence_number", within=axis)
        numbered.append((position + 1 if sequence is None else sequence, name, _elements(label, axis)))
    numbered.sort()
    names = [name for _, name, _ in numbered]
    if len(numbered) == 2 and set(names) != {"line", "sample"}:
        names = ["line", "sample"]  # arrays that are no images name their axes as they like
    if names not in (["line", "sample"], ["band", "line", "sample"]):
        raise label.wrong(
            "Axis_Array",
            " x ".join(names) or "nothing",
            "Line x Sample, or Band x Line x Sample",
            "Convert the grid.",
        )
    return {name: count for name, (_, _, count) in zip(names, numbered, strict=True)}


def _elements(label: Pds4Label, axis: Element) -> int:
    count = label.number("elements", within=axis)
    if not 0 <= count <= 2**53 or count != int(count):
        raise label.wrong("elements", f"{count:g}", "a whole number", "Mend the label.")
    return int(count)


def _stored(label: Pds4Label, element: Element) -> tuple[RawSample, ByteOrder]:
    name = label.text("data_type", within=element)
    if name not in DATA_TYPES:
        raise label.wrong("data_type", name, ", ".join(DATA_TYPES), "Convert the grid, or mend the label.")
    return DATA_TYPES[name]


def _offset(label: Pds4Label, array: Element) -> int:
    found = next((child for child in array if local_name(child) == "offset"), None)
    number = 0.0 if found is None else label.element_number(found)
    if not 0 <= number <= 2**53 or number != int(number):
        raise label.wrong("offset", f"{number:g}", "a whole number of bytes", "Mend the label.")
    return int(number)


def _void(label: Pds4Label, array: Element, stored: RawSample) -> float | None:
    constants = label.first("Special_Constants", within=array)
    if constants is None:
        return None
    for name in VOIDS:
        text = label.text(name, within=constants, default="")
        if text.lower() in {"", "nan", "-nan", "inf", "-inf"}:
            continue
        bits = hexadecimal(text)
        if bits is None:
            return label.number(name, within=constants)
        try:
            return sample_of_bits(bits, stored)
        except ValueError as error:
            size = f"the {8 * RAW_BYTES[stored]} bits of a sample"
            raise label.wrong(name, text, size, "Mend the label.") from error
    return None
