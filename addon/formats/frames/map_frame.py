"""What a map's coordinates mean: from a ``.prj`` file beside the data, or assumed where there is none."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from ..body.datums import WGS84
from ..body.ellipsoid import Ellipsoid
from ..file_bytes import read_head
from ..georeference import Georeference, LatitudeKind, Registration
from ..projections import Geographic, Projection, Unknown
from ..raw.data_beside import first_beside
from ..raw.stored_samples import StoredSamples
from ..refusal import Refuse
from .map_place import check_place
from .stated_frame import stated_frame

EARTH_HEIGHTS = "mean sea level"

MAXIMUM_BYTES = 64 << 10
"""Of a ``.prj`` file; they have some 500."""


@dataclass(frozen=True)
class MapFrame:
    """Body, projection and datum of a map."""

    body: str
    ellipsoid: Ellipsoid
    projection: Projection
    frame: str = ""
    vertical_reference: str = EARTH_HEIGHTS
    latitude_kind: LatitudeKind = "planetographic"
    unit: float = 1.0
    """Degrees or metres for one of the map's own units."""
    shift_x: float = 0.0
    """Degrees east of Greenwich that longitudes are counted from."""
    vertical_unit: float = 1.0
    """Metres for one unit of height."""
    notes: tuple[str, ...] = ()

    def georeference(
        self,
        first_x: float,
        first_y: float,
        step_x: float,
        step_y: float,
        registration: Registration,
        refuse: Refuse,
        size: tuple[int, int],
    ) -> Georeference:
        """The place of a grid on this map, its numbers in the map's own units; refuses what is on no body.

        Args:
            size: columns and rows.
        """
        columns, rows = size
        first_x, first_y = first_x * self.unit + self.shift_x, first_y * self.unit
        step_x, step_y = step_x * self.unit, step_y * self.unit
        georeference = Georeference(
            body=self.body,
            ellipsoid=self.ellipsoid,
            projection=self.projection,
            first_x=first_x,
            first_y=first_y,
            step_x=step_x,
            step_y=step_y,
            vertical_reference=self.vertical_reference,
            vertical_unit="m" if self.vertical_unit == 1.0 else f"{self.vertical_unit:g} m",
            latitude_kind=self.latitude_kind,
            registration=registration,
            frame=self.frame,
        )
        check_place(georeference, rows, columns, refuse)
        return georeference.closed(columns)

    def in_metres(self, samples: StoredSamples) -> StoredSamples:
        """The same samples, their heights in the unit that this map states."""
        return replace(
            samples,
            scale=samples.scale * self.vertical_unit,
            value_offset=samples.value_offset * self.vertical_unit,
        )


GEOGRAPHIC_WGS84 = MapFrame("Earth", WGS84, Geographic(), "WGS 84, longitude and latitude")


def frame_beside(
    data_path: Path, first: tuple[float, float], step: tuple[float, float], size: tuple[int, int]
) -> MapFrame:
    """Follow the ``.prj`` file beside the data; where there is none, see whether these may be degrees.

    Args:
        first: of the north-west sample, step: to the next east and south, as the header has them.
        size: columns and rows.
    """
    beside = first_beside(data_path, [".prj"])
    if beside is not None:
        frame = frame_of_text(read_head(beside, MAXIMUM_BYTES).decode("latin-1"))
        if frame is not None:
            return frame
    told = f"{beside.name} is not understood" if beside is not None else "There is no .prj file"
    return assumed_frame(told, first, step, size)


def frame_of_text(text: str) -> MapFrame | None:
    """The frame that a ``.prj`` file or a coordinate system string states; ``None``: not understood."""
    stated = stated_frame(text)
    if stated is None:
        return None
    return MapFrame(
        stated.body,
        stated.ellipsoid,
        stated.projection,
        stated.name,
        vertical_reference=EARTH_HEIGHTS if stated.body == "Earth" else "not stated",
        unit=stated.unit,
        shift_x=stated.shift_x,
        vertical_unit=stated.vertical_unit,
        notes=stated.notes,
    )


def assumed_frame(
    told: str, first: tuple[float, float], step: tuple[float, float], size: tuple[int, int]
) -> MapFrame:
    """Degrees on Earth where the numbers may be degrees; else metres of an unknown map.

    Args:
        told: why something has to be assumed. The others are as of ``frame_beside``.
    """
    (first_x, first_y), (step_x, step_y), (columns, rows) = first, step, size
    may_be_degrees = (
        abs(first_y) <= 90.5
        and abs(first_y - (rows - 1) * step_y) <= 90.5
        and abs(first_x) <= 360.5
        and abs(first_x + columns * step_x) <= 721.0
        and step_x < 10.0
    )
    if may_be_degrees:
        note = f"{told}: longitude and latitude on WGS 84 are assumed."
        return MapFrame("Earth", WGS84, Geographic(), "WGS 84 (assumed)", notes=(note,))
    note = f"{told}: coordinates are taken for metres of an unknown map."
    return MapFrame("", WGS84, Unknown(), vertical_reference="not stated", notes=(note,))
