"""The GeoKeyDirectory of a GeoTIFF file: keys, their numbers and texts (OGC 19-008r4, 7.1).

Names of keys are those of the standard, without "GeoKey" at their end.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum

from .geotiff_tags import GEO_ASCII_PARAMS, GEO_DOUBLE_PARAMS, GEO_KEY_DIRECTORY, Tags

UNDEFINED, USER_DEFINED = 0, 32767
"""Values of keys that are no codes."""

MAXIMUM_KEYS = 1024
"""There are about 60."""


class Key(IntEnum):
    """Keys that are looked at."""

    GTModelType = 1024
    GTRasterType = 1025
    GTCitation = 1026
    GeodeticCRS = 2048
    GeodeticCitation = 2049
    GeodeticDatum = 2050
    PrimeMeridian = 2051
    GeogAngularUnits = 2054
    GeogAngularUnitSize = 2055
    Ellipsoid = 2056
    EllipsoidSemiMajorAxis = 2057
    EllipsoidSemiMinorAxis = 2058
    EllipsoidInvFlattening = 2059
    PrimeMeridianLongitude = 2061
    ProjectedCRS = 3072
    ProjectedCitation = 3073
    Projection = 3074
    ProjMethod = 3075
    ProjLinearUnits = 3076
    ProjLinearUnitSize = 3077
    ProjStdParallel1 = 3078
    ProjStdParallel2 = 3079
    ProjNatOriginLong = 3080
    ProjNatOriginLat = 3081
    ProjFalseEasting = 3082
    ProjFalseNorthing = 3083
    ProjFalseOriginLong = 3084
    ProjFalseOriginLat = 3085
    ProjFalseOriginEasting = 3086
    ProjFalseOriginNorthing = 3087
    ProjCenterLong = 3088
    ProjCenterLat = 3089
    ProjCenterEasting = 3090
    ProjCenterNorthing = 3091
    ProjScaleAtNatOrigin = 3092
    ProjScaleAtCenter = 3093
    ProjStraightVertPoleLong = 3095
    Vertical = 4096
    VerticalCitation = 4097
    VerticalDatum = 4098
    VerticalUnits = 4099


@dataclass(frozen=True)
class GeoKeys:
    """Keys by their numbers; none where the file has no directory."""

    tags: Tags
    values: Mapping[int, float | str]

    def code(self, key: Key) -> int:
        """Give a code; ``UNDEFINED`` where the file has none."""
        value = self.values.get(key, UNDEFINED)
        if isinstance(value, str) or not 0 <= value <= 65_535 or value != int(value):
            raise self.tags.wrong(key.name, value, "a code from 0 to 65535")
        return int(value)

    def number(self, *keys: Key) -> float | None:
        """Give the number of the first of these keys that the file has."""
        for key in keys:
            value = self.values.get(key)
            if value is None:
                continue
            if isinstance(value, str) or not math.isfinite(value):
                raise self.tags.wrong(key.name, value, "a finite number")
            return value
        return None

    def text(self, key: Key) -> str:
        """Give a text, empty where the file has none."""
        value = self.values.get(key, "")
        return value if isinstance(value, str) else ""


def geo_keys(tags: Tags) -> GeoKeys:
    """Read the directory.

    Raises:
        DecodeError: one of its tags cannot be read.
    """
    directory = [int(number) for number in tags.finite_numbers(GEO_KEY_DIRECTORY)]
    if not directory:
        return GeoKeys(tags, {})
    if len(directory) < 4 or directory[0] != 1:
        raise tags.wrong("GeoKeyDirectory", directory[:4], "version 1 and the number of keys")
    count = directory[3]
    if count > MAXIMUM_KEYS or len(directory) < 4 + 4 * count:
        raise tags.wrong("GeoKeyDirectory", f"{len(directory)} numbers", f"{count} keys of 4 numbers each")
    doubles, texts = tags.numbers(GEO_DOUBLE_PARAMS), tags.text(GEO_ASCII_PARAMS)
    values: dict[int, float | str] = {}
    for place in range(4, 4 + 4 * count, 4):
        key, location, length, value = directory[place : place + 4]
        if location == 0:
            values[key] = float(value)
        elif location == GEO_ASCII_PARAMS:
            values[key] = texts[value : value + length].rstrip("|\0").strip()
        elif location == GEO_DOUBLE_PARAMS and length >= 1:
            if value >= len(doubles):
                raise tags.wrong(f"GeoKey {key}", f"number {value} of {len(doubles)}", "one that is there")
            values[key] = doubles[value]
        elif location == GEO_KEY_DIRECTORY and length >= 1:
            if value >= len(directory):
                raise tags.wrong(f"GeoKey {key}", f"number {value} of {len(directory)}", "one that is there")
            values[key] = float(directory[value])
    return GeoKeys(tags, values)
