"""Where on its body a PDS3 image lies: the IMAGE_MAP_PROJECTION object.

Source: "Planetary Science Data Dictionary" (JPL D-7116) for the keywords; DSMAP.CAT and DSMAP_POLAR.CAT of
the data sets MGS-M-MOLA-5-MEGDR-L3-V1.0 and LRO-L-LOLA-4-GDR-V1.0 for what their teams mean by them.
"""

from __future__ import annotations

import math

from ..body.ellipsoid import Ellipsoid
from ..georeference import Georeference, step_once_around
from ..projections import Geographic, Projection
from .label import Label
from .pds3_map import DEGREES, MAP, PIXELS_PER_DEGREE, Pds3Map
from .pds3_values import KILOMETRES, Pds3Values
from .planet_maps import named_projection, polar_stereographic

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
    place = _Place(Pds3Map(label, rows, columns), values)
    georeference, notes = place.of(projection)
    return georeference, (*notes, *place.rotation_notes())


class _Place:
    """The georeference of one map, by each road that leads there."""

    def __init__(self, place_map: Pds3Map, values: Pds3Values) -> None:
        self.map = place_map
        self.values = values

    def of(self, projection: str) -> Found:
        """By the projection's name, in capitals, words apart."""
        if projection == "SIMPLE CYLINDRICAL":
            return self.from_limits()
        if projection.startswith("EQUIRECTANGULAR"):
            return self.from_offsets_in_degrees() if self.map.has_offsets else self.from_limits()
        if projection == "POLAR STEREOGRAPHIC":
            return self.polar()
        return self.in_metres(projection)

    def rotation_notes(self) -> tuple[str, ...]:
        """What is told of a turned map: archives hardly have one, and which way it turns is not agreed."""
        rotation = self.map.optional("MAP_PROJECTION_ROTATION", DEGREES)
        if not rotation:
            return ()
        return (f"The label states a map turned by {rotation:g} degrees, which is not applied to places.",)

    def from_limits(self) -> Found:
        """Longitude and latitude from MAP_RESOLUTION and the limits (MAP_SCALE is rounded)."""
        west, east, south, north = self.map.limits()
        resolution = self.map.positive("MAP_RESOLUTION", PIXELS_PER_DEGREE)
        for field, count, degrees in (
            ("LINE_SAMPLES", self.map.columns, (east - west) * resolution),
            ("LINES", self.map.rows, (north - south) * resolution),
        ):
            if abs(count - degrees) > 0.5:
                raise self.map.label.wrong(
                    field,
                    count,
                    f"{degrees:g} from MAP_RESOLUTION and the limits",
                    "Mend whichever of them is wrong.",
                )
        step = 1.0 / resolution
        return self._georeference(
            Geographic(), west + step / 2.0, north - step / 2.0, step, step, self.map.ellipsoid()
        ), ()

    def from_offsets_in_degrees(self) -> Found:
        """Equirectangular maps: rows and columns are evenly spaced in degrees too, so degrees are given.

        CENTER_LATITUDE is true to scale; the origin is where CENTER_LONGITUDE crosses the equator.
        """
        ellipsoid = self.map.ellipsoid()
        step_y = self.map.step() / math.radians(1.0) / ellipsoid.semi_major
        true_scale = self.map.optional("CENTER_LATITUDE", DEGREES) or 0.0
        shrinking = math.cos(math.radians(true_scale))
        if not abs(true_scale) < 90.0:
            raise self.map.label.wrong(
                "CENTER_LATITUDE", true_scale, "a latitude within +-90", "Mend the label."
            )
        step_x = step_y / shrinking
        step_x = step_once_around(step_x, self.map.columns)  # which a rounded scale misses
        line, sample = self.map.origin()
        middle = self.map.optional("CENTER_LONGITUDE", DEGREES) or 0.0
        first_x, first_y = middle - sample * step_x, line * step_y
        last_y = first_y - (self.map.rows - 1) * step_y
        if not (last_y > -90.0 - step_y and first_y < 90.0 + step_y):
            raise self.map.label.wrong(
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
        latitude = self.map.pole()
        middle = self.map.optional("CENTER_LONGITUDE", DEGREES) or 0.0
        # Both teams compute on a sphere; of an ellipsoid the polar radius is the one that fits a pole.
        radius = self.map.optional("C_AXIS_RADIUS", KILOMETRES) or self.map.positive(
            "A_AXIS_RADIUS", KILOMETRES
        )
        if radius <= 0.0:
            raise self.map.label.wrong("C_AXIS_RADIUS", radius, "a number above 0", "Mend the label.")
        step = self.map.step(radius)
        line, sample = self.map.origin()
        projection, sphere = polar_stereographic(latitude, middle), Ellipsoid.sphere(radius)
        return self._georeference(projection, -sample * step, line * step, step, step, sphere), ()

    def in_metres(self, name: str) -> Found:
        """Maps about a centre; where the projection is not known here touch is right all the same."""
        ellipsoid, step = self.map.ellipsoid(), self.map.step()
        projection, notes = named_projection(
            name,
            self.map.optional("CENTER_LONGITUDE", DEGREES) or 0.0,
            self.map.optional("CENTER_LATITUDE", DEGREES) or 0.0,
            (
                self.map.optional("FIRST_STANDARD_PARALLEL", DEGREES),
                self.map.optional("SECOND_STANDARD_PARALLEL", DEGREES),
            ),
        )
        line, sample = self.map.origin()
        if not self.map.has_offsets:
            notes = (*notes, "The label does not say where the map's origin is: its middle is assumed.")
        return self._georeference(projection, -sample * step, line * step, step, step, ellipsoid), notes

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
            body=self.map.label.text("TARGET_NAME").title(),
            ellipsoid=ellipsoid,
            projection=projection,
            first_x=first_x,
            first_y=first_y,
            step_x=step_x,
            step_y=step_y,
            vertical_reference=self.values.reference,
            vertical_unit=self.values.unit,
            latitude_kind=self.map.latitude_kind(),
            frame=self.map.label.text(MAP, "COORDINATE_SYSTEM_NAME", default=""),
        )
