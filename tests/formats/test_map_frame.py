"""What ``.prj`` files beside rasters mean for their coordinates and heights."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import read_grid
from tests.formats.raw_grids import EhdrPair, EnviPair, GridFloatPair
from tests.formats.reading import SHARED, heights, needs

GTOPO30 = """Projection    GEOGRAPHIC
Datum         WGS84
Zunits        METERS
Units         DD
Spheroid      WGS84
Xshift        0.0000000000
Yshift        0.0000000000
Parameters
"""

UTM = """Projection    UTM
Zone          10
Datum         NAD83
Zunits        METERS
Units         METERS
Parameters
"""

MOON = (
    'GEOGCS["GCS_Moon_2000",DATUM["D_Moon_2000",SPHEROID["Moon_2000_IAU_IAG",1737400.0,0.0]],'
    'PRIMEM["Reference_Meridian",0.0],UNIT["Degree",0.0174532925199433]]'
)


def test_keywords_of_a_geographic_tile(tmp_path: Path) -> None:
    header = EhdrPair().write(tmp_path)
    (tmp_path / "grid.PRJ").write_bytes(GTOPO30.replace("\n", "\r\n").encode())
    grid = read_grid(header)
    assert grid.notes == ()
    assert grid.georeference.frame == "WGS 84, longitude and latitude"
    assert grid.georeference.longitude_latitude(0, 0) == (10.25, 49.75)


def test_seconds_of_arc_are_made_degrees(tmp_path: Path) -> None:
    words = {"ULXMAP": 36_900, "ULYMAP": 179_100, "XDIM": 1800, "YDIM": 1800}
    header = EhdrPair(words=words).write(tmp_path)
    (tmp_path / "grid.prj").write_text(GTOPO30.replace("DD", "DS"))
    place = read_grid(header).georeference
    assert (place.x(0), place.y(0), place.step_x) == pytest.approx((10.25, 49.75, 0.5))


def test_heights_in_feet_are_made_metres(tmp_path: Path) -> None:
    header = EhdrPair([[100, -9999], [2, 3]]).write(tmp_path)
    (tmp_path / "grid.prj").write_text(GTOPO30.replace("METERS", "FEET"))
    assert heights(read_grid(header))[0] == [pytest.approx(30.48), None]


def test_a_zone_of_utm(tmp_path: Path) -> None:
    words = {"xllcorner": 499_985, "yllcorner": 4_599_985, "cellsize": 30}
    header = GridFloatPair(words=words).write(tmp_path)
    (tmp_path / "grid.prj").write_text(UTM)
    grid = read_grid(header)
    found = grid.georeference.longitude_latitude(0, 1)
    assert found is not None
    assert found == pytest.approx((237.0, 41.552), abs=1e-3)
    assert grid.layout.cell_width == 30.0


@pytest.mark.parametrize("kind", ["prj", "coordinate system string"])
def test_the_moon_is_no_earth(tmp_path: Path, kind: str) -> None:
    if kind == "prj":
        header = EhdrPair().write(tmp_path)
        (tmp_path / "grid.prj").write_text(MOON)
    else:
        header = EnviPair(words={kind: f"{{{MOON}}}"}).write(tmp_path)
    place = read_grid(header).georeference
    assert (place.body, place.ellipsoid.semi_major) == ("Moon", 1_737_400.0)
    assert place.vertical_reference == "not stated"


@pytest.mark.parametrize("text", ["", "nonsense", "GEOGCS[", "\0\1\2", "Projection"])
def test_what_is_not_understood_is_told(tmp_path: Path, text: str) -> None:
    header = EhdrPair().write(tmp_path)
    (tmp_path / "grid.prj").write_text(text)
    grid = read_grid(header)
    assert "grid.prj is not understood" in " ".join(grid.notes)
    assert grid.georeference.longitude_latitude(0, 0) == (10.25, 49.75)


@needs("gtopo30/W002N52.PRJ")
def test_the_real_tile_states_its_datum() -> None:
    place = read_grid(SHARED / "gtopo30" / "W002N52.HDR").georeference
    assert place.frame == "WGS84"
    assert place.ellipsoid.semi_major == 6_378_137.0
