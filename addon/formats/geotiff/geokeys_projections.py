"""From the projection keys of a GeoTIFF file to a projection.

The one place that knows both the keys (OGC 19-008r4; the codes of projection methods: GeoTIFF 1.0, 6.3.3.3)
and the names and fields of ``projections``. A projection that is not there, or that lacks a parameter of the
file, is ``Unknown``: touch is right all the same, and no place is told wrong.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..frames.stated_projection import stated_projection
from ..projections import Projection, Unknown
from .geokeys import GeoKeys, Key

LONGITUDE = (
    Key.ProjNatOriginLong,
    Key.ProjCenterLong,
    Key.ProjFalseOriginLong,
    Key.ProjStraightVertPoleLong,
)
LATITUDE = (Key.ProjNatOriginLat, Key.ProjCenterLat, Key.ProjFalseOriginLat)
ANGLES = {
    "central_longitude": LONGITUDE,
    "latitude_of_origin": LATITUDE,
    "standard_parallel_1": (Key.ProjStdParallel1,),
    "standard_parallel_2": (Key.ProjStdParallel2,),
}
LENGTHS = {
    "false_easting": (Key.ProjFalseEasting, Key.ProjFalseOriginEasting, Key.ProjCenterEasting),
    "false_northing": (Key.ProjFalseNorthing, Key.ProjFalseOriginNorthing, Key.ProjCenterNorthing),
}
NUMBERS = {"scale_factor": (Key.ProjScaleAtNatOrigin, Key.ProjScaleAtCenter)}
"""Which keys may hold a parameter, the usual one first: writers differ."""

POLAR_STEREOGRAPHIC, STEREOGRAPHIC = "polar stereographic", "oblique stereographic"
CONFORMAL_CONIC, EQUAL_AREA_CONIC = "Lambert conformal conic", "Albers equal area"
EQUAL_AREA_AZIMUTHAL = "Lambert azimuthal equal area"

ONE_PARALLEL = 9
"""Code of the conformal conic whose standard parallel is its latitude of origin."""

NEEDED = {
    POLAR_STEREOGRAPHIC: ("latitude_of_origin",),
    STEREOGRAPHIC: ("latitude_of_origin",),
    CONFORMAL_CONIC: ("standard_parallel_1",),
    EQUAL_AREA_CONIC: ("standard_parallel_1", "standard_parallel_2"),
    EQUAL_AREA_AZIMUTHAL: ("latitude_of_origin",),
}
"""Parameters without which places would be guessed."""

METHODS = {
    1: "transverse Mercator",
    7: "Mercator",
    8: CONFORMAL_CONIC,
    ONE_PARALLEL: CONFORMAL_CONIC,
    10: EQUAL_AREA_AZIMUTHAL,
    11: EQUAL_AREA_CONIC,
    12: "azimuthal equidistant",
    13: "equidistant conic",
    14: STEREOGRAPHIC,
    15: POLAR_STEREOGRAPHIC,
    16: "double stereographic",
    17: "equirectangular",
    18: "Cassini-Soldner",
    19: "gnomonic",
    20: "Miller cylindrical",
    21: "orthographic",
    22: "polyconic",
    23: "Robinson",
    24: "sinusoidal",
    25: "Van der Grinten",
    28: "cylindrical equal-area",
}
"""Names of projections, some of which are in ``KINDS``, by the code of ProjMethod."""


@dataclass(frozen=True)
class ProjectedCode:
    """What the code of a projected coordinate reference system means."""

    name: str
    geodetic: int
    """Code of the geodetic system below it."""
    projection: Projection


def projection_of_keys(keys: GeoKeys, degrees: float, metres: float) -> tuple[Projection, str]:
    """Make the projection that the keys define, and tell its name; no name where there is none at all.

    Args:
        degrees: in the unit of the keys' angles. metres: in the unit of their lengths.
    """
    code = keys.code(Key.ProjMethod)
    kind = METHODS.get(code, f"projection method {code}" if code else "")
    if not kind:
        return Unknown(), ""
    parameters: dict[str, float] = {}
    for names, unit in ((ANGLES, degrees), (LENGTHS, metres), (NUMBERS, 1.0)):
        for name, places in names.items():
            number = keys.number(*places)
            if number is not None:
                parameters[name] = number * unit
    if kind in {POLAR_STEREOGRAPHIC, STEREOGRAPHIC}:
        kind = _about_a_pole(kind, parameters)
    if kind == CONFORMAL_CONIC:
        _with_two_parallels(code, parameters)
    if any(name not in parameters for name in NEEDED.get(kind, ())):
        return Unknown(), kind
    return stated_projection(kind, parameters), kind


def _about_a_pole(kind: str, parameters: dict[str, float]) -> str:
    """Tell the pole from the latitude of true scale: writers have one key for either."""
    latitude = parameters.get("latitude_of_origin")
    if latitude is None or (kind == STEREOGRAPHIC and abs(latitude) != 90.0):
        return kind
    if abs(latitude) != 90.0:
        parameters.setdefault("standard_parallel_1", latitude)
    parameters["latitude_of_origin"] = math.copysign(90.0, latitude)
    return POLAR_STEREOGRAPHIC


def _with_two_parallels(code: int, parameters: dict[str, float]) -> None:
    """Name both standard parallels of a conformal cone, where there is one only too."""
    if code == ONE_PARALLEL and "latitude_of_origin" in parameters:
        parameters["standard_parallel_1"] = parameters["latitude_of_origin"]
    if "standard_parallel_1" in parameters:
        parameters.setdefault("standard_parallel_2", parameters["standard_parallel_1"])


def projection_of_code(code: int) -> ProjectedCode | None:
    """Look up the code of a projected coordinate reference system; ``None`` where it is not known here."""
    return _utm(code) or _CODES.get(code)


def _utm(code: int) -> ProjectedCode | None:
    """Zones of UTM, whose codes follow one another."""
    for name, geodetic, before, zones, is_north in _UTM:
        zone = code - before
        if zone in zones:
            side = "N" if is_north else "S"
            projection = _transverse(0.0, 6.0 * zone - 183.0, 0.9996, 500_000.0, 0.0 if is_north else 1e7)
            return ProjectedCode(f"{name} / UTM zone {zone}{side}", geodetic, projection)
    return None


_UTM = (
    ("WGS 84", 4326, 32600, range(1, 61), True),
    ("WGS 84", 4326, 32700, range(1, 61), False),
    ("NAD83", 4269, 26900, range(1, 24), True),
    ("NAD83(2011)", 6318, 6329, range(1, 20), True),
    ("NAD27", 4267, 26700, range(1, 23), True),
    ("ETRS89", 4258, 25800, range(28, 39), True),
    ("ED50", 4230, 23000, range(28, 39), True),
    ("GDA94 / MGA", 4283, 28300, range(48, 59), False),
    ("GDA2020 / MGA", 7844, 7800, range(46, 60), False),
)
"""Datum, its code, the code before zone 1, zones, and whether they are of the north."""


def _transverse(
    latitude: float, longitude: float, scale: float, easting: float, northing: float
) -> Projection:
    parameters = {
        "latitude_of_origin": latitude,
        "central_longitude": longitude,
        "scale_factor": scale,
        "false_easting": easting,
        "false_northing": northing,
    }
    return stated_projection("transverse Mercator", parameters)


def _polar(latitude: float, longitude: float) -> Projection:
    parameters = {
        "latitude_of_origin": math.copysign(90.0, latitude),
        "standard_parallel_1": latitude,
        "central_longitude": longitude,
    }
    return stated_projection(POLAR_STEREOGRAPHIC, parameters)


_CODES = {
    27700: ProjectedCode(
        "OSGB36 / British National Grid", 4277, _transverse(49.0, -2.0, 0.9996012717, 400_000.0, -100_000.0)
    ),
    2193: ProjectedCode(
        "NZGD2000 / New Zealand Transverse Mercator", 4167, _transverse(0.0, 173.0, 0.9996, 1_600_000.0, 1e7)
    ),
    2154: ProjectedCode(
        "RGF93 / Lambert-93",
        4171,
        stated_projection(
            CONFORMAL_CONIC,
            {
                "standard_parallel_1": 49.0,
                "standard_parallel_2": 44.0,
                "latitude_of_origin": 46.5,
                "central_longitude": 3.0,
                "false_easting": 700_000.0,
                "false_northing": 6_600_000.0,
            },
        ),
    ),
    3031: ProjectedCode("WGS 84 / Antarctic Polar Stereographic", 4326, _polar(-71.0, 0.0)),
    3413: ProjectedCode("WGS 84 / NSIDC Sea Ice Polar Stereographic North", 4326, _polar(70.0, -45.0)),
    3995: ProjectedCode("WGS 84 / Arctic Polar Stereographic", 4326, _polar(71.0, 0.0)),
    3857: ProjectedCode("WGS 84 / Pseudo-Mercator", 4326, stated_projection("web Mercator", {})),
    3035: ProjectedCode(
        "ETRS89-extended / LAEA Europe",
        4258,
        stated_projection(
            EQUAL_AREA_AZIMUTHAL,
            {
                "latitude_of_origin": 52.0,
                "central_longitude": 10.0,
                "false_easting": 4_321_000.0,
                "false_northing": 3_210_000.0,
            },
        ),
    ),
    5070: ProjectedCode(
        "NAD83 / Conus Albers",
        4269,
        stated_projection(
            EQUAL_AREA_CONIC,
            {
                "standard_parallel_1": 29.5,
                "standard_parallel_2": 45.5,
                "latitude_of_origin": 23.0,
                "central_longitude": -96.0,
            },
        ),
    ),
}
"""Parameters: EPSG Geodetic Parameter Dataset."""
