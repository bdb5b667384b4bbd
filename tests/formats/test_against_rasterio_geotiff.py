"""Files that GDAL writes: every sample as rasterio reads it.

rasterio is no dependency: where it is not installed, these tests are skipped.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import pytest
from proxygraph import GeoTiff, Grid, GridLayout

from addon.formats import ElevationGrid
from addon.formats.geotiff.geotiff_reader import read_geotiff

numpy = pytest.importorskip("numpy", reason="numpy is not installed")
rasterio = pytest.importorskip("rasterio", reason="rasterio is not installed")
pytest.importorskip("rasterio.warp", reason="rasterio is not installed")

ROWS, COLUMNS = 83, 117
"""Whole in no tile and no strip."""

TYPES = ("uint8", "int8", "int16", "uint16", "int32", "uint32", "float32", "float64")
CHUNKS: dict[str, dict[str, Any]] = {
    "strips": {"blockysize": 7},
    "one strip": {"blockysize": ROWS},
    "tiles": {"tiled": True, "blockxsize": 32, "blockysize": 16},
}
PACKINGS = [("NONE", 1), ("PACKBITS", 1), *itertools.product(("LZW", "DEFLATE"), (1, 2, 3))]


def heights(sample: str, bands: int = 1) -> Any:
    """Rough and smooth places, the ends of the type, and runs: what compressors differ on."""
    random = numpy.random.default_rng(7)
    rows, columns = numpy.mgrid[0:ROWS, 0:COLUMNS]
    hills = 40 * numpy.sin(rows / 9) + 50 * numpy.cos(columns / 13) + 90
    noise = random.normal(0, 20, (bands, ROWS, COLUMNS)) * (columns > 70)
    values = numpy.clip(hills + noise, 0, 120)
    values[:, 40:50, 10:60] = 17
    kind = numpy.dtype(sample)
    if kind.kind == "f":
        return (values * 1.7).astype(kind)
    limits = numpy.iinfo(kind)
    whole = values.astype(kind)
    whole[:, 3, 4:6] = limits.min, limits.max
    return whole


def write(path: Path, sample: str, bands: int = 1, **options: Any) -> Any:
    written = heights(sample, bands)
    with rasterio.open(
        path,
        "w",
        driver="GTiff",
        width=COLUMNS,
        height=ROWS,
        count=bands,
        dtype=sample,
        transform=rasterio.Affine(10, 0, 500, 0, -10, 900),
        **options,
    ) as file:
        file.write(written)
    return written[0].astype("float64")


def decoded(tiff: GeoTiff, first_column: int = 0, first_row: int = 0, columns: int = 0, rows: int = 0) -> Any:
    layout = GridLayout(
        rows or ROWS, columns or COLUMNS, cell_width=1, cell_height=1, sample=tiff.sample, byte_order="little"
    )
    return values(tiff.decode(layout, first_column, first_row))


def values(grid: Grid) -> Any:
    rows, columns = grid.layout.rows, grid.layout.columns
    flat = numpy.asarray(grid.elevations(range(columns), range(rows)))
    return flat.reshape(rows, columns)


def mapped(path: Path, tiff: GeoTiff) -> Any:
    assert tiff.in_place is not None
    offset, row_stride = tiff.in_place
    layout = GridLayout(
        ROWS,
        COLUMNS,
        cell_width=1,
        cell_height=1,
        sample=tiff.sample,
        byte_order=tiff.byte_order,
        offset=offset,
        row_stride=row_stride,
    )
    return values(Grid.open(path, layout))


@pytest.mark.parametrize("big", ["NO", "YES"])
@pytest.mark.parametrize("endianness", ["LITTLE", "BIG"])
@pytest.mark.parametrize("chunks", CHUNKS)
@pytest.mark.parametrize(("packing", "predictor"), PACKINGS)
def test_every_type_is_read_as_rasterio_reads_it(
    tmp_path: Path, packing: str, predictor: int, chunks: str, endianness: str, big: str
) -> None:
    for sample in TYPES:
        if predictor == 3 and not sample.startswith("float"):
            continue
        path = tmp_path / f"{sample}.tif"
        options = {"compress": packing, "endianness": endianness, "bigtiff": big, **CHUNKS[chunks]}
        expected = write(path, sample, predictor=predictor, **options)
        tiff = GeoTiff.open(path)
        assert (tiff.big, tiff.byte_order) == (big == "YES", endianness.lower())
        assert (tiff.compression.upper(), tiff.predictor) == (packing, predictor)
        assert numpy.array_equal(decoded(tiff), expected), sample
        assert numpy.array_equal(decoded(tiff, 31, 20, 70, 50), expected[20:70, 31:101]), sample
        is_in_place = packing == "NONE" and chunks != "tiles" and sample not in {"uint8", "int8", "uint32"}
        assert (tiff.in_place is not None) == is_in_place
        if is_in_place:
            assert numpy.array_equal(mapped(path, tiff), expected)


@pytest.mark.parametrize("interleave", ["pixel", "band"])
@pytest.mark.parametrize("chunks", CHUNKS)
@pytest.mark.parametrize(("packing", "predictor"), PACKINGS)
def test_the_first_of_several_bands_is_read(
    tmp_path: Path, packing: str, predictor: int, chunks: str, interleave: str
) -> None:
    for sample in TYPES:
        if predictor == 3 and not sample.startswith("float"):
            continue
        path = tmp_path / f"{sample}.tif"
        options = {"compress": packing, "interleave": interleave, **CHUNKS[chunks]}
        expected = write(path, sample, bands=3, predictor=predictor, **options)
        tiff = GeoTiff.open(path)
        assert (tiff.bands, tiff.planar) == (3, interleave == "band")
        assert numpy.array_equal(decoded(tiff), expected), sample


@pytest.mark.parametrize("packing", ["NONE", "DEFLATE"])
def test_tiles_that_were_left_out_have_the_fill_value(tmp_path: Path, packing: str) -> None:
    path = tmp_path / "sparse.tif"
    with rasterio.open(
        path,
        "w",
        driver="GTiff",
        width=COLUMNS,
        height=ROWS,
        count=1,
        dtype="int16",
        nodata=-7,
        compress=packing,
        sparse_ok=True,
        tiled=True,
        blockxsize=32,
        blockysize=16,
        transform=rasterio.Affine(10, 0, 500, 0, -10, 900),
    ) as file:
        file.write(numpy.full((16, 32), 5, "int16"), 1, window=((32, 48), (64, 96)))
    with rasterio.open(path) as file:
        expected = file.read(1).astype("float64")
    tiff = GeoTiff.open(path)
    layout = GridLayout(ROWS, COLUMNS, cell_width=1, cell_height=1, byte_order="little")
    assert tiff.in_place is None
    assert numpy.array_equal(values(tiff.decode(layout, fill=-7)), expected)


MARS = "+proj=longlat +a=3396190 +b=3376200 +no_defs"
MARS_SPHERE = "+proj=eqc +lat_ts=0 +lat_0=0 +lon_0=180 +R=3396190 +units=m +no_defs"
MOON_POLE = "+proj=stere +lat_0=-90 +lon_0=0 +k=1 +R=1737400 +units=m +no_defs"
STATE_PLANE = (
    "+proj=lcc +lat_1=44.3333 +lat_2=46 +lat_0=43.6666 +lon_0=-120.5 +x_0=2500000 +datum=NAD83 +units=us-ft"
)
AUSTRIA = "+proj=tmerc +lat_0=0 +lon_0=13.3333 +k=1 +x_0=0 +y_0=-5000000 +ellps=bessel +units=m"
ONE_PARALLEL = (
    "+proj=lcc +lat_1=46.5 +lat_0=46.5 +lon_0=0 +k_0=0.99987742 +x_0=600000 +y_0=2200000 +ellps=clrk80"
)
ALBERS = "+proj=aea +lat_0=23 +lon_0=-96 +lat_1=29.5 +lat_2=45.5 +x_0=0 +y_0=0 +datum=NAD83 +units=m"
MERCATOR = "+proj=merc +lon_0=110 +k=0.997 +x_0=3900000 +y_0=900000 +ellps=bessel +units=m"
TRUE_MERCATOR = "+proj=merc +lat_ts=-41 +lon_0=100 +x_0=0 +y_0=0 +datum=WGS84 +units=m"
SINUSOIDAL = "+proj=sinu +lon_0=0 +x_0=0 +y_0=0 +R=3396190 +units=m"
OBLIQUE = "+proj=stere +lat_0=18 +lon_0=133 +k=1 +x_0=0 +y_0=0 +R=3396190 +units=m"
SYSTEMS: dict[str, tuple[str, float, float, float]] = {
    "EPSG:4326": ("EPSG:4326", 14.0, 47.0, 0.01),
    "EPSG:4269": ("EPSG:4269", -122.0, 42.0, 0.01),
    "EPSG:4267": ("EPSG:4267", -122.0, 42.0, 0.01),
    "EPSG:32633": ("EPSG:32633", 500_000.0, 5_200_000.0, 30.0),
    "EPSG:32719": ("EPSG:32719", 400_000.0, 7_200_000.0, 30.0),
    "EPSG:26910": ("EPSG:26910", 500_000.0, 5_200_000.0, 30.0),
    "EPSG:3031": ("EPSG:3031", -1_000_000.0, 900_000.0, 500.0),
    "EPSG:3413": ("EPSG:3413", -500_000.0, -900_000.0, 500.0),
    "EPSG:3857": ("EPSG:3857", 1_500_000.0, 6_000_000.0, 30.0),
    "EPSG:3035": ("EPSG:3035", 4_500_000.0, 2_700_000.0, 100.0),
    "EPSG:5070": ("EPSG:5070", -2_000_000.0, 2_700_000.0, 100.0),
    "EPSG:6339": ("EPSG:6339", 500_000.0, 5_200_000.0, 30.0),
    "EPSG:6318": ("EPSG:6318", -122.0, 42.0, 0.01),
    "EPSG:26718": ("EPSG:26718", 500_000.0, 4_200_000.0, 30.0),
    "EPSG:25832": ("EPSG:25832", 500_000.0, 5_200_000.0, 30.0),
    "EPSG:23030": ("EPSG:23030", 500_000.0, 4_200_000.0, 30.0),
    "EPSG:28355": ("EPSG:28355", 500_000.0, 6_200_000.0, 30.0),
    "EPSG:7855": ("EPSG:7855", 500_000.0, 6_200_000.0, 30.0),
    "EPSG:3995": ("EPSG:3995", -500_000.0, -900_000.0, 500.0),
    "EPSG:27700": ("EPSG:27700", 400_000.0, 300_000.0, 50.0),
    "EPSG:2193": ("EPSG:2193", 1_500_000.0, 5_200_000.0, 50.0),
    "EPSG:2154": ("EPSG:2154", 700_000.0, 6_600_000.0, 50.0),
    "Mars in degrees": (MARS, 220.0, 20.0, 0.05),
    "Mars, equirectangular": (MARS_SPHERE, -1_000_000.0, 600_000.0, 463.0),
    "Moon's south pole": (MOON_POLE, -30_000.0, 40_000.0, 240.0),
    "state plane in feet": (STATE_PLANE, 8_000_000.0, 700_000.0, 100.0),
    "Bessel's ellipsoid": (AUSTRIA, 100_000.0, 200_000.0, 25.0),
    "cone of one parallel": (ONE_PARALLEL, 700_000.0, 2_300_000.0, 50.0),
    "Albers' cone": (ALBERS, -2_000_000.0, 2_700_000.0, 100.0),
    "Mercator": (MERCATOR, 3_700_000.0, 800_000.0, 100.0),
    "Mercator, true at a parallel": (TRUE_MERCATOR, 300_000.0, -3_000_000.0, 100.0),
    "Mars, sinusoidal": (SINUSOIDAL, 500_000.0, 1_300_000.0, 463.0),
    "Mars, about Olympus Mons": (OBLIQUE, -300_000.0, 300_000.0, 463.0),
}
"""The system, and x, y and the step of the upper left corner in its own unit."""


@pytest.mark.parametrize("south_up", [False, True])
@pytest.mark.parametrize("points", [False, True])
@pytest.mark.parametrize("system", SYSTEMS)
def test_places_are_where_rasterio_has_them(
    tmp_path: Path, system: str, points: bool, south_up: bool
) -> None:
    crs, x, y, step = SYSTEMS[system]
    path = tmp_path / "grid.tif"
    transform = rasterio.Affine(step, 0, x, 0, step if south_up else -step, y)
    with rasterio.open(
        path,
        "w",
        driver="GTiff",
        width=COLUMNS,
        height=ROWS,
        count=1,
        dtype="int16",
        crs=crs,
        transform=transform,
        nodata=-9999,
    ) as file:
        if points:
            file.update_tags(AREA_OR_POINT="Point")
        file.write(heights("int16"))
    grid = read_geotiff(path)
    place = grid.georeference
    with rasterio.open(path) as file:
        unit = file.crs.linear_units_factor[1] if file.crs.is_projected else 1.0
        ellipsoid = {key: file.crs.to_dict().get(key) for key in ("a", "b", "R")}
        for column, row in [(0, 0), (COLUMNS - 1, 0), (30, ROWS - 1), (55, 41)]:
            file_row = ROWS - 1 - row if south_up else row
            expected = file.xy(file_row, column)
            found = (place.x(column) / unit, place.y(row) / unit)
            assert found == pytest.approx(expected, rel=1e-12, abs=1e-9 * step)
            assert grid.open().elevation(column, row) == file.read(1)[file_row, column]
            _check_longitude_and_latitude(file.crs, grid, column, row, expected)
    assert place.registration == ("points" if points else "cells")
    radius = ellipsoid["a"] or ellipsoid["R"]
    assert radius is None or place.ellipsoid.semi_major == pytest.approx(radius)


def _check_longitude_and_latitude(
    crs: Any, grid: ElevationGrid, column: int, row: int, place: tuple[float, float]
) -> None:
    """Compare with PROJ where the projection is known here."""
    found = grid.georeference.longitude_latitude(column, row)
    if grid.georeference.projection.name == "unknown projection":
        return
    assert found is not None
    ellipsoid = grid.georeference.ellipsoid
    below = crs.to_wkt()
    geographic = below[below.index("GEOGCS[") :] if "PROJCS[" in below else below
    depth = 0
    for end, letter in enumerate(geographic):
        depth += (letter == "[") - (letter == "]")
        if letter == "]" and depth == 0:
            geographic = geographic[: end + 1]
            break
    longitudes, latitudes = rasterio.warp.transform(
        crs, rasterio.crs.CRS.from_wkt(geographic), [place[0]], [place[1]]
    )
    metres = ellipsoid.degree_of_latitude(latitudes[0])
    assert ((found[0] - longitudes[0] + 180.0) % 360.0 - 180.0) * metres == pytest.approx(0.0, abs=0.01)
    assert (found[1] - latitudes[0]) * metres == pytest.approx(0.0, abs=0.01)
