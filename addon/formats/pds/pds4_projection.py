"""Where on its body a PDS4 array lies: the classes of the cartography dictionary (``cart``).

Source: "PDS4 Cartography Discipline Dictionary User's Guide" (PDS Cartography and Imaging Sciences Node): the
upper left corner is the outer corner of the first pixel, in metres from the projection's origin.
"""

from __future__ import annotations

import math
from xml.etree.ElementTree import Element

from ..body.ellipsoid import Ellipsoid
from ..georeference import Georeference, LatitudeKind, step_once_around
from ..projections import Geographic, Projection
from .label import Units
from .pds4_label import Pds4Label
from .planet_maps import named_projection, polar_stereographic

METRES: Units = {"m": 1.0, "km": 1000.0}
DEGREES: Units = {"deg": 1.0, "degree": 1.0, "degrees": 1.0}

METRES_PER_PIXEL: Units = {"m/pixel": 1.0, "m/pix": 1.0, "km/pixel": 1000.0, "km/pix": 1000.0}
PIXELS_PER_DEGREE: Units = {"pixel/deg": 1.0, "pix/deg": 1.0, "pixels/degree": 1.0, "pixel/degree": 1.0}

RESOLUTIONS = ("pixel_resolution", "pixel_scale")
"""Which is metres and which is pixels a degree was exchanged between versions: the units decide."""

SCALE_FACTORS = ("scale_factor_at_projection_origin", "scale_factor_at_central_meridian")
"""Names of one number, of the classes of different projections."""

CYLINDRICAL = ("EQUIRECTANGULAR", "SIMPLE CYLINDRICAL", "EQUIDISTANT CYLINDRICAL")

Found = tuple[Georeference, tuple[str, ...]]


def pds4_georeference(label: Pds4Label, rows: int, columns: int, reference: str) -> Found:
    """Build the geometry; and what a person should know of it."""
    place = _Place(label, rows, columns, reference)
    direction = label.text("longitude_direction", default="Positive East")
    if direction.lower() != "positive east":
        raise label.wrong(
            "longitude_direction",
            direction,
            "Positive East",
            "Maps with longitudes to the west are not read yet.",
        )
    name = label.text("map_projection_name", default="").replace("_", " ").upper()
    if not name or name in CYLINDRICAL:
        return place.cylindrical()
    if name == "POLAR STEREOGRAPHIC":
        return place.polar()
    return place.in_metres(name)


class _Place:
    """The cartography classes of one label, for an array of so many rows and columns."""

    def __init__(self, label: Pds4Label, rows: int, columns: int, reference: str) -> None:
        self.label = label
        self.rows = rows
        self.columns = columns
        self.reference = reference

    def cylindrical(self) -> Found:
        """Evenly spaced in degrees: from the upper left corner where it is stated, else from the bounds."""
        ellipsoid = self._ellipsoid()
        middle = self._degrees("longitude_of_central_meridian") or 0.0
        true_scale = self._degrees("standard_parallel_1") or 0.0
        if not abs(true_scale) < 90.0:
            raise self.label.wrong(
                "standard_parallel_1", f"{true_scale:g}", "a latitude within +-90", "Mend the label."
            )
        corner = self._corner()
        metres = self._resolution("x", METRES_PER_PIXEL), self._resolution("y", METRES_PER_PIXEL)
        if corner is None or None in metres:
            return self._from_bounds(ellipsoid)
        degree = math.radians(1.0) * ellipsoid.semi_major
        shrunk = degree * math.cos(math.radians(true_scale))
        step_x, step_y = (metres[0] or 0.0) / shrunk, (metres[1] or 0.0) / degree
        west = middle + corner[0] / shrunk
        step_x = step_once_around(step_x, self.columns)  # which a rounded scale misses
        origin = self._degrees("latitude_of_projection_origin") or 0.0
        north = origin + corner[1] / degree
        return self._in_degrees(west, north, step_x, step_y, ellipsoid), ()

    def _from_bounds(self, ellipsoid: Ellipsoid) -> Found:
        """Rows and columns share the bounding coordinates evenly."""
        west, east = self._bound("west"), self._bound("east")
        south, north = self._bound("south"), self._bound("north")
        if east <= west:
            east += 360.0
        if not (0.0 < east - west <= 360.0):
            raise self.label.wrong(
                "west_bounding_coordinate and east_bounding_coordinate",
                f"{west:g} and {east:g}",
                "at most 360 degrees",
                "Mend the label.",
            )
        if not (-90.0 <= south < north <= 90.0):
            raise self.label.wrong(
                "south_bounding_coordinate and north_bounding_coordinate",
                f"{south:g} and {north:g}",
                "south < north within +-90",
                "Mend the label.",
            )
        step_x, step_y = (east - west) / self.columns, (north - south) / self.rows
        return self._in_degrees(west, north, step_x, step_y, ellipsoid), ()

    def _in_degrees(
        self, west: float, north: float, step_x: float, step_y: float, ellipsoid: Ellipsoid
    ) -> Georeference:
        south = north - self.rows * step_y
        if not (north < 90.0 + step_y and south > -90.0 - step_y):
            raise self.label.wrong(
                "upperleft_corner_y",
                f"latitudes of {south:g} to {north:g}",
                "latitudes within +-90",
                "Mend the label.",
            )
        return self._georeference(
            Geographic(), west + step_x / 2.0, north - step_y / 2.0, step_x, step_y, ellipsoid
        )

    def polar(self) -> Found:
        """Around a pole, in metres."""
        # GDAL states the latitude of true scale for the origin: its side is the pole.
        stated = self._degrees("latitude_of_projection_origin")
        pole = math.copysign(90.0, self._bound("south") if stated is None else stated)
        middle = (
            self._degrees("straight_vertical_longitude_from_pole")
            or self._degrees("longitude_of_central_meridian")
            or 0.0
        )
        true_scale = self._degrees("standard_parallel_1")
        if true_scale is None and stated is not None and abs(stated) < 90.0:
            true_scale = stated
        projection = polar_stereographic(pole, middle, true_scale, self._scale_factor())
        radius = self._radius("c_axis_radius", "polar_radius") or self._radius_or_error()
        return self._projected(projection, (), Ellipsoid.sphere(radius))

    def in_metres(self, name: str) -> Found:
        """About a centre; where the projection is not known here touch is right all the same."""
        projection, notes = named_projection(
            name,
            self._degrees("longitude_of_central_meridian") or 0.0,
            self._degrees("latitude_of_projection_origin") or 0.0,
            (self._degrees("standard_parallel_1"), self._degrees("standard_parallel_2")),
            self._scale_factor(),
        )
        return self._projected(projection, notes, self._ellipsoid())

    def _projected(self, projection: Projection, notes: tuple[str, ...], ellipsoid: Ellipsoid) -> Found:
        step_x = self._resolution("x", METRES_PER_PIXEL)
        step_y = self._resolution("y", METRES_PER_PIXEL) or step_x
        if step_x is None or step_y is None:
            degrees = self._resolution("x", PIXELS_PER_DEGREE)
            if degrees is None:
                raise self.label.wrong(
                    "pixel_resolution_x", "nothing", "metres a pixel", "Choose another label."
                )
            step_x = step_y = math.radians(1.0) * ellipsoid.semi_major / degrees
        corner = self._corner()
        if corner is None:
            corner = -self.columns * step_x / 2.0, self.rows * step_y / 2.0
            notes = (*notes, "The label does not say where the map's origin is: its middle is assumed.")
        return (
            self._georeference(
                projection, corner[0] + step_x / 2.0, corner[1] - step_y / 2.0, step_x, step_y, ellipsoid
            ),
            notes,
        )

    def _corner(self) -> tuple[float, float] | None:
        x = self.label.optional_number("upperleft_corner_x", units=METRES)
        y = self.label.optional_number("upperleft_corner_y", units=METRES)
        return None if x is None or y is None else (x, y)

    def _resolution(self, axis: str, units: Units) -> float | None:
        """What is written in these units, under either name."""
        for name in RESOLUTIONS:
            for element in self.label.all(f"{name}_{axis}"):
                if self._unit(element) in units:
                    number = self.label.element_number(element, units)
                    if number <= 0.0:
                        raise self.label.wrong(
                            f"{name}_{axis}", f"{number:g}", "a number above 0", "Mend the label."
                        )
                    return number
        return None

    @staticmethod
    def _unit(element: Element) -> str:
        return element.get("unit", "").lower().replace(" ", "")

    def _bound(self, side: str) -> float:
        return self.label.number(f"{side}_bounding_coordinate", units=DEGREES)

    def _degrees(self, name: str) -> float | None:
        return self.label.optional_number(name, units=DEGREES)

    def _scale_factor(self) -> float:
        """Of the whole map, 1 where none is stated."""
        return self._above_0(*SCALE_FACTORS) or 1.0

    def _radius(self, *names: str) -> float | None:
        return self._above_0(*names, units=METRES)

    def _above_0(self, *names: str, units: Units | None = None) -> float | None:
        number = self.label.optional_number(*names, units=units)
        if number is not None and number <= 0.0:
            raise self.label.wrong(names[0], f"{number:g}", "a number above 0", "Mend the label.")
        return number

    def _radius_or_error(self) -> float:
        radius = self._radius("a_axis_radius", "semi_major_radius")
        if radius is None:
            raise self.label.wrong(
                "a_axis_radius", "nothing", "the body's radius", "Choose the label of an elevation grid."
            )
        return radius

    def _ellipsoid(self) -> Ellipsoid:
        """A sphere of the equatorial radius; an ellipsoid only where latitudes refer to one."""
        radius = self._radius_or_error()
        polar = self._radius("c_axis_radius", "polar_radius")
        if self._latitude_kind() == "planetographic" and polar is not None and 0.5 * radius < polar <= radius:
            return Ellipsoid(radius, polar)
        return Ellipsoid.sphere(radius)

    def _latitude_kind(self) -> LatitudeKind:
        told = self.label.text("latitude_type", default="Planetocentric").upper()
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
        target = self.label.first("Target_Identification")
        return Georeference(
            body="" if target is None else self.label.text("name", within=target, default="").title(),
            ellipsoid=ellipsoid,
            projection=projection,
            first_x=first_x,
            first_y=first_y,
            step_x=step_x,
            step_y=step_y,
            vertical_reference=self.reference,
            latitude_kind=self._latitude_kind(),
        )
