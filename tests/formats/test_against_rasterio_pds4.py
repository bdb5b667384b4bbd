"""PDS4 labels that GDAL writes: places as rasterio has them.

rasterio is no dependency: where it is not installed, these tests are skipped.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import read_grid

rasterio = pytest.importorskip("rasterio", reason="rasterio is not installed")
warp = pytest.importorskip("rasterio.warp", reason="rasterio is not installed")

SPHERE = "+R=1737400 +no_defs"
MAPS = {
    "true to scale at 71 S": "+proj=stere +lat_0=-90 +lat_ts=-71 +lon_0=15",
    "scale stated at the north pole": "+proj=stere +lat_0=90 +k=0.994 +lon_0=20",
    "the south pole": "+proj=stere +lat_0=-90 +lon_0=0",
    "cone of two parallels": "+proj=lcc +lat_1=20 +lat_2=50 +lat_0=30 +lon_0=10",
    "cone of one parallel": "+proj=lcc +lat_1=30 +lat_0=30 +lon_0=10 +k_0=0.99",
    "transverse Mercator": "+proj=tmerc +lat_0=10 +lon_0=20 +k=0.9",
    "Mercator with a scale": "+proj=merc +lon_0=20 +k=0.9",
    "Mercator of a parallel": "+proj=merc +lon_0=20 +lat_ts=30",
    "equal areas": "+proj=laea +lat_0=30 +lon_0=20",
    "equirectangular": "+proj=eqc +lat_ts=30 +lon_0=20",
}


@pytest.mark.parametrize("name", MAPS)
def test_places_are_those_of_rasterio(tmp_path: Path, name: str) -> None:
    numpy = pytest.importorskip("numpy")
    label = tmp_path / "grid.xml"
    with rasterio.open(
        label,
        "w",
        driver="PDS4",
        width=6,
        height=4,
        count=1,
        dtype="int16",
        crs=rasterio.crs.CRS.from_proj4(f"{MAPS[name]} {SPHERE}"),
        transform=rasterio.Affine(100_000.0, 0.0, -300_000.0, 0.0, -100_000.0, 400_000.0),
        VAR_TITLE="Test",
        VAR_LOGICAL_IDENTIFIER="urn:test",
        VAR_TARGET="Moon",
        VAR_TARGET_TYPE="Satellite",
    ) as file:
        file.write(numpy.arange(24, dtype="int16").reshape(4, 6), 1)
    grid = read_grid(label)
    with rasterio.open(label) as file:
        degrees = rasterio.crs.CRS.from_proj4(f"+proj=longlat {SPHERE}")
        for column, row in ((0, 0), (5, 0), (2, 3)):
            x, y = file.transform * (column + 0.5, row + 0.5)
            (longitude,), (latitude,) = warp.transform(file.crs, degrees, [x], [y])
            found = grid.georeference.longitude_latitude(column, row)
            assert found is not None
            assert found == pytest.approx((longitude % 360.0, latitude), abs=1e-7)
