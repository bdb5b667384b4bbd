"""Projections as labels of planetary archives state them: a name, and a centre."""

from __future__ import annotations

from ..projections import (
    LambertAzimuthalEqualArea,
    LambertConformalConic,
    Mercator,
    ObliqueStereographic,
    PolarStereographic,
    Projection,
    Sinusoidal,
    TransverseMercator,
    Unknown,
)


def polar_stereographic(
    pole: float, central_longitude: float, true_scale_latitude: float | None = None, scale_factor: float = 1.0
) -> PolarStereographic:
    """The projection around a pole (90 or -90).

    Args:
        central_longitude: degrees east; down from the north pole, up from the south pole.
        true_scale_latitude: where the scale is stated; ``None`` at the pole.
        scale_factor: there.
    """
    return PolarStereographic(
        latitude_of_origin=pole,
        central_longitude=central_longitude,
        standard_parallel_1=true_scale_latitude or 90.0,
        scale_factor=scale_factor,
    )


def named_projection(
    name: str,
    central_longitude: float,
    central_latitude: float,
    parallels: tuple[float | None, float | None] = (None, None),
    scale_factor: float = 1.0,
) -> tuple[Projection, tuple[str, ...]]:
    """A map in metres about a centre, and notes; ``Unknown`` where the name is not known here.

    Args:
        name: in capitals, words apart.
        central_longitude, central_latitude: degrees east and north.
        parallels: standard ones, degrees north; ``None`` where none is stated.
        scale_factor: along the standard parallels, or at the centre.
    """
    first, second = parallels
    centre = {"central_longitude": central_longitude, "latitude_of_origin": central_latitude}
    if name == "SINUSOIDAL":
        return Sinusoidal(central_longitude=central_longitude), ()
    if name == "MERCATOR" and central_latitude == 0.0:
        return Mercator(
            central_longitude=central_longitude, standard_parallel_1=first or 0.0, scale_factor=scale_factor
        ), ()
    if name == "TRANSVERSE MERCATOR":
        return TransverseMercator(**centre, scale_factor=scale_factor), ()
    if name == "LAMBERT AZIMUTHAL EQUAL AREA":
        return LambertAzimuthalEqualArea(**centre), ()
    if name == "LAMBERT CONFORMAL CONIC":
        # A cone of one parallel touches at its origin, where the label does not say which parallel it is.
        one = central_latitude if first is None else first
        cone = {"standard_parallel_1": one, "standard_parallel_2": one if second is None else second}
        return LambertConformalConic(**centre, **cone, scale_factor=scale_factor), ()
    if name in {"STEREOGRAPHIC", "OBLIQUE STEREOGRAPHIC"} and abs(central_latitude) < 90.0:
        return ObliqueStereographic(**centre, scale_factor=scale_factor), ()
    note = f"The projection {name.title()} is not known here: places are given in the map's metres only."
    return Unknown(), (note,)
