"""A projection that a file states by name and parameters; the only place that asks which are known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from ..projections import KINDS, Projection, Unknown

NEUTRAL = {
    "central_longitude": 0.0,
    "latitude_of_origin": 0.0,
    "scale_factor": 1.0,
    "false_easting": 0.0,
    "false_northing": 0.0,
}
"""Parameters that change nothing at these values: a projection need not have them."""

_KNOWN = {name.lower(): kind for name, kind in KINDS.items()}


def stated_projection(name: str, parameters: Mapping[str, float]) -> Projection:
    """The projection of this name in ``KINDS``, in any case.

    ``Unknown`` where there is none, or none with these parameters: touch is right anyway.
    """
    kind = _KNOWN.get(name.lower())
    if kind is None:
        return Unknown()
    names = {field.name for field in fields(kind)}  # type: ignore[arg-type]
    chosen: dict[str, Any] = {}
    for parameter, value in parameters.items():
        if parameter in names:
            chosen[parameter] = value
        elif value != NEUTRAL.get(parameter):
            return Unknown()
    try:
        return kind(**chosen)
    except (TypeError, ValueError):  # a parameter that the file lacks, or that no map can have
        return Unknown()


def utm(zone: int, *, north: bool) -> Projection:
    """A zone of Universal Transverse Mercator, 1 to 60; ``Unknown`` where there is no such zone.

    Source: Snyder, "Map Projections: A Working Manual" (1987), pages 57 and 58.
    """
    if not 1 <= zone <= 60:
        return Unknown()
    parameters = {
        "central_longitude": 6.0 * zone - 183.0,
        "latitude_of_origin": 0.0,
        "scale_factor": 0.9996,
        "false_easting": 500_000.0,
        "false_northing": 0.0 if north else 10_000_000.0,
    }
    return stated_projection("transverse Mercator", parameters)
