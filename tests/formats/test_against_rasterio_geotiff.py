"""Files that GDAL writes: every sample as rasterio reads it.

rasterio is no dependency: where it is not installed, these tests are skipped.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import pytest
from proxygraph import GeoTiff, Grid, GridLayout

numpy = pytest.importorskip("numpy", reason="numpy is not installed")
rasterio = pytest.importorskip("rasterio", reason="rasterio is not installed")

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
