"""Known shapes by the names that headers have for them: bodies, and the ellipsoids of Earth's datums.

IAU: B. A. Archinal et al., "Report of the IAU Working Group on Cartographic Coordinates and Rotational
Elements: 2015", Celestial Mechanics and Dynamical Astronomy 130:22 (2018), tables 4 to 6; bodies that
are not nearly ellipsoids of revolution are given as the sphere of their mean radius.
DMA: "Department of Defense World Geodetic System 1984", DMA TR 8350.2, and its list of reference ellipsoids.
Snyder: "Map Projections: A Working Manual" (USGS Professional Paper 1395, 1987), table 1.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from .ellipsoid import Ellipsoid

IAU = "IAU 2015"
DMA = "DMA TR 8350.2"
SNYDER = "USGS Professional Paper 1395, table 1"

_WORD = re.compile(r"[a-z]+")


@dataclass(frozen=True)
class KnownShape:
    """An ellipsoid that has a name."""

    name: str
    ellipsoid: Ellipsoid
    source: str
    body: str
    other_names: tuple[str, ...] = ()
    """How files write it too; case, spaces and marks between words do not matter."""


def body_in(text: str) -> KnownShape | None:
    """The shape of the first body of which a text speaks by a word of its own; ``None``: of none."""
    words = _WORD.findall(text.casefold())
    return next((_BODIES[word] for word in words if word in _BODIES), None)


def body_told(text: str, ellipsoid: Ellipsoid) -> str:
    """The name of the body of which a text speaks, else of one of this size; empty where nobody can tell."""
    shape = body_in(text)
    if shape is not None:
        return shape.body
    words = _WORD.findall(text.casefold())
    irregular = next((name for name in IRREGULAR if name.casefold() in words), None)
    return irregular or body_of(ellipsoid)


def ellipsoid_named(name: str) -> KnownShape | None:
    """The ellipsoid of that name or of the datum of that name; ``None`` where it is not known here."""
    return _ELLIPSOIDS.get(_plain(name))


def body_of(ellipsoid: Ellipsoid) -> str:
    """Which body is as large, within 1% of its radius; empty where none is, or several are."""
    near = {
        shape.body
        for shape in (*BODIES, *ELLIPSOIDS)
        if abs(ellipsoid.semi_major - shape.ellipsoid.semi_major) < 0.01 * shape.ellipsoid.semi_major
    }
    return near.pop() if len(near) == 1 else ""


def _body(name: str, semi_major: float, semi_minor: float | None = None) -> KnownShape:
    return KnownShape(name, Ellipsoid(semi_major, semi_minor or semi_major), IAU, name)


def _earth(name: str, ellipsoid: Ellipsoid, source: str, *other_names: str) -> KnownShape:
    return KnownShape(name, ellipsoid, source, "Earth", other_names)


BODIES = (
    _body("Mercury", 2440530.0, 2438260.0),
    _body("Venus", 6051800.0),
    # Grids of Earth speak of WGS84, and the IAU's ellipsoid is 0.4 m smaller.
    KnownShape("Earth", Ellipsoid.flattened(6378137.0, 298.257223563), DMA, "Earth"),
    KnownShape("Moon", Ellipsoid.sphere(1737400.0), IAU, "Moon", ("Luna", "Lunar")),
    _body("Mars", 3396190.0, 3376200.0),
    _body("Phobos", 11080.0),
    _body("Deimos", 6200.0),
    _body("Ceres", 487300.0, 446000.0),
    _body("Jupiter", 71492000.0, 66854000.0),
    _body("Io", 1821490.0),
    _body("Europa", 1560800.0),
    _body("Ganymede", 2631200.0),
    _body("Callisto", 2410300.0),
    _body("Saturn", 60268000.0, 54364000.0),
    _body("Mimas", 198200.0),
    _body("Enceladus", 252100.0),
    _body("Tethys", 531000.0),
    _body("Dione", 561400.0),
    _body("Rhea", 763500.0),
    _body("Titan", 2575000.0),
    _body("Iapetus", 745700.0, 712100.0),
    _body("Uranus", 25559000.0, 24973000.0),
    _body("Neptune", 24764000.0, 24341000.0),
    _body("Triton", 1352600.0),
    _body("Pluto", 1188300.0),
    _body("Charon", 606000.0),
)
"""Planets, moons and dwarf planets that have been mapped."""

IRREGULAR = ("Vesta", "Eros")
"""Mapped too, but no ellipsoids: a map states the shape that it is drawn on."""

ELLIPSOIDS = (
    _earth(
        "WGS 84", Ellipsoid.flattened(6378137.0, 298.257223563), DMA, "WGS 1984", "World Geodetic System 1984"
    ),
    _earth(
        "WGS 72", Ellipsoid.flattened(6378135.0, 298.26), SNYDER, "WGS 1972", "World Geodetic System 1972"
    ),
    _earth("WGS 66", Ellipsoid.flattened(6378145.0, 298.25), SNYDER),
    _earth("WGS 60", Ellipsoid.flattened(6378165.0, 298.3), DMA),
    _earth(
        "GRS 80",
        Ellipsoid.flattened(6378137.0, 298.257222101),
        SNYDER,
        *("GRS 1980", "NAD 83", "NAD 1983", "North American Datum 1983", "North American 1983"),
        *("ETRS 89", "ETRS 1989", "GDA 94", "GDA 2020"),
    ),
    _earth("GRS 67", Ellipsoid.flattened(6378160.0, 298.247167427), SNYDER, "GRS 1967"),
    _earth(
        "Clarke 1866",
        Ellipsoid(6378206.4, 6356583.8),
        SNYDER,
        *("NAD 27", "NAD 1927", "North American Datum 1927", "North American 1927"),
        *("Old Hawaiian", "Puerto Rico"),  # as USGS elevation models name their datums
    ),
    _earth("Clarke 1880", Ellipsoid.flattened(6378249.145, 293.465), SNYDER, "Clarke 1880 RGS"),
    _earth(
        "International 1924",
        Ellipsoid.flattened(6378388.0, 297.0),
        SNYDER,
        *("International", "Hayford", "Hayford 1909", "ED 50", "European Datum 1950", "European 1950"),
    ),
    _earth("Bessel 1841", Ellipsoid.flattened(6377397.155, 299.1528128), SNYDER, "Bessel", "DHDN", "CH 1903"),
    _earth(
        "Airy 1830",
        Ellipsoid(6377563.396, 6356256.909),
        SNYDER,
        *("Airy", "OSGB 1936", "OSGB 36", "Ordnance Survey of Great Britain 1936"),
    ),
    _earth("Modified Airy", Ellipsoid(6377340.189, 6356034.446), SNYDER, "Airy Modified 1849", "TM 65"),
    _earth("Everest 1830", Ellipsoid.flattened(6377276.345, 300.8017), SNYDER, "Everest"),
    _earth("Krassovsky 1940", Ellipsoid.flattened(6378245.0, 298.3), SNYDER, "Krassovsky", "Pulkovo 1942"),
    _earth(
        "Australian National", Ellipsoid.flattened(6378160.0, 298.25), SNYDER, "Australian National Spheroid"
    ),
    _earth("Helmert 1906", Ellipsoid.flattened(6378200.0, 298.3), DMA, "Helmert"),
    _earth("Authalic sphere", Ellipsoid.sphere(6370997.0), SNYDER, "Sphere of radius 6370997 m"),
    KnownShape("Mars 2000", Ellipsoid(3396190.0, 3376200.0), IAU, "Mars", ("Mars IAU 2015",)),
    KnownShape(
        "MOLA sphere",
        Ellipsoid.sphere(3396000.0),
        "MGS MOLA MEGDR software interface specification",
        "Mars",
    ),
    KnownShape("Moon 2000", Ellipsoid.sphere(1737400.0), IAU, "Moon", ("Moon IAU 2015",)),
)
"""Ellipsoids of reference."""


def _plain(name: str) -> str:
    """Letters and digits only: ``D_WGS_1984`` (Esri's for a datum), ``WGS 1984`` and ``wgs1984`` are one."""
    words = name.strip().casefold().removeprefix("d_")
    return "".join(letter for letter in words if letter.isalnum())


def _by_name(shapes: tuple[KnownShape, ...]) -> dict[str, KnownShape]:
    """Every name of every shape."""
    return {_plain(name): shape for shape in shapes for name in (shape.name, *shape.other_names)}


_BODIES = _by_name(BODIES)
_ELLIPSOIDS = _by_name(ELLIPSOIDS)
