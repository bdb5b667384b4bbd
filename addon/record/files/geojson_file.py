"""The path of a take as GeoJSON (RFC 7946): longitude, latitude and elevation.

RFC 7946 means WGS 84. Another body's degrees are no such thing: the foreign member ``haptic_terrain`` names
the body, its shape and the kind of latitude, and programs that know only WGS 84 draw the right figure on
the wrong planet.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import asdict
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ...formats.format_error import FormatError
from ...formats.refusal import first_line, shortened
from ...formats.unfinished import unfinished_file
from ..resample import HELD_SECONDS
from ..take_data import Numbers, TakeData
from .derived import longitudes_latitudes

FOREIGN = "haptic_terrain"

MOST_BYTES = 1 << 30
"""Of a file that is read."""

HALF, TURN = 180.0, 360.0
"""Degrees."""


class NoPlaceError(ValueError):
    """Nobody can tell where on its body a take was."""


def write_geojson(path: Path, data: TakeData) -> None:
    """Write where the proxy was; a place is left out while the proxy rests there.

    Raises:
        NoPlaceError: the map's projection is not known, or the proxy was beside the map.
        OSError: it cannot be written.
    """
    lines = list(path_lines(data))
    if not lines:
        raise NoPlaceError(
            f"Longitude and latitude of this take are not known: {data.about.source} does not tell its "
            "projection, or the take is beside the map. Export it as CSV or NPZ."
        )
    with unfinished_file(path) as file:
        file.write(json.dumps(_document(data, lines), allow_nan=False).encode())


def read_path(path: Path) -> list[Numbers]:
    """Read the lines of a path, each n x 3: degrees east, degrees north, metres up.

    Raises:
        FormatError: naming what cannot be used.
        OSError: it cannot be read.
    """
    size = path.stat().st_size
    if size > MOST_BYTES:
        raise _refused(path, "size", f"{size:,} bytes", f"{MOST_BYTES:,} at the most")
    try:
        document = json.loads(path.read_bytes())
    except (ValueError, RecursionError) as error:
        raise _refused(path, "JSON", first_line(error), "a whole GeoJSON file") from error
    try:
        geometry = document["features"][0]["geometry"]
        kind, lines = geometry["type"], geometry["coordinates"]
        if kind != "MultiLineString":
            raise _refused(path, "geometry", shortened(kind), "a MultiLineString")
        return [_line(path, line) for line in lines]
    except (KeyError, IndexError, TypeError) as error:
        raise _refused(
            path,
            "features",
            shortened(f"{type(error).__name__}: {error}"),
            "a feature with a MultiLineString",
        ) from error


def path_lines(data: TakeData) -> Iterator[Numbers]:
    """Cut the path where nobody knows it, where time is missing, and at the antimeridian; each n x 3."""
    longitude, latitude = longitudes_latitudes(data)
    places = np.column_stack(((longitude + HALF) % TURN - HALF, latitude, data.places[:, 2]))
    known = np.isfinite(places).all(axis=1)
    pause = np.diff(data.columns["time"]) > HELD_SECONDS
    cuts = np.flatnonzero((known[1:] != known[:-1]) | pause) + 1
    for first, last in pairwise([0, *cuts.tolist(), len(data)]):
        if first < last and known[first]:
            for line in _east_to_west(places[first:last]):
                moves = np.append(True, (np.diff(line, axis=0) != 0.0).any(axis=1))
                if moves.sum() > 1:
                    yield line[moves]


def _east_to_west(places: Numbers) -> Iterator[Numbers]:
    """Cut a line where it crosses the antimeridian (RFC 7946, section 3.1.9): both pieces end on it."""
    crossings = np.flatnonzero(np.abs(np.diff(places[:, 0])) > HALF)
    start: list[Numbers] = []
    begin = 0
    for before in crossings.tolist():
        here, there = places[before].copy(), places[before + 1]
        edge = math.copysign(HALF, here[0])
        beyond = there[0] + 2.0 * edge
        share = (edge - here[0]) / (beyond - here[0])
        leave = here + share * (there - here)
        enter = leave.copy()
        leave[0], enter[0] = edge, -edge
        yield np.vstack([*start, places[begin : before + 1], leave])
        start, begin = [enter], before + 1
    yield np.vstack([*start, places[begin:]])


def _document(data: TakeData, lines: list[Numbers]) -> dict[str, Any]:
    about = data.about
    georeference = about.georeference
    properties = {
        "name": about.terrain,
        "source": about.source,
        "seconds": data.seconds,
        "ticks": len(data),
        "contact_models": list(about.models),
    }
    return {
        "type": "FeatureCollection",
        FOREIGN: {
            "body": georeference.body,
            "ellipsoid_metres": asdict(georeference.ellipsoid),
            "latitude": georeference.latitude_kind,
            "longitude": "east-positive",
            "elevation": f"metres above {georeference.vertical_reference or 'an unknown reference'}",
            "frame": georeference.frame,
        },
        "features": [
            {
                "type": "Feature",
                "properties": properties,
                "geometry": {"type": "MultiLineString", "coordinates": [line.tolist() for line in lines]},
            }
        ],
    }


def _line(path: Path, line: Any) -> Numbers:
    try:
        places = np.array(line, dtype=np.float64)
    except (ValueError, OverflowError) as error:
        raise _refused(path, "coordinates", first_line(error), "numbers") from error
    if places.ndim != 2 or places.shape[1] != 3 or len(places) < 2:
        raise _refused(
            path, "coordinates", f"a line of shape {places.shape}", "2 or more places of 3 numbers"
        )
    if not np.isfinite(places).all():
        raise _refused(path, "coordinates", "a number that is not finite", "finite numbers")
    return places


def _refused(path: Path, field: str, found: object, expected: object) -> FormatError:
    return FormatError(path, field, found=found, expected=expected, way_out="Export the path again.")
