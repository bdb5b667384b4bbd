"""What a ``.prj`` file states: body, ellipsoid, projection and units of a map.

Two forms are followed: well-known text (WKT 1, Esri's and OGC's), and Arc/Info's keywords, as GTOPO30 has
them (USGS GTOPO30 documentation, section 6.4). Anything else is no error: such a map is touched all the same.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from ..body.bodies import body_told, ellipsoid_named
from ..body.datums import DATUM_WGS84, DATUMS
from ..body.ellipsoid import Ellipsoid
from ..projections import Geographic, Projection, Unknown
from .stated_projection import utm
from .wkt import WktError, WktNode, parse_wkt
from .wkt_projection import projection_of_wkt

LENGTHS = {"METERS": 1.0, "METRES": 1.0, "METER": 1.0, "M": 1.0, "FEET": 1200.0 / 3937.0}
ANGLES = {"DD": 1.0, "DS": 1.0 / 3600.0, "DM": 1.0 / 60.0, "RADIANS": math.degrees(1.0)}
HEIGHTS = {"METERS": 1.0, "METRES": 1.0, "METER": 1.0, "M": 1.0, "NO": 1.0, "FEET": 0.3048}

PARIS = 2.33722917
"""Degrees east of Greenwich (IGN; 2.5969213 grads)."""


@dataclass(frozen=True)
class StatedFrame:
    """The frame of a map."""

    body: str
    """Empty where nobody can tell."""
    ellipsoid: Ellipsoid
    projection: Projection
    name: str
    """In the file's own words."""
    unit: float = 1.0
    """Degrees or metres for one of the map's own units."""
    shift_x: float = 0.0
    """Degrees that longitudes are counted from east of Greenwich; always 0 on a projected map."""
    vertical_unit: float = 1.0
    """Metres for one unit of height."""
    notes: tuple[str, ...] = ()
    """What a person should know."""


def stated_frame(text: str) -> StatedFrame | None:
    """Follow the text of a ``.prj`` file, or a coordinate system string; ``None``: not possible."""
    frame = _of_keywords(text)
    if frame is not None:
        return frame
    try:
        node = parse_wkt(text.removeprefix("\xef\xbb\xbf"))
    except WktError:
        return None
    if node.name == "COMPD_CS":
        node = node.child("PROJCS", "GEOGCS") or node
    if node.name == "GEOGCS":
        return _geographic(node)
    return _projected(node) if node.name == "PROJCS" else None


def _geographic(node: WktNode) -> StatedFrame | None:
    ellipsoid = _ellipsoid(node)
    unit = _unit(node, usual=math.radians(1.0))
    if ellipsoid is None or unit is None:
        return None
    degrees = math.degrees(unit)
    # A degree is written with a dozen digits, or fewer: near enough, it is meant.
    degrees = 1.0 if math.isclose(degrees, 1.0, rel_tol=1e-6) else degrees
    meridian = _meridian(node, degrees)
    if meridian is None:
        return None
    return StatedFrame(
        _body(node, ellipsoid), ellipsoid, Geographic(), node.text(), unit=degrees, shift_x=meridian
    )


def _projected(node: WktNode) -> StatedFrame | None:
    base = node.child("GEOGCS")
    geographic = None if base is None else _geographic(base)
    metres = _unit(node, usual=1.0)
    if geographic is None or metres is None:
        return None
    projection = projection_of_wkt(node, geographic.ellipsoid, geographic.unit, metres, geographic.shift_x)
    notes: tuple[str, ...] = ()
    if isinstance(projection, Unknown):
        method = node.child("PROJECTION")
        stated = method.text() if method is not None else "none"
        notes = (
            f"The projection {stated[:60]} is not known here, or not all of it is stated: "
            "places are told in its metres.",
        )
    return StatedFrame(
        geographic.body, geographic.ellipsoid, projection, node.text(), unit=metres, notes=notes
    )


def _ellipsoid(node: WktNode) -> Ellipsoid | None:
    datum = node.child("DATUM")
    spheroid = None if datum is None else datum.child("SPHEROID", "ELLIPSOID")
    axis = None if spheroid is None else spheroid.number(1)
    inverse = None if spheroid is None else spheroid.number(2)
    if axis is None or inverse is None or not (1.0 <= axis <= 1e9):
        return None
    # The flattest planet, Saturn, has 10.
    return Ellipsoid.flattened(axis, inverse) if inverse == 0.0 or 2.0 <= inverse <= 1e12 else None


def _unit(node: WktNode, usual: float) -> float | None:
    """Radians or metres for a unit."""
    unit = node.child("UNIT")
    value = usual if unit is None else unit.number(1)
    return value if value is not None and 1e-9 <= value <= 1e9 else None


def _meridian(node: WktNode, degrees: float) -> float | None:
    """Degrees east of Greenwich that longitudes are counted from.

    They are stated in the system's own unit; but GDAL and Esri state Paris in degrees beside grads.
    """
    prime = node.child("PRIMEM")
    value = 0.0 if prime is None else prime.number(1)
    if value is None or not abs(value) <= 1e6:
        return None
    return value if math.isclose(value, PARIS, abs_tol=1e-5) else value * degrees


def _body(node: WktNode, ellipsoid: Ellipsoid) -> str:
    """The body that the names speak of, else one of this size."""
    datum = node.child("DATUM")
    return body_told(f"{node.text()} {datum.text() if datum is not None else ''}", ellipsoid)


def _of_keywords(text: str) -> StatedFrame | None:
    """Follow Arc/Info's keywords: a word and its value a line."""
    lines = (line.split() for line in text.upper().splitlines())
    words = {pair[0]: pair[1] for pair in lines if len(pair) >= 2}
    if "PROJECTION" not in words:
        return None
    datum = _stated_datum(words)
    if datum is None:
        return None
    name, ellipsoid = datum
    height = HEIGHTS.get(words.get("ZUNITS", "METERS"), 1.0)
    if words["PROJECTION"] == "GEOGRAPHIC":
        unit = ANGLES.get(words.get("UNITS", "DD"))
        if unit is None:
            return None
        title = f"{name}, longitude and latitude"
        return StatedFrame("Earth", ellipsoid, Geographic(), title, unit=unit, vertical_unit=height)
    length = LENGTHS.get(words.get("UNITS", "METERS"))
    if length is None:
        return None
    if words["PROJECTION"] == "UTM" and words.get("ZONE", "").lstrip("+-").isdigit():
        zone = int(words["ZONE"][:4])
        title = f"{name}, UTM zone {abs(zone)}{'S' if zone < 0 else 'N'}"
        projection = utm(abs(zone), north=zone > 0)
        return StatedFrame("Earth", ellipsoid, projection, title, unit=length, vertical_unit=height)
    stated = words["PROJECTION"][:60]
    note = f"The projection {stated} is not known here: places are told in its metres."
    return StatedFrame(
        "Earth", ellipsoid, Unknown(), f"{name}, {stated}", unit=length, vertical_unit=height, notes=(note,)
    )


def _stated_datum(words: Mapping[str, str]) -> tuple[str, Ellipsoid] | None:
    """The datum or spheroid by its name; WGS 84 where neither is stated."""
    for keyword in ("DATUM", "SPHEROID"):
        if keyword in words:
            known = DATUMS.get(words[keyword].replace("_", "").replace(" ", ""))
            if known is not None:
                return known.name, known.ellipsoid
            shape = ellipsoid_named(words[keyword])
            if shape is not None:
                return shape.name, shape.ellipsoid
    is_stated = "DATUM" in words or "SPHEROID" in words
    return None if is_stated else (DATUM_WGS84.name, DATUM_WGS84.ellipsoid)
