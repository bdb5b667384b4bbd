"""Projections as labels of planetary archives state them: a name, and a centre."""

from __future__ import annotations

from ..projections import (
    LambertAzimuthalEqualArea,
    Mercator,
    ObliqueStereographic,
    PolarStereographic,
    Projection,
    Sinusoidal,
    TransverseMercator,
    Unknown,
)


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
        standard_parallel_1=true_scale_latitude or 90.0,
    )


def named_projection(
    name: str, central_longitude: float, central_latitude: float
) -> tuple[Projection, tuple[str, ...]]:
    """A map in metres about a centre, and notes; ``Unknown`` where the name is not known here.

    Args:
        name: in capitals, words apart.
        central_longitude, central_latitude: degrees east and north.
    """
    if name == "SINUSOIDAL":
        return Sinusoidal(central_longitude=central_longitude), ()
    if name == "MERCATOR" and central_latitude == 0.0:
        return Mercator(central_longitude=central_longitude), ()
    centre = {"central_longitude": central_longitude, "latitude_of_origin": central_latitude}
    if name == "TRANSVERSE MERCATOR":
        return TransverseMercator(**centre), ()
    if name == "LAMBERT AZIMUTHAL EQUAL AREA":
        return LambertAzimuthalEqualArea(**centre), ()
    if name in {"STEREOGRAPHIC", "OBLIQUE STEREOGRAPHIC"} and abs(central_latitude) < 90.0:
        return ObliqueStereographic(**centre), ()
    note = f"The projection {name.title()} is not known here: places are given in the map's metres only."
    return Unknown(), (note,)
