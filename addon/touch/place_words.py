"""Places and maps in words."""

from __future__ import annotations

from ..formats import Georeference
from .live import Readout

DEGREE = "\N{DEGREE SIGN}"

Line = tuple[str, str]
"""A name and a value."""


def place_lines(readout: Readout, exaggeration: float, *, in_degrees: bool) -> list[Line]:
    """Where the cursor is: longitude and latitude, and a map's own metres where it has some.

    Args:
        in_degrees: whether the map's own coordinates are longitude and latitude themselves.
    """
    lines: list[Line] = []
    if readout.coordinates is not None:
        longitude, latitude = readout.coordinates
        lines += [("Longitude", f"{longitude:.4f}{DEGREE} E"), ("Latitude", latitude_words(latitude))]
    if not in_degrees:
        x, y = readout.own
        lines += [("East", f"{x:,.0f} m"), ("North", f"{y:,.0f} m")]
    elevation = "no data" if readout.elevation is None else f"{readout.elevation:,.1f} m (x{exaggeration:g})"
    return [*lines, ("Elevation", elevation)]


def latitude_words(latitude: float) -> str:
    """Degrees north or south."""
    return f"{abs(latitude):.4f}{DEGREE} {'N' if latitude >= 0.0 else 'S'}"


def georeference_lines(georeference: Georeference) -> list[Line]:
    """What the numbers of a grid mean."""
    ellipsoid = georeference.ellipsoid
    shape = (
        f"sphere, {ellipsoid.semi_major:,.0f} m"
        if ellipsoid.is_sphere
        else f"{ellipsoid.semi_major:,.0f}, {ellipsoid.semi_minor:,.0f} m"
    )
    lines = [
        ("Body", georeference.body or "not stated"),
        ("Semi-axes", shape),
        ("Projection", georeference.projection.name),
        ("Latitudes", georeference.latitude_kind),
        ("Elevation 0", georeference.vertical_reference or "not stated"),
    ]
    if georeference.vertical_unit != "m":
        lines.append(("In the file", georeference.vertical_unit))
    return [*lines, ("Frame", georeference.frame)] if georeference.frame else lines
