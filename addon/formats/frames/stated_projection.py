"""A projection that a file states by name and parameters; the only place that asks which are known."""

from __future__ import annotations

from typing import Any

from ..projections import KINDS, Projection, Unknown


def stated_projection(name: str, **parameters: float) -> Projection:
    """The projection of this name in ``KINDS``; ``Unknown`` where there is none: touch is right anyway."""
    kind: Any = KINDS.get(name)
    if kind is None:
        return Unknown()
    made: Projection = kind(**parameters)
    return made


def utm(zone: int, *, north: bool) -> Projection:
    """A zone of Universal Transverse Mercator, 1 to 60; ``Unknown`` where there is no such zone.

    Source: Snyder, "Map Projections: A Working Manual" (1987), pages 57 and 58.
    """
    if not 1 <= zone <= 60:
        return Unknown()
    return stated_projection(
        "transverse Mercator",
        central_longitude=6.0 * zone - 183.0,
        latitude_of_origin=0.0,
        scale_factor=0.9996,
        false_easting=500_000.0,
        false_northing=0.0 if north else 10_000_000.0,
    )
