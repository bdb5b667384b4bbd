"""Elevation images of the Planetary Data System, version 3: MOLA, LOLA, and others that are made alike.

A label in words (``.lbl`` beside the data, or at the head of the data file) describes raw samples.

Format: Planetary Data System Standards Reference, version 3.8 (JPL D-7669), appendix A.20 (IMAGE object)
and appendix C (sample types). Products: "MGS MOLA Experiment Gridded Data Record Software Interface
Specification" (MEGDR and EGDR), "LRO LOLA Reduced Data Record and Derived Products SIS" (LDEM).
"""

from __future__ import annotations

from pathlib import Path

from ..elevation_grid import ElevationGrid
from ..file_bytes import check_length
from ..format_error import FormatError
from ..partner_file import file_in_any_case
from ..raw.data_beside import first_beside
from .label import Label, read_label
from .pds3_pointer import data_place
from .pds3_projection import pds3_georeference
from .pds3_samples import pds3_samples
from .pds3_values import pds3_values

LABEL_SUFFIX = ".lbl"


def read_pds3(path: Path) -> ElevationGrid:
    """Read a label, given it or the data file that it describes or begins."""
    label = read_label(_label_path(path))
    image = _image(label)
    data_path, offset = data_place(label, image)
    values = pds3_values(label, image)
    samples, sample_notes = pds3_samples(label, image, values, offset)
    georeference, place_notes = pds3_georeference(label, samples.rows, samples.columns, values)
    layout, decoding = samples.placed(georeference, label.wrong)
    check_length(data_path, samples.byte_length, f"LINES and LINE_SAMPLES in {label.path.name}")
    synthetic = _is_synthetic(label, image)
    return ElevationGrid(
        path=label.path,
        data_path=data_path,
        layout=layout,
        georeference=georeference,
        title=_title(label, georeference.body, values.kind, synthetic),
        format=_format(label),
        synthetic=synthetic,
        decoding=decoding,
        notes=(*values.notes, *sample_notes, *place_notes),
    )


def _label_path(path: Path) -> Path:
    """Find the label that belongs to the chosen file; the file itself where it begins with one."""
    if path.suffix.lower() == LABEL_SUFFIX:
        found = file_in_any_case(path)
    else:
        found = first_beside(path, [LABEL_SUFFIX]) or file_in_any_case(path)
    if found is None:
        raise FormatError(
            path,
            "label",
            found=f"no such file as {path.absolute()}",
            expected="a PDS3 label",
            way_out="Check the path.",
        )
    return found


def _image(label: Label) -> tuple[str, ...]:
    """Where in the label the IMAGE object is: outermost, or in the description of one of several files."""
    for place in (("IMAGE",), ("UNCOMPRESSED_FILE", "IMAGE"), ("FILE", "IMAGE")):
        if label.value(*place, default=None) is not None:
            return place
    return ("IMAGE",)  # whose absence the first look-up tells


def _is_synthetic(label: Label, image: tuple[str, ...]) -> bool:
    """Whether the label owns up to made-up heights."""
    places = (
        "TARGET_NAME",
        "DATA_SET_ID",
        "PRODUCT_ID",
        "INSTRUMENT_ID",
        "INSTRUMENT_NAME",
        "NOTE",
        "DESCRIPTION",
    )
    told = [label.text(place, default="") for place in places]
    told += [label.text(*image, place, default="") for place in ("NAME", "NOTE", "DESCRIPTION")]
    return any("SYNTHETIC" in text.upper() for text in told)


def _title(label: Label, body: str, kind: str, synthetic: bool) -> str:
    """Name the grid for people."""
    title = f"{body} {label.path.stem}".strip()
    if kind == "count":
        title = f"{title} (counts, not elevations)"
    return f"{title} (synthetic)" if synthetic and "synthetic" not in title.lower() else title


def _format(label: Label) -> str:
    """Name the instrument that people know the grid by."""
    told = " ".join(label.text(place, default="") for place in ("INSTRUMENT_ID", "DATA_SET_ID")).upper()
    for instrument in ("MOLA", "LOLA", "MLA", "HIRISE", "HRSC", "LROC"):
        if instrument in told:
            return f"{instrument} (PDS3)"
    return "PDS3"
