"""A PDS4 label (XML), with errors that name the file and the element.

Format: "PDS4 Data Dictionary" and "PDS4 Information Model Specification" (NASA Planetary Data System).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from ..file_bytes import read_head
from ..format_error import FormatError
from ..refusal import first_line, refusal
from .label import Units

MAXIMUM_BYTES = 4 << 20
"""Labels have 10 to 300 kilobytes."""

NAMESPACE = "pds.nasa.gov/pds4/"
"""Part of the name of every PDS4 namespace."""


@dataclass(frozen=True)
class Pds4Label:
    """Elements of a label, looked up by their names without namespaces."""

    path: Path
    root: Element

    def all(self, name: str, within: Element | None = None) -> list[Element]:
        """Every element of that name, however deep."""
        if within is None:
            return self._by_name.get(name, [])
        return [element for element in within.iter() if local_name(element) == name]

    def first(self, *names: str, within: Element | None = None) -> Element | None:
        """The first element that has one of these names, the names in order of preference."""
        for name in names:
            found = self.all(name, within)
            if found:
                return found[0]
        return None

    def text(self, *names: str, within: Element | None = None, default: str | None = None) -> str:
        """The text of an element."""
        found = self.first(*names, within=within)
        text = (found.text or "").strip() if found is not None else ""
        if text:
            return text
        if default is None:
            raise self.wrong(names[0], "nothing", "it in the label", "Choose the label of an elevation grid.")
        return default

    def number(self, *names: str, within: Element | None = None, units: Units | None = None) -> float:
        """A finite number, in the first of ``units``."""
        number = self.optional_number(*names, within=within, units=units)
        if number is None:
            raise self.wrong(names[0], "nothing", "it in the label", "Choose the label of an elevation grid.")
        return number

    def optional_number(
        self, *names: str, within: Element | None = None, units: Units | None = None
    ) -> float | None:
        """A finite number, or ``None`` where the label does not have it."""
        found = self.first(*names, within=within)
        if found is None or not (found.text or "").strip():
            return None
        return self.element_number(found, units)

    def element_number(self, element: Element, units: Units | None = None) -> float:
        """The finite number that an element holds.

        Args:
            units: factors by unit in lower case; without a ``unit`` the first is meant.
        """
        name, text = local_name(element), (element.text or "").strip()
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise self.wrong(name, text, "a number", "Mend the label.")
        if units is None:
            return number
        unit = element.get("unit", next(iter(units))).lower().replace(" ", "")
        if unit not in units:
            raise self.wrong(name, f"the unit {unit}", ", ".join(units), "Mend the label.")
        return number * units[unit]

    def wrong(self, field: str, found: object, expected: object, way_out: str) -> FormatError:
        """Make the error for one of this label's elements."""
        return refusal(self.path, field, found, expected, way_out)

    @cached_property
    def _by_name(self) -> dict[str, list[Element]]:
        """All elements: a reader asks for dozens of names, and a label may have a million elements."""
        named: dict[str, list[Element]] = {}
        for element in self.root.iter():
            named.setdefault(local_name(element), []).append(element)
        return named


def read_pds4_label(path: Path) -> Pds4Label:
    """Read a label."""
    text = read_head(path, MAXIMUM_BYTES + 1)
    if len(text) > MAXIMUM_BYTES:
        raise _no_label(path, f"more than {MAXIMUM_BYTES:,} bytes")
    parser = ElementTree.XMLParser(target=_WithoutDocumentType())
    try:
        parser.feed(text)
        root = parser.close()
    except _DocumentTypeError as error:
        raise _no_label(path, "a document type declaration, which labels never have") from error
    # Besides ParseError: encodings that expat does not know.
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise _no_label(path, f"XML that cannot be followed ({first_line(error)})") from error
    if NAMESPACE not in root.tag:
        raise _no_label(path, f"an XML file of kind {local_name(root)}")
    return Pds4Label(path, root)


def local_name(element: Element) -> str:
    """An element's name without its namespace; comments have none."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


class _DocumentTypeError(Exception):
    """A document type may define entities that grow without end, or that read other files."""


class _WithoutDocumentType(ElementTree.TreeBuilder):
    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:
        """Refuse it before any entity is defined."""
        raise _DocumentTypeError(name)


def _no_label(path: Path, found: str) -> FormatError:
    return FormatError(
        path,
        "label",
        found=found,
        expected="a PDS4 label",
        way_out="Choose the .xml file that came with the grid.",
    )
