"""The coordinate system of a GeoTIFF file: body, ellipsoid, projection, units, vertical reference."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from ..body.bodies import body_in, body_told
from ..body.ellipsoid import Ellipsoid
from ..frames.map_frame import MapFrame
from ..projections import Geographic, Projection, Unknown
from .geokeys import UNDEFINED, USER_DEFINED, GeoKeys, Key, geo_keys
from .geokeys_codes import (
    ANGULAR_UNITS,
    DATUMS,
    ELLIPSOIDS,
    GEODETIC,
    LINEAR_UNITS,
    PRIME_MERIDIANS,
    VERTICAL,
    VERTICAL_DATUMS,
    WGS_84,
    Heights,
)
from .geokeys_codes import Frame as Datum
from .geokeys_projections import projection_of_code, projection_of_keys
from .geotiff_tags import Tags

PROJECTED, GEOGRAPHIC, GEOCENTRIC = 1, 2, 3
"""Values of GTModelType."""

PIXEL_IS_POINT = 2
"""Value of GTRasterType."""

LARGEST_BODY = 1e9
"""Metres: more than any body has."""


@dataclass(frozen=True)
class Frame:
    """What the keys say."""

    body: str
    ellipsoid: Ellipsoid
    projection: Projection
    metres_or_degrees: float
    """In the unit of the map's coordinates."""
    prime_meridian: float
    """Degrees to add to the map's x where it is a longitude."""
    is_points: bool
    vertical_reference: str
    vertical_unit: str
    vertical_metres: float
    """In the unit of heights."""
    name: str
    """Of the coordinate system, in the file's own words."""
    citation: str
    """All texts of the keys together."""
    notes: tuple[str, ...]
    is_stated: bool = True
    """Whether the keys say what the map's coordinates are."""

    def taken_from(self, beside: MapFrame) -> Frame:
        """The frame of a map that is told beside the file; what the keys do say stays."""
        told = replace(
            self,
            body=self.body or beside.body,
            ellipsoid=beside.ellipsoid,
            projection=beside.projection,
            metres_or_degrees=beside.unit,
            prime_meridian=beside.shift_x,
            name=self.name or beside.frame,
            notes=(*self.notes, *beside.notes),
            is_stated=True,
        )
        if beside.vertical_unit == 1.0:
            return told
        return replace(
            told, vertical_unit=f"{beside.vertical_unit:g} m", vertical_metres=beside.vertical_unit
        )


@dataclass(frozen=True)
class _Horizontal:
    projection: Projection
    ellipsoid: Ellipsoid
    unit: float
    prime_meridian: float
    name: str
    is_stated: bool = True


def frame_of(tags: Tags) -> Frame:
    """Read the keys.

    Raises:
        DecodeError: a tag cannot be read.
    """
    keys = geo_keys(tags)
    notes: list[str] = []
    citations = [keys.text(key) for key in (Key.GTCitation, Key.ProjectedCitation, Key.GeodeticCitation)]
    citation = " | ".join(dict.fromkeys(text for text in citations if text))
    horizontal = _horizontal(keys, notes)
    vertical, unit, metres = _vertical(keys, notes)
    return Frame(
        body=body_told(citation, horizontal.ellipsoid) if horizontal.is_stated else _named(citation),
        ellipsoid=horizontal.ellipsoid,
        projection=horizontal.projection,
        metres_or_degrees=horizontal.unit,
        prime_meridian=horizontal.prime_meridian,
        is_points=keys.code(Key.GTRasterType) == PIXEL_IS_POINT,
        vertical_reference=vertical,
        vertical_unit=unit,
        vertical_metres=metres,
        name=horizontal.name or citation,
        citation=citation,
        notes=tuple(notes),
        is_stated=horizontal.is_stated,
    )


def _horizontal(keys: GeoKeys, notes: list[str]) -> _Horizontal:
    model = keys.code(Key.GTModelType)
    if model == GEOCENTRIC:
        raise keys.tags.wrong(
            "GTModelType",
            "3 (geocentric)",
            "1 (projected) or 2 (geographic)",
            "Such coordinates make no map: gdalwarp -t_srs EPSG:4326 old.tif new.tif makes one.",
        )
    if model == GEOGRAPHIC or (model != PROJECTED and keys.code(Key.GeodeticCRS) != UNDEFINED):
        return _geographic(keys, notes)
    if model == PROJECTED or keys.code(Key.ProjectedCRS) != UNDEFINED:
        return _projected(keys, notes)
    return _Horizontal(Unknown(), WGS_84, 1.0, 0.0, "", is_stated=False)


def _geographic(keys: GeoKeys, notes: list[str]) -> _Horizontal:
    datum = _datum(keys, None, notes)
    return _Horizontal(
        Geographic(), datum.ellipsoid, _degrees(keys), _prime_meridian(keys, notes), datum.name
    )


def _projected(keys: GeoKeys, notes: list[str]) -> _Horizontal:
    code = keys.code(Key.ProjectedCRS)
    known = projection_of_code(code)
    unit, metres = _linear_unit(keys, Key.ProjLinearUnits, Key.ProjLinearUnitSize)
    if not unit:
        metres = 1.0
        if known is None:
            notes.append("The file does not state the unit of its map: metres are assumed.")
    if known is not None:
        datum = GEODETIC[known.geodetic]
        _note_unknown(known.projection, known.name, notes)
        return _Horizontal(known.projection, datum.ellipsoid, metres, 0.0, known.name)
    datum = _datum(keys, None if code in {UNDEFINED, USER_DEFINED} else code, notes)
    projection, kind = projection_of_keys(keys, _degrees(keys), metres)
    # Most files with a code that is not known here define what it means by no other keys.
    _note_unknown(projection, kind or f"EPSG:{code}", notes)
    if _prime_meridian(keys, notes) != 0.0 and not isinstance(projection, Unknown):
        notes.append(
            "Longitudes of this map are counted from another prime meridian than Greenwich; "
            "they are not told."
        )
        projection = Unknown()
    name = _name(keys, Key.ProjectedCitation, Key.GTCitation) or kind
    return _Horizontal(projection, datum.ellipsoid, metres, 0.0, name)


def _note_unknown(projection: Projection, name: str, notes: list[str]) -> None:
    if isinstance(projection, Unknown):
        notes.append(
            f"The projection ({name}) is not known here: its metres are right, "
            "longitudes and latitudes are not told."
        )


def _datum(keys: GeoKeys, projected: int | None, notes: list[str]) -> Datum:
    """Find name and ellipsoid: stated axes first, then the codes of system, datum and ellipsoid."""
    name = _name(keys, Key.GeodeticCitation, Key.GTCitation)
    stated = _stated_ellipsoid(keys)
    code = keys.code(Key.GeodeticCRS)
    known = GEODETIC.get(code) or DATUMS.get(keys.code(Key.GeodeticDatum))
    if stated is not None:
        return Datum(name or (known.name if known else ""), stated)
    if known is not None:
        return known
    ellipsoid = ELLIPSOIDS.get(keys.code(Key.Ellipsoid))
    if ellipsoid is not None:
        return Datum(name, ellipsoid)
    missing = code if code not in {UNDEFINED, USER_DEFINED} else projected
    what = "The datum" if missing is None else f"The datum (EPSG:{missing})"
    notes.append(f"{what} is not known here: the ellipsoid of WGS 84 is assumed.")
    return Datum(name or ("" if missing is None else f"EPSG:{missing}"), WGS_84)


def _name(keys: GeoKeys, *places: Key) -> str:
    """Give the first name that is one; GDAL writes ``GCS Name = Mars 2000|Datum = ...`` and ``unknown``."""
    for key in places:
        name = keys.text(key).split("|")[0].removeprefix("GCS Name = ").strip()
        if name.lower() not in {"", "unknown", "unnamed"}:
            return name
    return ""


def _stated_ellipsoid(keys: GeoKeys) -> Ellipsoid | None:
    semi_major = keys.number(Key.EllipsoidSemiMajorAxis)
    if semi_major is None:
        return None
    semi_minor = keys.number(Key.EllipsoidSemiMinorAxis)
    inverse = keys.number(Key.EllipsoidInvFlattening)
    if semi_minor is None:
        if inverse is not None and inverse != 0.0 and not inverse > 1.0:
            raise keys.tags.wrong(Key.EllipsoidInvFlattening.name, inverse, "0 or a number above 1")
        ellipsoid = Ellipsoid.flattened(semi_major, inverse or 0.0)
    else:
        ellipsoid = Ellipsoid(semi_major, semi_minor)
    if not 0.0 < ellipsoid.semi_minor <= ellipsoid.semi_major <= LARGEST_BODY:
        raise keys.tags.wrong(
            Key.EllipsoidSemiMajorAxis.name,
            f"axes of {ellipsoid.semi_major:g} and {ellipsoid.semi_minor:g} m",
            f"axes above 0 and up to {LARGEST_BODY:g} m, the polar one not the longer",
        )
    return ellipsoid


def _named(citation: str) -> str:
    """The body by its name alone, for keys that state no size."""
    shape = body_in(citation)
    return "" if shape is None else shape.body


def _degrees(keys: GeoKeys) -> float:
    """Degrees in the unit of angles."""
    code = keys.code(Key.GeogAngularUnits)
    if code == USER_DEFINED:
        radians = keys.number(Key.GeogAngularUnitSize)
        if radians is None or radians <= 0.0:
            raise keys.tags.wrong(Key.GeogAngularUnitSize.name, radians, "radians above 0")
        return math.degrees(radians)
    if code != UNDEFINED and code not in ANGULAR_UNITS:
        raise keys.tags.wrong(Key.GeogAngularUnits.name, code, ", ".join(map(str, ANGULAR_UNITS)) + " (EPSG)")
    return ANGULAR_UNITS.get(code, 1.0)


def _linear_unit(keys: GeoKeys, unit: Key, size: Key | None) -> tuple[str, float]:
    """Name and metres of a unit; no name where the file states none."""
    code = keys.code(unit)
    if code == UNDEFINED:
        return "", 1.0
    if code == USER_DEFINED and size is not None:
        metres = keys.number(size)
        if metres is None or metres <= 0.0:
            raise keys.tags.wrong(size.name, metres, "metres above 0")
        return f"{metres:g} m", metres
    if code not in LINEAR_UNITS:
        raise keys.tags.wrong(unit.name, code, ", ".join(map(str, LINEAR_UNITS)) + " (EPSG)")
    return LINEAR_UNITS[code]


def _prime_meridian(keys: GeoKeys, notes: list[str]) -> float:
    """Degrees east of Greenwich from which longitudes are counted."""
    stated = keys.number(Key.PrimeMeridianLongitude)
    if stated is not None:
        return stated * _degrees(keys)
    code = keys.code(Key.PrimeMeridian)
    if code in {UNDEFINED, USER_DEFINED} or code in PRIME_MERIDIANS:
        return PRIME_MERIDIANS.get(code, 0.0)
    notes.append(f"The prime meridian (EPSG:{code}) is not known here: Greenwich is assumed.")
    return 0.0


def _vertical(keys: GeoKeys, notes: list[str]) -> tuple[str, str, float]:
    """Name of what elevation 0 means; name and metres of the unit of heights."""
    code, datum = keys.code(Key.Vertical), keys.code(Key.VerticalDatum)
    known = VERTICAL.get(code) or VERTICAL_DATUMS.get(datum)
    stated = next((number for number in (code, datum) if number not in {UNDEFINED, USER_DEFINED}), None)
    if known is None and keys.code(Key.GeodeticCRS) == 4979:
        known = VERTICAL[4979]
    if known is None:
        named = keys.text(Key.VerticalCitation) or ("not stated" if stated is None else f"EPSG:{stated}")
        known = Heights(named)
    unit, metres = _linear_unit(keys, Key.VerticalUnits, None)
    if not unit:
        unit, metres = LINEAR_UNITS[known.unit]
    return known.name, unit, metres
