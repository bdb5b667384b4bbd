"""The IMAGE_MAP_PROJECTION object of a PDS3 label: its numbers, checked and in one unit.

Source: "Planetary Science Data Dictionary" (JPL D-7116) for the keywords; DSMAP.CAT and DSMAP_POLAR.CAT of
the data sets MGS-M-MOLA-5-MEGDR-L3-V1.0 and LRO-L-LOLA-4-GDR-V1.0 for what their teams mean by them.
"""

from __future__ import annotations

import math

from ..body.ellipsoid import Ellipsoid
from ..georeference import LatitudeKind
from .label import Label, Units
from .pds3_values import KILOMETRES

MAP = "IMAGE_MAP_PROJECTION"

DEGREES: Units = {"DEGREE": 1.0, "DEGREES": 1.0, "DEG": 1.0}

PIXELS_PER_DEGREE: Units = {
    "PIXEL/DEGREE": 1.0,
    "PIXELS/DEGREE": 1.0,
    "PIX/DEG": 1.0,
    "PIXEL/DEG": 1.0,
    "PIXELS/DEG": 1.0,
    "PIX/DEGREE": 1.0,
}

METRES_PER_PIXEL: Units = {
    "KM/PIXEL": 1000.0,
    "KM/PIX": 1000.0,
    "KM": 1000.0,
    "KILOMETERS/PIXEL": 1000.0,
    "KILOMETER/PIXEL": 1000.0,
    "M/PIXEL": 1.0,
    "M/PIX": 1.0,
    "M": 1.0,
    "METER/PIXEL": 1.0,
    "METERS/PIXEL": 1.0,
}
"""PDS3 has scales in kilometres a pixel where no unit is written."""

LONGITUDE_LIMITS = "WESTERNMOST_LONGITUDE and EASTERNMOST_LONGITUDE"
LATITUDE_LIMITS = "MINIMUM_LATITUDE and MAXIMUM_LATITUDE"

MOST_DISAGREEMENT = 0.02
"""Share by which MAP_SCALE, which is rounded, may differ from what MAP_RESOLUTION says."""


class Pds3Map:
    """The map of one label, for an image of so many rows and columns."""

    def __init__(self, label: Label, rows: int, columns: int) -> None:
        self.label = label
        self.rows = rows
        self.columns = columns

    @property
    def has_offsets(self) -> bool:
        """Whether the label says where the projection's origin is in the image."""
        return all(
            self.optional(field, None) is not None
            for field in ("LINE_PROJECTION_OFFSET", "SAMPLE_PROJECTION_OFFSET")
        )

    def limits(self) -> tuple[float, float, float, float]:
        """West, east, south, north in degrees, checked."""
        west, east = self.degrees("WESTERNMOST_LONGITUDE"), self.degrees("EASTERNMOST_LONGITUDE")
        if east <= west:
            east += 360.0
        south, north = self.degrees("MINIMUM_LATITUDE"), self.degrees("MAXIMUM_LATITUDE")
        if not (0.0 < east - west <= 360.0):
            raise self.label.wrong(
                LONGITUDE_LIMITS, f"{west} and {east}", "at most 360 degrees", "Mend the label."
            )
        if not (-90.0 <= south < north <= 90.0):
            raise self.label.wrong(
                LATITUDE_LIMITS, f"{south} and {north}", "south < north within +-90", "Mend the label."
            )
        return west, east, south, north

    def pole(self) -> float:
        """Latitude of the pole in the middle: 90 or -90."""
        latitude = self.optional("CENTER_LATITUDE", DEGREES)
        if latitude is not None and abs(latitude) == 90.0:
            return latitude
        if latitude is None:
            for field, pole in (("MAXIMUM_LATITUDE", 90.0), ("MINIMUM_LATITUDE", -90.0)):
                if self.optional(field, DEGREES) == pole:
                    return pole
        raise self.label.wrong(
            "CENTER_LATITUDE", "nothing" if latitude is None else latitude, "90 or -90", "Mend the label."
        )

    def step(self, radius: float | None = None) -> float:
        """Metres from one sample to the next.

        MOLA's MAP_RESOLUTION is a whole number and exact, and its MAP_SCALE is rounded; LOLA's MAP_SCALE of
        polar maps is exact, and its MAP_RESOLUTION is approximate.
        """
        resolution = self.optional("MAP_RESOLUTION", PIXELS_PER_DEGREE)
        scale = self.optional("MAP_SCALE", METRES_PER_PIXEL)
        for field, number in (("MAP_RESOLUTION", resolution), ("MAP_SCALE", scale)):
            if number is not None and number <= 0.0:
                raise self.label.wrong(field, number, "a number above 0", "Mend the label.")
        if resolution is None:
            return self.positive("MAP_SCALE", METRES_PER_PIXEL) if scale is None else scale
        if radius is None:
            radius = self.ellipsoid().semi_major
        resolved = math.radians(1.0) * radius / resolution
        if scale is None:
            return resolved
        if abs(resolved - scale) > MOST_DISAGREEMENT * scale:
            raise self.label.wrong(
                "MAP_SCALE",
                f"{scale:g} m",
                f"about {resolved:g} m, as MAP_RESOLUTION says",
                "Mend whichever of them is wrong.",
            )
        return resolved if resolution == int(resolution) else scale

    def origin(self) -> tuple[float, float]:
        """Line and sample of the projection's origin, from 0 at the centre of the first sample.

        PDS3's dictionary counts LINE_PROJECTION_OFFSET from the first line (so from 0: LOLA, HiRISE);
        MOLA's DSMAP.CAT means the line's number (so from 1). GDAL counts from 0 always, which moves MOLA's
        maps by one cell. Where the origin is about the middle, either way of counting means the middle.
        """
        counts_from_1 = "MOLA" in self.label.text("DATA_SET_ID", default="").upper()
        origin = []
        for field, count in (
            ("LINE_PROJECTION_OFFSET", self.rows),
            ("SAMPLE_PROJECTION_OFFSET", self.columns),
        ):
            offset = self.optional(field, None)
            middle = (count - 1) / 2.0
            if offset is None or abs(offset - count / 2.0) <= 0.75:
                origin.append(middle)
            else:
                origin.append(offset - 1.0 if counts_from_1 else offset)
        return origin[0], origin[1]

    def ellipsoid(self) -> Ellipsoid:
        """A sphere of the equatorial radius; an ellipsoid only where latitudes refer to one."""
        radius = self.positive("A_AXIS_RADIUS", KILOMETRES)
        if self.latitude_kind() == "planetographic":
            polar = self.optional("C_AXIS_RADIUS", KILOMETRES)
            if polar is not None and 0.5 * radius < polar <= radius:
                return Ellipsoid(radius, polar)
        return Ellipsoid.sphere(radius)

    def latitude_kind(self) -> LatitudeKind:
        """What latitudes refer to."""
        told = self.label.text(MAP, "COORDINATE_SYSTEM_NAME", default="PLANETOCENTRIC").upper()
        return "planetographic" if "GRAPHIC" in told else "planetocentric"

    def degrees(self, field: str) -> float:
        """A number that must be there, degrees."""
        return self.label.number(MAP, field, units=DEGREES)

    def positive(self, field: str, units: Units) -> float:
        """A number above 0 that must be there."""
        number = self.label.number(MAP, field, units=units)
        if number <= 0.0:
            raise self.label.wrong(field, number, "a number above 0", "Mend the label.")
        return number

    def optional(self, field: str, units: Units | None) -> float | None:
        """A number that may be missing, or be the text N/A."""
        value = self.label.value(MAP, field, default=None)
        if value is None or isinstance(value, str):
            return None
        return self.label.number(MAP, field, units=units)
