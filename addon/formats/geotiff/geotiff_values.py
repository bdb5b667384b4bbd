"""What the stored values of a TIFF file mean as heights: scale, offset and unit."""

from __future__ import annotations

import html
import math
import re
from dataclasses import dataclass

from ..height_units import UNITS
from .geotiff_frame import Frame
from .geotiff_tags import GDAL_METADATA, Tags

ITEM = re.compile(r"<Item\b([^<>]{0,400})>([^<]{0,200})</Item>")
"""A line of the metadata; XML is not parsed as such, for it may hide entities without end."""

ATTRIBUTE = re.compile(r"(\w+)\s*=\s*[\"']([^\"']*)[\"']")


@dataclass(frozen=True)
class Values:
    """Elevation in metres = stored value * scale + offset."""

    scale: float
    offset: float
    unit: str
    """As the file calls it."""
    notes: tuple[str, ...] = ()


def values_of(tags: Tags, frame: Frame) -> Values:
    """Read GDAL_METADATA of the first band; the unit may come from the vertical keys instead.

    Raises:
        DecodeError: the tag cannot be read as text.
    """
    items = _items_of_first_band(tags.text(GDAL_METADATA))
    unit, metres, notes = frame.vertical_unit, frame.vertical_metres, []
    stated = items.get("unittype", "").strip()
    if stated.lower() in UNITS:
        unit, metres = stated, UNITS[stated.lower()]
    elif stated:
        notes.append(f'The unit of heights is "{stated[:40]}", which is not known here: {unit} is assumed.')
    scale, offset = _number(tags, items, "scale", 1.0), _number(tags, items, "offset", 0.0)
    if scale == 0.0:
        raise tags.wrong("SCALE", scale, "a number other than 0", "Mend it: gdal_edit.py -scale 1.")
    return Values(scale * metres, offset * metres, unit, tuple(notes))


def _items_of_first_band(metadata: str) -> dict[str, str]:
    """Find texts by their role (scale, offset, unittype), those of band 0."""
    found: dict[str, str] = {}
    for attributes, text in ITEM.findall(metadata):
        named = dict(ATTRIBUTE.findall(attributes))
        if "role" in named and named.get("sample", "0") == "0":
            found[named["role"].lower()] = html.unescape(text)
    return found


def _number(tags: Tags, items: dict[str, str], role: str, default: float) -> float:
    text = items.get(role)
    if text is None:
        return default
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise tags.wrong(role.upper(), text, "a finite number", f"Mend it: gdal_edit.py -{role} {default:g}.")
    return number
