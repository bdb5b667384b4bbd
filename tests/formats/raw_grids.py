"""Small raw grids for tests, with the headers of EHdr, GridFloat, ENVI and PDS4."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from struct import pack

from tests.formats.megdr_pair import rough

Rows = Sequence[Sequence[float]]


def packed(heights: Rows, sample: str = ">h") -> bytes:
    """The samples, row by row, in a format of ``struct``."""
    letter = sample[-1]
    return b"".join(
        pack(sample, float(height) if letter in "fd" else int(height)) for row in heights for height in row
    )


@dataclass
class EhdrPair:
    """``grid.HDR`` and ``grid.DEM``, right by default as GTOPO30 writes them; tests spoil one thing each."""

    heights: Rows = field(default_factory=lambda: rough(4, 6))
    words: Mapping[str, object] = field(default_factory=dict)
    """Keywords to change; ``None`` leaves one out."""
    sample: str = ">h"
    name: str = "grid"
    suffixes: tuple[str, str] = (".HDR", ".DEM")
    line_end: str = "\r\n"
    data: bytes | None = None

    def header(self) -> str:
        """The header's text."""
        columns, size = len(self.heights[0]), len(pack(self.sample, 0))
        words = {
            "BYTEORDER": "M",
            "LAYOUT": "BIL",
            "NROWS": len(self.heights),
            "NCOLS": columns,
            "NBANDS": 1,
            "NBITS": 8 * size,
            "BANDROWBYTES": columns * size,
            "TOTALROWBYTES": columns * size,
            "BANDGAPBYTES": 0,
            "NODATA": -9999,
            "ULXMAP": 10.25,
            "ULYMAP": 49.75,
            "XDIM": 0.5,
            "YDIM": 0.5,
            **self.words,
        }
        lines = [f"{word:14}{value}" for word, value in words.items() if value is not None]
        return self.line_end.join([*lines, ""])

    def write(self, folder: Path) -> Path:
        """Write both files; gives the header's path."""
        header = folder / f"{self.name}{self.suffixes[0]}"
        header.write_text(self.header(), encoding="ascii", newline="")
        data = packed(self.heights, self.sample) if self.data is None else self.data
        (folder / f"{self.name}{self.suffixes[1]}").write_bytes(data)
        return header


@dataclass
class GridFloatPair:
    """``grid.hdr`` and ``grid.flt``."""

    heights: Rows = field(default_factory=lambda: [[1.5, -2.25, 3.0], [700.125, -9999.0, 6.5]])
    words: Mapping[str, object] = field(default_factory=dict)
    sample: str = "<f"
    name: str = "grid"

    def header(self) -> str:
        """The header's text."""
        words = {
            "ncols": len(self.heights[0]),
            "nrows": len(self.heights),
            "xllcorner": -120.0,
            "yllcorner": 40.0,
            "cellsize": 0.25,
            "NODATA_value": -9999,
            "byteorder": "LSBFIRST",
            **self.words,
        }
        return "\n".join([*(f"{word} {value}" for word, value in words.items() if value is not None), ""])

    def write(self, folder: Path) -> Path:
        """Write both files; gives the header's path."""
        header = folder / f"{self.name}.hdr"
        header.write_text(self.header(), encoding="ascii")
        header.with_suffix(".flt").write_bytes(packed(self.heights, self.sample))
        return header


@dataclass
class EnviPair:
    """``grid.hdr`` and ``grid`` (or ``grid.dat`` ...)."""

    heights: Rows = field(default_factory=lambda: [[1.5, -2.25, 3.0], [700.125, -9999.0, 6.5]])
    words: Mapping[str, object] = field(default_factory=dict)
    sample: str = "<f"
    names: tuple[str, str] = ("grid.hdr", "grid")
    data: bytes | None = None

    def header(self) -> str:
        """The header's text."""
        words = {
            "description": "{\n  A grid = for tests,\n  of two lines}",
            "samples": len(self.heights[0]),
            "lines": len(self.heights),
            "bands": 1,
            "header offset": 0,
            "file type": "ENVI Standard",
            "data type": {"h": 2, "i": 3, "f": 4, "d": 5, "H": 12, "B": 1, "I": 13}[self.sample[-1]],
            "interleave": "bsq",
            "byte order": int(self.sample[0] == ">"),
            "map info": "{Geographic Lat/Lon, 1.0, 1.0, 10.0, 50.0, 0.5, 0.25, WGS-84, units=Degrees}",
            "data ignore value": -9999,
            **self.words,
        }
        pairs = [f"{word} = {value}" for word, value in words.items() if value is not None]
        return "\n".join(["ENVI", *pairs, ""])

    def write(self, folder: Path) -> Path:
        """Write both files; gives the header's path."""
        header = folder / self.names[0]
        header.write_text(self.header(), encoding="ascii")
        data = packed(self.heights, self.sample) if self.data is None else self.data
        (folder / self.names[1]).write_bytes(data)
        return header


EQUIRECTANGULAR = """<cart:map_projection_name>Equirectangular</cart:map_projection_name>
<cart:Equirectangular><cart:standard_parallel_1 unit="deg">60</cart:standard_parallel_1>
<cart:longitude_of_central_meridian unit="deg">180</cart:longitude_of_central_meridian>
</cart:Equirectangular>"""

POLAR = """<cart:map_projection_name>Polar Stereographic</cart:map_projection_name>
<cart:Polar_Stereographic>
<cart:straight_vertical_longitude_from_pole unit="deg">0</cart:straight_vertical_longitude_from_pole>
<cart:latitude_of_projection_origin unit="deg">-90</cart:latitude_of_projection_origin>
</cart:Polar_Stereographic>"""


@dataclass
class Pds4Pair:
    """``grid.xml`` and ``grid.img``: 2 x 3 samples, bounded by 10 to 13 E and 4 to 6 N."""

    heights: Rows = field(default_factory=lambda: [[10, -20, 30], [40, -32768, 60]])
    sample: str = ">h"
    data_type: str = "SignedMSB2"
    projection: str = "<cart:map_projection_name>Simple Cylindrical</cart:map_projection_name>"
    resolution: str = '<cart:pixel_resolution_x unit="deg/pixel">1</cart:pixel_resolution_x>'
    corner: str = ""
    element: str = "<unit>m</unit>"
    constants: str = "<missing_constant>-32768</missing_constant>"
    axes: str = ""
    file_name: str = "grid.img"
    head: str = '<?xml version="1.0" encoding="UTF-8"?>'
    direction: str = "Positive East"
    array: str = "Array_2D_Image"
    before: bytes = b""
    rest: str = ""

    def label(self) -> str:
        """The label's text."""
        axes = self.axes or "".join(
            f"<Axis_Array><axis_name>{name}</axis_name><elements>{count}</elements>"
            f"<sequence_number>{number}</sequence_number></Axis_Array>"
            for number, (name, count) in enumerate(
                (("Line", len(self.heights)), ("Sample", len(self.heights[0]))), start=1
            )
        )
        bounds = "".join(
            f'<cart:{side}_bounding_coordinate unit="deg">{value}</cart:{side}_bounding_coordinate>'
            for side, value in (("west", 10), ("east", 13), ("north", 6), ("south", 4))
        )
        return f"""{self.head}
<Product_Observational xmlns="http://pds.nasa.gov/pds4/pds/v1" xmlns:cart="http://pds.nasa.gov/pds4/cart/v1">
<Identification_Area><title>Test</title></Identification_Area>
<Observation_Area><Target_Identification><name>MOON</name></Target_Identification>
<Discipline_Area><cart:Cartography>
<cart:Bounding_Coordinates>{bounds}</cart:Bounding_Coordinates>
<cart:Map_Projection>{self.projection}</cart:Map_Projection>
<cart:Coordinate_Representation>{self.resolution}</cart:Coordinate_Representation>
<cart:Geo_Transformation>{self.corner}</cart:Geo_Transformation>
<cart:Geodetic_Model><cart:latitude_type>Planetocentric</cart:latitude_type>
<cart:a_axis_radius unit="km">1737.4</cart:a_axis_radius>
<cart:c_axis_radius unit="km">1737.4</cart:c_axis_radius>
<cart:longitude_direction>{self.direction}</cart:longitude_direction></cart:Geodetic_Model>
</cart:Cartography></Discipline_Area></Observation_Area>
<File_Area_Observational><File><file_name>{self.file_name}</file_name></File>
<{self.array}><offset unit="byte">{len(self.before)}</offset><axes>2</axes>
<axis_index_order>Last Index Fastest</axis_index_order>
<Element_Array><data_type>{self.data_type}</data_type>{self.element}</Element_Array>
{axes}<Special_Constants>{self.constants}</Special_Constants></{self.array}>{self.rest}
</File_Area_Observational></Product_Observational>"""

    def write(self, folder: Path) -> Path:
        """Write both files; gives the label's path."""
        label = folder / "grid.xml"
        label.write_text(self.label(), encoding="utf-8")
        (folder / "grid.img").write_bytes(self.before + packed(self.heights, self.sample))
        return label
