"""Measure how fast elevation files are read, beside GDAL in one process; ``make bench-formats`` runs this.

Each pair reads the whole of one file into memory, the values are compared first, and readings take turns
in shuffled order; a figure is a ratio of medians. Then the reader of the smallest MOLA grid, and the import
of a grid into Blender, are timed alone, and the fuzzers of all readers run for a while.
"""

from __future__ import annotations

import argparse
import json
import random
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
import rasterio

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "blender_scripts")]

from addon.formats import Georeference, read_grid  # noqa: E402
from tests.bench.fuzzing import fuzz_all  # noqa: E402
from tests.bench.preview_import import import_seconds  # noqa: E402

SIDE = 2000
"""Samples along a side of the written grids."""

MOST_APART = 1e-6
"""Cells between the places that two readers give one sample."""

Numbers = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Pair:
    """One file, read by both."""

    key: str
    title: str
    path: Path
    to_reach: float


def main() -> None:
    """Measure, print and write the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=Path, help="formats.json")
    parser.add_argument("--data", type=Path, required=True, help="folder with real grids; may be absent")
    parser.add_argument("--rounds", type=int, default=15, help="readings of each file by each reader")
    parser.add_argument("--fuzz-seconds", type=float, default=20.0, help="for each reader's fuzzer")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        pairs = written(Path(folder)) + real(options.data)
        figures: dict[str, float | str] = {}
        print(f"{'reading a whole file':44} {'here, ms':>9} {'GDAL, ms':>9} {'ratio':>7}   to reach")
        for pair in pairs:
            figures |= _measured(pair, options.rounds)
        label = options.data / "mola" / "megt90n000cb.lbl"
        if label.is_file():
            figures |= _alone(label, options.rounds)
    figures |= fuzz_all(options.fuzz_seconds)
    figures["gdal"] = rasterio.__gdal_version__
    options.output.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    print(f"Figures: {options.output}")


def written(folder: Path) -> list[Pair]:
    """Write the grids that need no real data: GDAL writes the GeoTIFF, so that it is what people have."""
    heights = _relief()
    tiff, whole, decimal = folder / "deflate.tif", folder / "whole.asc", folder / "decimal.asc"
    profile = {
        "driver": "GTiff", "width": SIDE, "height": SIDE, "count": 1, "dtype": "int16", "nodata": -32767,
        "transform": rasterio.Affine(30.0, 0.0, 500_000.0, 0.0, -30.0, 4_160_000.0), "crs": "EPSG:32611",
        "compress": "deflate", "predictor": 2, "tiled": True, "blockxsize": 256, "blockysize": 256,
    }  # fmt: skip
    with rasterio.open(tiff, "w", **profile) as file:
        file.write(heights.astype(np.int16), 1)
    _write_ascii(whole, heights, "%d")
    _write_ascii(decimal, heights / 7.0, "%.2f")
    return [
        Pair("geotiff_deflate_over_gdal", "GeoTIFF, deflate, predictor 2, tiles", tiff, 1.5),
        Pair("esri_ascii_over_gdal", "Esri ASCII, whole metres", whole, 1.0),
        Pair("esri_ascii_decimal_over_gdal", "Esri ASCII, centimetres", decimal, 1.0),
    ]


def real(data: Path) -> list[Pair]:
    """Find the real USGS DEM."""
    path = data / "usgs_dem" / "SainteHelens.dem"
    if not path.is_file():
        print(f"skipped: {path.name} is not there; usgs_dem_over_gdal is not measured")
        return []
    return [Pair("usgs_dem_over_gdal", "USGS DEM, Mount St. Helens", path, 1.0)]


def race(runs: Sequence[Callable[[], object]], rounds: int) -> list[float]:
    """Median seconds of each, in shuffled turns."""
    times: list[list[float]] = [[] for _ in runs]
    order = list(range(len(runs)))
    shuffled = random.Random(1)
    for _ in range(rounds):
        shuffled.shuffle(order)
        for number in order:
            began = time.perf_counter()
            runs[number]()
            times[number].append(time.perf_counter() - began)
    return [statistics.median(spent) for spent in times]


def _measured(pair: Pair, rounds: int) -> dict[str, float | str]:
    _check_agreement(pair.path)
    ours, gdal = race([lambda: read_grid(pair.path).open(), lambda: rasterio.open(pair.path).read(1)], rounds)
    ratio = ours / gdal
    print(f"{pair.title:44} {ours * 1e3:9.1f} {gdal * 1e3:9.1f} {ratio:7.2f}   <= {pair.to_reach}")
    return {pair.key: ratio, f"{pair.key.removesuffix('_over_gdal')}_ms": ours * 1e3}


def _check_agreement(path: Path) -> None:
    """A race between readers of different values, or of different places, would say nothing."""
    described = read_grid(path)
    grid, place = described.open(), described.georeference
    columns, rows = grid.layout.columns, grid.layout.rows
    ours = np.asarray(grid.elevations(range(columns), range(rows))).reshape(rows, columns)
    with rasterio.open(path) as file:
        # GDAL takes decimals in text for single precision.
        precision = np.finfo(np.float32).eps if file.dtypes[0] == "float32" else 0.0
        theirs = file.read(1, masked=True).astype(np.float64).filled(np.nan)
        row, column = file.index(place.first_x, place.first_y)
        check_place(
            path, place, (columns, rows), file.xy(row, column), file.xy(row + rows - 1, column + columns - 1)
        )
    # GDAL gives a USGS DEM the rows between its corners, also where no profile reaches.
    common = theirs[row : row + rows, column : column + columns]
    same_heights = np.allclose(ours, common, rtol=precision, atol=0.0, equal_nan=True)
    if not same_heights or np.isfinite(theirs).sum() != np.isfinite(common).sum():
        raise SystemExit(f"{path.name}: the two readers give different heights; nothing was measured")


def check_place(
    path: Path,
    place: Georeference,
    size: tuple[int, int],
    first: tuple[float, float],
    last: tuple[float, float],
) -> None:
    """Compare where the outer samples lie; rows and columns alone would hide a shift of half a cell.

    Args:
        path: of the file.
        place: where it lies for us.
        size: columns and rows.
        first: x and y of the north-west sample for GDAL.
        last: x and y of the south-east sample for GDAL.

    Raises:
        SystemExit: they lie elsewhere.
    """
    columns, rows = size
    step = np.array([place.step_x, place.step_y])
    ours = np.array([[place.first_x, place.first_y], [place.x(columns - 1), place.y(rows - 1)]])
    apart = np.abs(ours - np.array([first, last], dtype=np.float64)) / step
    if not apart.max() <= MOST_APART:
        raise SystemExit(f"{path.name}: {apart.max():g} cells between the two readers; nothing was measured")


def _alone(label: Path, rounds: int) -> dict[str, float | str]:
    (opened,) = race([lambda: read_grid(label).open()], rounds)
    imported = import_seconds(label, rounds=5)
    print(f"{'MOLA, 4 pixels per degree: read the label, map':44} {opened * 1e3:9.1f}")
    print(f"{'the same imported as a preview of all samples':44} {imported * 1e3:9.1f}      to reach: < 1000")
    return {"mola_4ppd_open_ms": opened * 1e3, "import_preview_1440x720_s": imported}


def _relief() -> Numbers:
    """Rough ground of two wavelengths and some noise, up to about 3 km."""
    rows, columns = np.mgrid[0:SIDE, 0:SIDE]
    noise = np.random.default_rng(1).normal(0.0, 4.0, (SIDE, SIDE))
    smooth = 1200.0 * np.sin(columns / 190.0) * np.cos(rows / 160.0) + 300.0 * np.sin((columns + rows) / 23.0)
    return np.asarray(np.round(1500.0 + smooth + noise), dtype=np.float64)


def _write_ascii(path: Path, heights: Numbers, number: str) -> None:
    header = (
        f"ncols {SIDE}\nnrows {SIDE}\nxllcorner 500000\nyllcorner 4100000\ncellsize 30\nNODATA_value -9999"
    )
    np.savetxt(path, heights, fmt=number, header=header, comments="")


if __name__ == "__main__":
    main()
