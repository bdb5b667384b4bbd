"""What the values of a PDS3 image mean: heights above what, in metres."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from .label import Label, Units

Kind = Literal["elevation", "radius", "count"]

LENGTHS: Units = {
    "METER": 1.0,
    "METERS": 1.0,
    "METRE": 1.0,
    "METRES": 1.0,
    "M": 1.0,
    "M/DN": 1.0,
    "KILOMETER": 1000.0,
    "KILOMETERS": 1000.0,
    "KM": 1000.0,
}
"""To metres, of ``UNIT`` and of units that stand beside ``SCALING_FACTOR`` and ``OFFSET``."""

KILOMETRES: Units = {"KM": 1000.0, "M": 1.0, "KILOMETERS": 1000.0, "METERS": 1.0, "KILOMETER": 1000.0}
"""To metres; PDS3 has radii in kilometres."""

SAME_RADIUS = 2e-4
"""Share of the radius: 3,396,000 m and 3,396,190 m are both Mars, 1,737,400 m is the Moon's sphere."""


@dataclass(frozen=True)
class Pds3Values:
    """Metres = sample x ``scale`` + ``offset`` above the ``reference``."""

    kind: Kind
    scale: float
    offset: float
    reference: str
    unit: str
    notes: tuple[str, ...] = ()


def pds3_values(label: Label, image: tuple[str, ...]) -> Pds3Values:
    """Read unit, factor, offset and name of an image.

    Heights are sample x SCALING_FACTOR + OFFSET (Standards Reference, A.20). Where the offset is the radius
    of the body, that makes a planetary radius. LOLA's labels say that a HEIGHT is the same without the
    offset ("HEIGHT = (DN * SCALING_FACTOR)", "PLANETARY_RADIUS = (DN * SCALING_FACTOR) + OFFSET"): it is
    the height above the sphere of that radius, and read as that.
    """
    name = label.text(*image, "NAME", default="TOPOGRAPHY").upper()
    if "COUNT" in name:
        return _counts(label, image)
    unit = label.text(*image, "UNIT", default="METER").upper()
    if unit not in LENGTHS:
        raise label.wrong("UNIT", unit, "METER or KILOMETER", "Choose a grid of elevations.")
    metres = LENGTHS[unit]
    scale = metres * label.number(*image, "SCALING_FACTOR", units=_beside(metres), default=1.0)
    offset = metres * label.number(*image, "OFFSET", units=_beside(metres), default=0.0)
    written = "m" if metres == 1.0 else "km"
    radius = label.number("IMAGE_MAP_PROJECTION", "A_AXIS_RADIUS", units=KILOMETRES, default=None)
    on_sphere = radius is not None and abs(offset - radius) <= SAME_RADIUS * radius
    if _is_radius(name):
        return Pds3Values("radius", scale, offset, "centre of the body", written)
    if on_sphere:
        note = f"Heights are above the sphere of {offset:,.0f} m: OFFSET is its radius and is left out."
        return Pds3Values("elevation", scale, 0.0, f"sphere of {offset / 1000:,.10g} km", written, (note,))
    return Pds3Values("elevation", scale, offset, _datum(label, name), written)


def _beside(metres: float) -> Units:
    """Units that may stand beside a number in ``UNIT``; without one it is meant in that."""
    written = {unit: factor / metres for unit, factor in LENGTHS.items()}
    meant = next(unit for unit, factor in LENGTHS.items() if factor == metres)
    return {meant: 1.0, **written}


def _is_radius(name: str) -> bool:
    """Shape maps and areoids count from the body's centre, as radii do."""
    return any(word in name for word in ("RADIUS", "SHAPE", "AREOID")) and "TOPOGRAPHY" not in name


def _datum(label: Label, name: str) -> str:
    mars = label.text("TARGET_NAME", default="").upper() == "MARS"
    return "areoid" if mars and "HEIGHT" not in name else "reference surface"


def _counts(label: Label, image: tuple[str, ...]) -> Pds3Values:
    """Maps of how many observations a cell has."""
    return Pds3Values(
        "count",
        label.number(*image, "SCALING_FACTOR", default=1.0),
        label.number(*image, "OFFSET", default=0.0),
        "none: numbers of observations",
        "count",
        ("These are numbers of observations, not elevations.",),
    )
