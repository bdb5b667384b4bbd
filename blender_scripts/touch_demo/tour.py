"""Where the demo's hand goes and what its picture shows, in degrees on the map."""

from __future__ import annotations

from dataclasses import dataclass

PRESS, LIFT = 2.5, -2.0
"""How deep the hand presses, and how high it hovers (negative), millimetres of the workspace."""


@dataclass(frozen=True)
class MapPlace:
    """What a tour needs to know of a map; its limits are the outer edges, degrees or the map's metres."""

    body: str
    west: float
    east: float
    south: float
    north: float
    spans_the_globe: bool
    """Whether the map has neither an east nor a west edge."""


@dataclass(frozen=True)
class Stop:
    """A place that the hand passes: degrees east and north, and its depth under the ground there.

    ``press`` is in millimetres of the workspace; negative above the ground.
    """

    longitude: float
    latitude: float
    press: float = PRESS


@dataclass(frozen=True)
class Tour:
    """One way over one map."""

    stops: tuple[Stop, ...]
    """Explored slowly, and where the hand stays at the end."""
    swipe_latitudes: tuple[float, ...]
    """Of fast swipes across the whole map, east and back."""
    window_degrees: float
    """Longitudes across the workspace while the stops are explored."""
    centre: tuple[float, float]
    """Longitude and latitude in the middle of the picture."""
    picture_degrees: float
    """Longitudes across the picture, at its middle."""
    exaggeration: float
    """Of heights; 0 leaves it to the extension."""


# Olympus Mons, the Tharsis volcanoes, Noctis Labyrinthus, then across and along Valles Marineris.
MARS = Tour(
    stops=(
        Stop(214.0, 14.0, LIFT),
        Stop(217.0, 15.0),
        Stop(221.5, 16.8),
        Stop(226.0, 18.6, 1.5),
        Stop(231.0, 20.0),
        Stop(237.0, 19.0),
        Stop(241.0, 16.0, LIFT),
        Stop(247.0, 12.5, LIFT),
        Stop(251.0, 12.0),
        Stop(255.5, 11.5, 1.5),
        Stop(252.0, 5.0),
        Stop(247.2, 1.0, 1.5),
        Stop(251.0, -4.0),
        Stop(258.0, -6.5),
        Stop(264.0, -7.5),
        Stop(269.0, -5.0),
        Stop(274.0, -9.0, 1.2),
        Stop(278.0, -4.5),
        Stop(283.0, -10.5, 1.2),
        Stop(286.5, -3.5),
        Stop(290.0, -14.5, 1.2),
        Stop(294.0, -8.0),
        Stop(298.0, -15.0, 1.2),
        Stop(301.0, -18.5),
        Stop(304.0, -20.5),
    ),
    swipe_latitudes=(-45.0, -58.0),
    window_degrees=105.0,
    centre=(263.5, 2.0),
    picture_degrees=142.0,
    exaggeration=15.0,
)

# The same kind of way over the sample's landforms: great volcano, three smaller ones, canyon.
SYNTHETIC = Tour(
    stops=(
        Stop(102.0, 14.0, LIFT),
        Stop(105.0, 15.0),
        Stop(108.5, 16.0),
        Stop(112.5, 17.0, 1.5),
        Stop(117.0, 17.5),
        Stop(122.0, 16.0),
        Stop(127.0, 15.0, LIFT),
        Stop(134.0, 13.5, LIFT),
        Stop(138.0, 12.5),
        Stop(142.0, 11.0, 1.5),
        Stop(138.5, 6.0),
        Stop(135.0, 1.5, 1.5),
        Stop(139.0, -4.0),
        Stop(146.0, -7.0),
        Stop(152.0, -8.0),
        Stop(157.0, -2.0),
        Stop(162.0, -8.0, 1.2),
        Stop(168.0, 1.5),
        Stop(174.0, -9.0, 1.2),
        Stop(180.0, 0.0),
        Stop(186.0, -10.0, 1.2),
        Stop(191.0, -1.5),
        Stop(196.0, -9.0, 1.2),
        Stop(201.0, -14.0),
        Stop(204.0, -17.0),
    ),
    swipe_latitudes=(-45.0, -58.0),
    window_degrees=110.0,
    centre=(157.0, 1.0),
    picture_degrees=142.0,
    exaggeration=15.0,
)


def tour_of(place: MapPlace, *, synthetic: bool) -> Tour:
    """Choose the tour for a map; a map of which nothing is known is crossed from corner to corner."""
    if place.spans_the_globe and synthetic:
        return SYNTHETIC
    if place.spans_the_globe and place.body.upper() == "MARS":
        return MARS
    return _zigzag(place)


def _zigzag(place: MapPlace) -> Tour:
    width = place.east - place.west
    height = place.north - place.south

    def stop(right: float, up: float, press: float = PRESS) -> Stop:
        return Stop(place.west + right * width, place.south + up * height, press)

    middle = stop(0.5, 0.5)
    return Tour(
        stops=(
            stop(0.15, 0.30, LIFT),
            stop(0.20, 0.35),
            stop(0.35, 0.70),
            stop(0.45, 0.35, 1.2),
            stop(0.52, 0.50, LIFT),
            stop(0.58, 0.55),
            stop(0.70, 0.30),
            stop(0.80, 0.70, 1.2),
            stop(0.75, 0.50),
        ),
        swipe_latitudes=(stop(0.0, 0.8).latitude, stop(0.0, 0.2).latitude),
        window_degrees=width,
        centre=(middle.longitude, middle.latitude),
        picture_degrees=1.15 * width,
        exaggeration=0.0,
    )
