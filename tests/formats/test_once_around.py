"""A whole planet has no edge at its seam, though its header has few digits."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from addon.formats import read_grid
from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.georeference import Georeference, step_once_around
from addon.formats.projections import Equirectangular, Mercator, Projection, Unknown
from tests.formats.raw_grids import EhdrPair, EnviPair, GridFloatPair
from tests.formats.tiff_file import DOUBLE, TiffFile

COLUMNS = 4320
HEIGHTS = [[column % 100 for column in range(COLUMNS)]] * 2


def ehdr(folder: Path, step: str) -> Path:
    words = {"XDIM": step, "YDIM": step, "ULXMAP": -179.95833, "ULYMAP": 50}
    return EhdrPair(HEIGHTS, words=words).write(folder)


def gridfloat(folder: Path, step: str) -> Path:
    return GridFloatPair(HEIGHTS, words={"cellsize": step, "xllcorner": -180}).write(folder)


def envi(folder: Path, step: str) -> Path:
    words = {"map info": f"{{Geographic Lat/Lon, 1, 1, -180, 50, {step}, {step}, WGS-84, units=Degrees}}"}
    return EnviPair(HEIGHTS, words=words).write(folder)


def esri_ascii(folder: Path, step: str) -> Path:
    header = f"ncols {COLUMNS}\nnrows 2\nxllcorner -180\nyllcorner 40\ncellsize {step}\n"
    rows = "\n".join(" ".join(map(str, row)) for row in HEIGHTS)
    path = folder / "grid.asc"
    path.write_text(f"{header}{rows}\n", encoding="ascii")
    return path


def geotiff(folder: Path, step: str) -> Path:
    tags = {
        33550: (DOUBLE, [float(step), float(step), 0.0]),
        33922: (DOUBLE, [0.0, 0.0, 0.0, -180.0, 50.0, 0.0]),
    }
    return TiffFile(HEIGHTS, tags=tags).write(folder)


FORMATS = [ehdr, gridfloat, envi, esri_ascii, geotiff]


@pytest.mark.parametrize("write", FORMATS)
@pytest.mark.parametrize("step", ["0.0833333", "0.08333333", "0.083333333333333", "0.0833334"])
def test_a_twelfth_of_a_degree_goes_once_around(
    tmp_path: Path, write: Callable[[Path, str], Path], step: str
) -> None:
    grid = read_grid(write(tmp_path, step))
    assert grid.layout.wraps
    assert grid.georeference.step_x == 360.0 / COLUMNS


@pytest.mark.parametrize("write", FORMATS)
@pytest.mark.parametrize("step", ["0.0833", "0.083", "0.0834"])
def test_a_gap_of_half_a_cell_remains_one(
    tmp_path: Path, write: Callable[[Path, str], Path], step: str
) -> None:
    grid = read_grid(write(tmp_path, step))
    assert not grid.layout.wraps
    assert grid.georeference.step_x == float(step)


def test_a_map_of_points_whose_last_column_is_the_first_again_has_edges() -> None:
    assert step_once_around(1.0, 361) == 1.0


def test_steps_in_metres_stay() -> None:
    sphere = Ellipsoid.sphere(1e6)
    place = Georeference("", sphere, Unknown(), 0.0, 0.0, 0.9999, 1.0, "")
    assert place.closed(360) == place


@pytest.mark.parametrize("projection", [Mercator(), Equirectangular(standard_parallel_1=30.0)])
def test_a_map_in_metres_that_goes_once_around_has_no_edge_either(projection: Projection) -> None:
    body = Ellipsoid.sphere(3_396_190.0)
    turn = projection.turn(body)
    assert turn is not None
    place = Georeference(
        body="Mars",
        ellipsoid=body,
        projection=projection,
        first_x=-turn / 2.0,
        first_y=0.0,
        step_x=round(turn / 720.0, 2),
        step_y=1000.0,
        vertical_reference="sphere",
    )
    assert place.closed(720).spans_the_globe(720)
    assert place.closed(700).step_x == place.step_x
    assert not place.closed(700).spans_the_globe(700)
