"""Where on its body a PDS3 image lies: the IMAGE_MAP_PROJECTION object.

Source: "Planetary Science Data Dictionary" (JPL D-7116) for the keywords; DSMAP.CAT and DSMAP_POLAR.CAT of
the data sets MGS-M-MOLA-5-MEGDR-L3-V1.0 and LRO-L-LOLA-4-GDR-V1.0 for what their teams mean by them.
"""

from __future__ import annotations

import math

from .ellipsoid import Ellipsoid
from .georeference import Georeference, LatitudeKind
from .label import Label, Units
from .pds3_values import KILOMETRES, Pds3Values
from .planet_maps import named_projection, polar_stereographic
from .projections import Geographic, Projection

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

Found = tuple[Georeference, tuple[str, ...]]


def pds3_georeference(label: Label, rows: int, columns: int, values: Pds3Values) -> Found:
    """Build the geometry; and what a person should know of it."""
    projection = label.text(MAP, "MAP_PROJECTION_TYPE").replace("_", " ").upper()
    direction = label.text(MAP, "POSITIVE_LONGITUDE_DIRECTION", default="EAST").upper()
    if direction != "EAST":
        raise label.wrong(
            "POSITIVE_LONGITUDE_DIRECTION",
            direction,
            "EAST",
            "Maps with longitudes to the west are not read yet.",
        )
    place = _Place(label, rows, columns, values)
    georeference, notes = place.of(projection)
    return georeference, (*notes, *place.rotation_notes())


class _Place:
    """The map's object of one label, for an image of so many rows and columns."""

    def __init__(self, label: Label, rows: int, columns: int, values: Pds3Values) -> None:
        self.label = label
        self.rows = rows
        self.columns = columns
        self.values = values

    def of(self, projection: str) -> Found:
        """By the projection's name, in capitals, words apart."""
        if projection == "SIMPLE CYLINDRICAL":
            return self.from_limits()
        if projection.startswith("EQUIRECTANGULAR"):
            return self.from_offsets_in_degrees() if self.has_offsets else self.from_limits()
        if projection == "POLAR STEREOGRAPHIC":
            return self.polar()
        return self.in_metres(projection)

    def rotation_notes(self) -> tuple[str, ...]:
        """What is told of a turned map: archives hardly have one, and which way it turns is not agreed."""
        rotation = self._optional("MAP_PROJECTION_ROTATION", DEGREES)
        if not rotation:
            return ()
        return (f"The label states a map turned by {rotation:g} degrees, which is not applied to places.",)

    @property
    def has_offsets(self) -> bool:
        """Whether the label says where the projection's origin is in the image."""
        return all(
            self._optional(field, None) is not None
            for field in ("LINE_PROJECTION_OFFSET", "SAMPLE_PROJECTION_OFFSET")
        )

    def from_limits(self) -> Found:
        """Longitude and latitude from MAP_RESOLUTION and the limits (MAP_SCALE is rounded)."""
        west, east, south, north = self._limits()
        resolution = self._positive("MAP_RESOLUTION", PIXELS_PER_DEGREE)
        for field, count, degrees in (
            ("LINE_SAMPLES", self.columns, (east - west) * resolution),
            ("LINES", self.rows, (north - south) * resolution),
        ):
            if abs(count - degrees) > 0.5:
                raise self.label.wrong(
                    field,
                    count,
                    f"{degrees:g} from MAP_RESOLUTION and the limits",
                    "Mend whichever of them is wrong.",
                )
        step = 1.0 / resolution
        return self._georeference(
            Geographic(), west + step / 2.0, north - step / 2.0, step, step, self._ellipsoid()
        ), ()

    def from_offsets_in_degrees(self) -> Found:
        """Equirectangular maps: rows and columns are evenly spaced in degrees too, so degrees are given.

        CENTER_LATITUDE is true to scale; the origin is where CENTER_LONGITUDE crosses the equator.
        """
        ellipsoid = self._ellipsoid()
        step_y = self._step() / math.radians(1.0) / ellipsoid.semi_major
        true_scale = self._optional("CENTER_LATITUDE", DEGREES) or 0.0
        shrinking = math.cos(math.radians(true_scale))
        if not abs(true_scale) < 90.0:
            raise self.label.wrong("CENTER_LATITUDE", true_scale, "a latitude within +-90", "Mend the label.")
        step_x = step_y / shrinking
        if abs(self.columns * step_x - 360.0) < step_x / 2.0:
            step_x = 360.0 / self.columns  # once around, which a rounded scale misses
        line, sample = self._origin()
        middle = self._optional("CENTER_LONGITUDE", DEGREES) or 0.0
        first_x, first_y = middle - sample * step_x, line * step_y
        last_y = first_y - (self.rows - 1) * step_y
        if not (last_y > -90.0 - step_y and first_y < 90.0 + step_y):
            raise self.label.wrong(
                "LINE_PROJECTION_OFFSET",
                f"{line:g}, which makes latitudes of {last_y:g} to {first_y:g}",
                "latitudes within +-90",
                "Mend the label.",
            )
        return self._georeference(Geographic(), first_x, first_y, step_x, step_y, ellipsoid), ()

    def polar(self) -> Found:
        """Polar stereographic maps, true to scale at the pole, on a sphere of the polar radius.

        x = rho sin(longitude), and y = rho cos(longitude) upward in the south, downward in the north, as both
        DSMAP_POLAR.CAT draw it.
        """
        latitude = self._pole()
        middle = self._optional("CENTER_LONGITUDE", DEGREES) or 0.0
        # Both teams compute on a sphere; of an ellipsoid the polar radius is the one that fits a pole.
        radius = self._optional("C_AXIS_RADIUS", KILOMETRES) or self._positive("A_AXIS_RADIUS", KILOMETRES)
        if radius <= 0.0:
            raise self.label.wrong("C_AXIS_RADIUS", radius, "a number above 0", "Mend the label.")
        step = self._step(radius)
        line, sample = self._origin()
        projection, sphere = polar_stereographic(latitude, middle), Ellipsoid.sphere(radius)
        return self._georeference(projection, -sample * step, line * step, step, step, sphere), ()

    def in_metres(self, name: str) -> Found:
        """Maps about a centre; where the projection is not known here touch is right all the same."""
        ellipsoid, step = self._ellipsoid(), self._step()
        projection, notes = named_projection(
            name,
            self._optional("CENTER_LONGITUDE", DEGREES) or 0.0,
            self._optional("CENTER_LATITUDE", DEGREES) or 0.0,
        )
        line, sample = self._origin()
        if not self.has_offsets:
            notes = (*notes, "The label does not say where the map's origin is: its middle is assumed.")
        return self._georeference(projection, -sample * step, line * step, step, step, ellipsoid), notes

    def _limits(self) -> tuple[float, float, float, float]:
        """West, east, south, north in degrees, checked."""
        west, east = self._degrees("WESTERNMOST_LONGITUDE"), self._degrees("EASTERNMOST_LONGITUDE")
        if east <= west:
            east += 360.0
        south, north = self._degrees("MINIMUM_LATITUDE"), self._degrees("MAXIMUM_LATITUDE")
        if not (0.0 < east - west <= 360.0):
            raise self.label.wrong(
                LONGITUDE_LIMITS, f"{west} and {east}", "at most 360 degrees", "Mend the label."
            )
        if not (-90.0 <= south < north <= 90.0):
            raise self.label.wrong(
                LATITUDE_LIMITS, f"{south} and {north}", "south < north within +-90", "Mend the label."
            )
        return west, east, south, north

    def _pole(self) -> float:
        """Latitude of the pole in the middle: 90 or -90."""
        latitude = self._optional("CENTER_LATITUDE", DEGREES)
        if latitude is not None and abs(latitude) == 90.0:
            return latitude
        if latitude is None:
            for field, pole in (("MAXIMUM_LATITUDE", 90.0), ("MINIMUM_LATITUDE", -90.0)):
                if self._optional(field, DEGREES) == pole:
                    return pole
        raise self.label.wrong(
            "CENTER_LATITUDE", "nothing" if latitude is None else latitude, "90 or -90", "Mend the label."
        )

    def _step(self, radius: float | None = None) -> float:
        """Metres from one sample to the next.

        MOLA's MAP_RESOLUTION is a whole number and exact, and its MAP_SCALE is rounded; LOLA's MAP_SCALE of
        polar maps is exact, and its MAP_RESOLUTION is approximate.
        """
        resolution = self._optional("MAP_RESOLUTION", PIXELS_PER_DEGREE)
        scale = self._optional("MAP_SCALE", METRES_PER_PIXEL)
        for field, number in (("MAP_RESOLUTION", resolution), ("MAP_SCALE", scale)):
            if number is not None and number <= 0.0:
                raise self.label.wrong(field, number, "a number above 0", "Mend the label.")
        if resolution is None:
            return self._positive("MAP_SCALE", METRES_PER_PIXEL) if scale is None else scale
        if radius is None:
            radius = self._ellipsoid().semi_major
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

    def _origin(self) -> tuple[float, float]:
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
            offset = self._optional(field, None)
            middle = (count - 1) / 2.0
            if offset is None or abs(offset - count / 2.0) <= 0.75:
                origin.append(middle)
            else:
                origin.append(offset - 1.0 if counts_from_1 else offset)
        return origin[0], origin[1]

    def _ellipsoid(self) -> Ellipsoid:
        """A sphere of the equatorial radius; an ellipsoid only where latitudes refer to one."""
        radius = self._positive("A_AXIS_RADIUS", KILOMETRES)
        if self._latitude_kind() == "planetographic":
            polar = self._optional("C_AXIS_RADIUS", KILOMETRES)
            if polar is not None and 0.5 * radius < polar <= radius:
                return Ellipsoid(radius, polar)
        return Ellipsoid.sphere(radius)

    def _latitude_kind(self) -> LatitudeKind:
        told = self.label.text(MAP, "COORDINATE_SYSTEM_NAME", default="PLANETOCENTRIC").upper()
        return "planetographic" if "GRAPHIC" in told else "planetocentric"

    def _georeference(
        self,
        projection: Projection,
        first_x: float,
        first_y: float,
        step_x: float,
        step_y: float,
        ellipsoid: Ellipsoid,
    ) -> Georeference:
        return Georeference(
            body=self.label.text("TARGET_NAME").title(),
            ellipsoid=ellipsoid,
            projection=projection,
            first_x=first_x,
            first_y=first_y,
            step_x=step_x,
            step_y=step_y,
            vertical_reference=self.values.reference,
            vertical_unit=self.values.unit,
            latitude_kind=self._latitude_kind(),
        )

    def _degrees(self, field: str) -> float:
        return self.label.number(MAP, field, units=DEGREES)

    def _positive(self, field: str, units: Units) -> float:
        number = self.label.number(MAP, field, units=units)
        if number <= 0.0:
            raise self.label.wrong(field, number, "a number above 0", "Mend the label.")
        return number

    def _optional(self, field: str, units: Units | None) -> float | None:
        """A number that may be missing, or be the text N/A."""
        value = self.label.value(MAP, field, default=None)
        if value is None or isinstance(value, str):
            return None
        return self.label.number(MAP, field, units=units)
