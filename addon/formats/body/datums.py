"""Ellipsoids of the datums that elevation files name.

Source: Defense Mapping Agency, "Department of Defense World Geodetic System 1984", TR 8350.2 (1991),
appendix A and table 3.1.
"""

from __future__ import annotations

from dataclasses import dataclass

from .ellipsoid import Ellipsoid

CLARKE_1866 = Ellipsoid(6_378_206.4, 6_356_583.8)
WGS72 = Ellipsoid.flattened(6_378_135.0, 298.26)
WGS84 = Ellipsoid.flattened(6_378_137.0, 298.257223563)
GRS80 = Ellipsoid.flattened(6_378_137.0, 298.257222101)


@dataclass(frozen=True)
class Datum:
    """A horizontal datum."""

    name: str
    ellipsoid: Ellipsoid


NAD27 = Datum("NAD27", CLARKE_1866)
DATUM_WGS72 = Datum("WGS 72", WGS72)
DATUM_WGS84 = Datum("WGS 84", WGS84)
NAD83 = Datum("NAD83", GRS80)

DATUMS: dict[str, Datum] = {
    "NAD27": NAD27,
    "NAR": NAD83,
    "NAS": NAD27,
    "NAD83": NAD83,
    "WGS72": DATUM_WGS72,
    "WGS84": DATUM_WGS84,
    "CLARKE1866": NAD27,
    "GRS80": NAD83,
    "GRS1980": NAD83,
}
"""By the names of Arc/Info's ``.prj`` files, datums and spheroids, in capitals without underlines."""
