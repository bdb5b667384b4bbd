"""Polar stereographic maps as labels state them."""

from __future__ import annotations

from .projections import PolarStereographic


def polar_stereographic(
    pole: float, central_longitude: float, true_scale_latitude: float | None = None
) -> PolarStereographic:
    """The projection around a pole (90 or -90).

    Args:
        central_longitude: degrees east; down from the north pole, up from the south pole.
        true_scale_latitude: where the map is true to scale; ``None`` at the pole.
    """
    return PolarStereographic(
        latitude_of_origin=pole,
        central_longitude=central_longitude,
        standard_parallel_1=90.0
        if true_scale_latitude in {None, 0.0}
        else float(true_scale_latitude or 90.0),
    )
