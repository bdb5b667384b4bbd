"""The projection of a projected system in well-known text: its method and parameters by their many names.

Source: OGC 01-009, "Coordinate Transformation Services" (2001), section 7; and for methods and parameters,
what PROJ writes as its formats WKT1_GDAL and WKT1_ESRI. Case and underlines do not matter.

A method that is not here, a parameter that it should have and has not, or one that it should not have:
``Unknown``, for touch is right all the same and no place is told wrong.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from ..body.ellipsoid import Ellipsoid
from ..projections import Projection, Unknown
from .stated_projection import stated_projection
from .wkt import WktNode

CENTRAL, ORIGIN, SCALE = "central_longitude", "latitude_of_origin", "scale_factor"
PARALLEL_1, PARALLEL_2 = "standard_parallel_1", "standard_parallel_2"
EASTING, NORTHING = "false_easting", "false_northing"
SPHERE_TYPE = "auxiliary sphere type"

PARAMETERS = {
    "centralmeridian": CENTRAL,
    "longitudeofcenter": CENTRAL,
    "longitudeoforigin": CENTRAL,
    "latitudeoforigin": ORIGIN,
    "latitudeofcenter": ORIGIN,
    "standardparallel1": PARALLEL_1,
    "standardparallel2": PARALLEL_2,
    "scalefactor": SCALE,
    "falseeasting": EASTING,
    "falsenorthing": NORTHING,
    "auxiliaryspheretype": SPHERE_TYPE,
}
"""What the parameters of the texts are called here."""

ANGLES = {CENTRAL, ORIGIN, PARALLEL_1, PARALLEL_2}
LENGTHS = {EASTING, NORTHING}

POLAR, WEB_MERCATOR = "polar stereographic", "web Mercator"


@dataclass(frozen=True)
class Method:
    """A method of projection."""

    kind: str
    """In ``KINDS``."""
    needed: tuple[str, ...]
    """Parameters without which places would be guessed; a false origin that is not stated is none."""
    implied: Mapping[str, float | str] = field(default_factory=dict)
    """Parameters that the method's name means where they are not stated: values, or as which other one."""


_TRANSVERSE = Method("transverse Mercator", (CENTRAL, ORIGIN, SCALE))
_MERCATOR_OF_PARALLEL = Method("Mercator", (CENTRAL, PARALLEL_1))
_ALBERS = Method("Albers equal area", (CENTRAL, ORIGIN, PARALLEL_1, PARALLEL_2))
_EQUIRECTANGULAR = Method("equirectangular", (CENTRAL, PARALLEL_1))
_CONE = "Lambert conformal conic"

METHODS = {
    "transversemercator": _TRANSVERSE,
    "gausskruger": _TRANSVERSE,
    "mercator1sp": Method("Mercator", (CENTRAL, SCALE)),
    "mercator2sp": _MERCATOR_OF_PARALLEL,
    "mercator": _MERCATOR_OF_PARALLEL,
    "mercatorauxiliarysphere": Method(WEB_MERCATOR, (CENTRAL, SPHERE_TYPE)),
    "lambertconformalconic1sp": Method(
        _CONE, (CENTRAL, ORIGIN, SCALE), {PARALLEL_1: ORIGIN, PARALLEL_2: ORIGIN}
    ),
    "lambertconformalconic2sp": Method(_CONE, (CENTRAL, ORIGIN, PARALLEL_1, PARALLEL_2)),
    "albersconicequalarea": _ALBERS,
    "albers": _ALBERS,
    "lambertazimuthalequalarea": Method("Lambert azimuthal equal area", (CENTRAL, ORIGIN)),
    "sinusoidal": Method("sinusoidal", (CENTRAL,)),
    "equirectangular": _EQUIRECTANGULAR,
    "equidistantcylindrical": _EQUIRECTANGULAR,
    "platecarree": Method("equirectangular", (CENTRAL,), {PARALLEL_1: 0.0}),
    "polarstereographic": Method(POLAR, (CENTRAL, PARALLEL_1), {PARALLEL_1: ORIGIN}),
    "stereographicnorthpole": Method(POLAR, (CENTRAL, PARALLEL_1), {PARALLEL_1: ORIGIN}),
    "stereographicsouthpole": Method(POLAR, (CENTRAL, PARALLEL_1), {PARALLEL_1: ORIGIN}),
}

_CONE_OF_TWO = METHODS["lambertconformalconic2sp"]
_CONE_OF_ONE = Method(_CONE, (CENTRAL, ORIGIN, PARALLEL_1, SCALE), {PARALLEL_2: PARALLEL_1})
"""Esri has one name for both."""


def projection_of_wkt(
    node: WktNode, ellipsoid: Ellipsoid, degrees: float, metres: float, shift_x: float
) -> Projection:
    """Make the projection that a PROJCS states.

    Args:
        degrees: in the unit of its angles. metres: in the unit of its lengths.
        shift_x: degrees that longitudes are counted from east of Greenwich.
    """
    stated = node.child("PROJECTION")
    name = "" if stated is None else plain(stated.text())
    given = _parameters(node, degrees, metres)
    if given is None:
        return Unknown()
    method = _method(name, given)
    if method is None or any(parameter not in given for parameter in method.needed):
        return Unknown()
    given[CENTRAL] += shift_x
    if method.kind == POLAR:
        _about_a_pole(name, given)
    if method.kind == WEB_MERCATOR or (method.kind == "Mercator" and _is_of_the_web(node)):
        return _web_mercator(given, ellipsoid, node)
    return stated_projection(method.kind, given)


def _method(name: str, given: dict[str, float]) -> Method | None:
    """The method of a name; adds to ``given`` what it implies."""
    method = METHODS.get(name)
    if name == "lambertconformalconic":
        method = _CONE_OF_TWO if PARALLEL_2 in given else _CONE_OF_ONE
    if method is None:
        return None
    if method is _EQUIRECTANGULAR and given.get(ORIGIN) == 0.0:
        # Older definitions call the standard parallel so; at the equator either meaning is the same.
        given.setdefault(PARALLEL_1, 0.0)
    for parameter, value in method.implied.items():
        implied = given.get(value) if isinstance(value, str) else value
        if implied is not None:
            given.setdefault(parameter, implied)
    return method


def plain(name: str) -> str:
    """A name as every program writes it, without underlines and in small letters."""
    return name.replace("_", "").replace(" ", "").lower()


def _parameters(node: WktNode, degrees: float, metres: float) -> dict[str, float] | None:
    """Parameters in degrees and metres; ``None`` where one is not known, no number, or stated twice."""
    found: dict[str, float] = {}
    for parameter in node.children("PARAMETER"):
        name, value = PARAMETERS.get(plain(parameter.text())), parameter.number(1)
        if name is None or value is None or not math.isfinite(value):
            return None
        value *= degrees if name in ANGLES else metres if name in LENGTHS else 1.0
        if found.setdefault(name, value) != value:
            return None
    return found


def _about_a_pole(method: str, given: dict[str, float]) -> None:
    """Tell the pole by the method's name, else by the side of the latitude of true scale."""
    is_south = method == "stereographicsouthpole" or (
        method == "polarstereographic" and given[PARALLEL_1] < 0.0
    )
    given[ORIGIN] = -90.0 if is_south else 90.0


def _is_of_the_web(node: WktNode) -> bool:
    """Whether a Mercator is web Mercator, for which this text has no method: by extension, code or name."""
    authority = node.child("AUTHORITY")
    code = "" if authority is None else "".join(str(part) for part in authority.arguments[1:2])
    code = code.removesuffix(".0")
    return (
        _spherical(node) is not None
        or code in {"3857", "3785", "900913"}
        or any(name in plain(node.text()) for name in ("pseudo-mercator", "webmercator", "googlemercator"))
    )


def _web_mercator(given: dict[str, float], ellipsoid: Ellipsoid, node: WktNode) -> Projection:
    radius = _spherical(node)
    # Of the types of sphere, 0 has the semi-major axis for radius, and the ellipsoid's own latitudes.
    is_that = given.pop(SPHERE_TYPE, 0.0) == 0.0 and radius in {None, ellipsoid.semi_major}
    if not is_that or given.pop(PARALLEL_1, 0.0) != 0.0:
        return Unknown()
    return stated_projection(WEB_MERCATOR, given)


def _spherical(node: WktNode) -> float | None:
    """The radius of the sphere that a PROJ extension draws on, beside the text's own ellipsoid."""
    for extension in node.children("EXTENSION"):
        told = next((text for text in extension.arguments[1:2] if isinstance(text, str)), "")
        words = dict(word.partition("=")[::2] for word in told.split())
        if words.get("+proj") == "merc" and "+a" in words and words["+a"] == words.get("+b"):
            try:
                return float(words["+a"])
            except ValueError:
                return math.nan
    return None
