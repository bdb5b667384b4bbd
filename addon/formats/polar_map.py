"""The one place that chooses the class for polar stereographic maps."""

from __future__ import annotations

from .projections import Projection, Unknown


def polar_stereographic(
    pole: float, central_longitude: float, true_scale_latitude: float | None = None
) -> tuple[Projection, tuple[str, ...]]:
    """The projection around a pole (90 or -90), and notes.

    Args:
        central_longitude: degrees east; down from the north pole, up from the south pole.
        true_scale_latitude: where the map is true to scale; ``None`` at the pole.
    """
    note = f"A polar stereographic map: longitudes cannot be told yet (pole {pole:g}, {central_longitude:g})."
    return Unknown(), (note,)
