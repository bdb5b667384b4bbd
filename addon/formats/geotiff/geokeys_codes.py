"""Codes of the EPSG Geodetic Parameter Dataset that elevation files use, and what they mean.

A few families only: a code that is not here is named to the person, never guessed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..body.ellipsoid import Ellipsoid

WGS_84 = Ellipsoid.flattened(6_378_137.0, 298.257223563)
GRS_80 = Ellipsoid.flattened(6_378_137.0, 298.257222101)
CLARKE_1866 = Ellipsoid(6_378_206.4, 6_356_583.8)

ELLIPSOIDS = {
    7001: Ellipsoid.flattened(6_377_563.396, 299.3249646),  # Airy 1830
    7004: Ellipsoid.flattened(6_377_397.155, 299.1528128),  # Bessel 1841
    7008: CLARKE_1866,
    7019: GRS_80,
    7022: Ellipsoid.flattened(6_378_388.0, 297.0),  # International 1924
    7024: Ellipsoid.flattened(6_378_245.0, 298.3),  # Krassowsky 1940
    7030: WGS_84,
    7043: Ellipsoid.flattened(6_378_135.0, 298.26),  # WGS 72
    7048: Ellipsoid.sphere(6_371_007.0),  # GRS 1980 authalic sphere
}


@dataclass(frozen=True)
class Frame:
    """A datum: its name and its ellipsoid."""

    name: str
    ellipsoid: Ellipsoid


_WGS_84 = Frame("WGS 84", WGS_84)
_NAD83 = Frame("NAD83", GRS_80)
_NAD27 = Frame("NAD27", CLARKE_1866)
_ETRS89 = Frame("ETRS89", GRS_80)
_WGS_72 = Frame("WGS 72", ELLIPSOIDS[7043])
_GDA94 = Frame("GDA94", GRS_80)
_GDA2020 = Frame("GDA2020", GRS_80)
_ED50 = Frame("ED50", ELLIPSOIDS[7022])
_OSGB36 = Frame("OSGB36", ELLIPSOIDS[7001])

GEODETIC = {
    4326: _WGS_84,
    4979: _WGS_84,
    4269: _NAD83,
    4267: _NAD27,
    4258: _ETRS89,
    4322: _WGS_72,
    4283: _GDA94,
    7844: _GDA2020,
    6318: Frame("NAD83(2011)", GRS_80),
    4230: _ED50,
    4277: _OSGB36,
    4171: Frame("RGF93", GRS_80),
    4167: Frame("NZGD2000", GRS_80),
}
"""Geodetic coordinate reference systems."""

DATUMS = {6326: _WGS_84, 6269: _NAD83, 6267: _NAD27, 6258: _ETRS89, 6322: _WGS_72, 6283: _GDA94}

LINEAR_UNITS = {
    9001: ("m", 1.0),
    9002: ("ft", 0.3048),
    9003: ("US survey foot", 1200.0 / 3937.0),
    9014: ("fathom", 1.8288),
    9030: ("nautical mile", 1852.0),
    9035: ("US survey mile", 5280.0 * 1200.0 / 3937.0),
    9036: ("km", 1000.0),
    9093: ("mile", 1609.344),
    9096: ("yard", 0.9144),
}
"""Name, and metres."""

ANGULAR_UNITS = {
    9101: math.degrees(1.0),  # radian
    9102: 1.0,
    9103: 1.0 / 60.0,  # arc-minute
    9104: 1.0 / 3600.0,  # arc-second
    9105: 0.9,  # grad
    9106: 0.9,  # gon
    9122: 1.0,  # degree, as the supplier has it
}
"""Degrees."""

PRIME_MERIDIANS = {
    8901: 0.0,  # Greenwich
    8903: 2.0 + 20.0 / 60.0 + 14.025 / 3600.0,  # Paris
    8906: 12.0 + 27.0 / 60.0 + 8.4 / 3600.0,  # Rome
    8909: -(17.0 + 40.0 / 60.0),  # Ferro
    8913: 10.0 + 43.0 / 60.0 + 22.5 / 3600.0,  # Oslo
}
"""Degrees east of Greenwich."""


@dataclass(frozen=True)
class Heights:
    """A vertical reference: its name, and the unit that it implies, a key of ``LINEAR_UNITS``."""

    name: str
    unit: int = 9001


VERTICAL = {
    3855: Heights("EGM2008 geoid"),
    4979: Heights("WGS 84 ellipsoid"),
    5030: Heights("WGS 84 ellipsoid"),  # of GeoTIFF 1.0
    5103: Heights("NAVD88"),  # of GeoTIFF 1.0
    5102: Heights("NGVD29"),  # of GeoTIFF 1.0
    5701: Heights("Ordnance Datum Newlyn"),
    5702: Heights("NGVD29", 9003),
    5703: Heights("NAVD88"),
    5714: Heights("mean sea level"),
    5773: Heights("EGM96 geoid"),
    5798: Heights("EGM84 geoid"),
    6360: Heights("NAVD88", 9003),
    8228: Heights("NAVD88", 9002),
}
"""Vertical coordinate reference systems."""

VERTICAL_DATUMS = {
    1027: Heights("EGM2008 geoid"),
    5100: Heights("mean sea level"),
    5101: Heights("Ordnance Datum Newlyn"),
    5102: Heights("NGVD29"),
    5103: Heights("NAVD88"),
    5171: Heights("EGM96 geoid"),
}
