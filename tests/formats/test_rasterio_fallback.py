"""The last road, with a stand-in for rasterio: the tests do not need it."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from proxygraph import CancelledError, Progress

from addon.formats import FormatError, Region, read_grid
from addon.formats.cache import SUFFIX, cache
from addon.formats.decoding import Decoding
from addon.formats.through_rasterio import rasterio_library
from addon.formats.unfinished import unfinished_file
from tests.formats.megdr_pair import rough
from tests.formats.reading import complaint, heights
from tests.formats.tiff_file import SHORT, TiffFile

HFA = b"EHFA_HEADER_TAG\0rest"


@dataclass
class StandIn:
    """What rasterio would give for one file."""

    values: Any = field(default_factory=lambda: np.array(rough(5, 8), dtype=np.int16))
    transform: Any = field(
        default_factory=lambda: SimpleNamespace(a=45.0, b=0.0, c=-180.0, d=0.0, e=-30.0, f=75.0)
    )
    crs: Any = None
    count: int = 1
    nodata: float | None = None
    scales: tuple[float, ...] = (1.0,)
    offsets: tuple[float, ...] = (0.0,)
    units: tuple[str | None, ...] = (None,)
    driver: str = "HFA"

    @property
    def dtypes(self) -> tuple[str, ...]:
        return (str(self.values.dtype),)

    @property
    def height(self) -> int:
        return int(self.values.shape[0])

    @property
    def width(self) -> int:
        return int(self.values.shape[1])

    def read(self, _band: int, *, window: tuple[tuple[int, int], tuple[int, int]], out_dtype: str) -> Any:
        rows, columns = window
        return self.values[slice(*rows), slice(*columns)].astype(out_dtype)


def use(monkeypatch: pytest.MonkeyPatch, source: StandIn | None, error: Exception | None = None) -> None:
    """Put a rasterio in place that opens this, or none."""

    def opened(_path: Path, *, driver: str) -> AbstractContextManager[StandIn]:
        assert driver in rasterio_library.DRIVERS
        if error is not None:
            raise error
        assert source is not None
        return nullcontext(source)

    class RasterioError(Exception):
        """Of the stand-in."""

    def imported(name: str) -> Any:
        if source is None and error is None:
            raise ImportError(name)
        return SimpleNamespace(open=opened, errors=SimpleNamespace(RasterioError=RasterioError))

    monkeypatch.setattr(rasterio_library, "import_module", imported)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "grid.img"
    path.write_bytes(HFA)
    return path


def test_without_rasterio_it_is_the_way_out(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, None)
    text = complaint(file)
    assert "only rasterio reads" in text
    assert "Install rasterio" in text


@pytest.mark.parametrize("dtype", ["uint8", "int16", "uint16", "int32", "uint32", "float32", ">f8"])
def test_the_first_band_is_decoded(file: Path, monkeypatch: pytest.MonkeyPatch, dtype: str) -> None:
    values = np.arange(600 * 4).reshape(600, 4).astype(dtype)
    values = values.astype(values.dtype.newbyteorder("="))
    use(monkeypatch, StandIn(values=values))
    grid = read_grid(file)
    assert heights(grid) == values.astype(float).tolist()
    assert "rasterio" in grid.format
    assert "rasterio" in " ".join(grid.notes)


@pytest.fixture
def cache_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Of a cache that takes everything into files."""
    monkeypatch.setattr(cache, "folder", tmp_path / "cache")
    monkeypatch.setattr(cache, "most_in_memory", 0)
    return cache.folder


def test_a_large_grid_goes_to_a_cache_file_and_is_read_once(
    file: Path, monkeypatch: pytest.MonkeyPatch, cache_folder: Path
) -> None:
    values = np.arange(600 * 4, dtype=np.int16).reshape(600, 4)
    use(monkeypatch, StandIn(values=values))
    grid = read_grid(file)
    assert heights(grid) == values.astype(float).tolist()
    (only,) = cache_folder.iterdir()
    assert only.suffix == SUFFIX
    assert only.read_bytes() == values.astype("<i2").tobytes()
    use(monkeypatch, None)
    assert heights(grid) == values.astype(float).tolist()


def test_a_decoding_that_is_cancelled_or_fails_leaves_no_cache_file(
    file: Path, monkeypatch: pytest.MonkeyPatch, cache_folder: Path
) -> None:
    source = StandIn()
    use(monkeypatch, source)
    grid = read_grid(file)
    progress = Progress()
    progress.cancel()
    with pytest.raises(CancelledError):
        grid.open(progress)
    assert not list(cache_folder.iterdir())

    def unreadable(*_: object, **__: object) -> Any:
        raise rasterio_library.rasterio_module().errors.RasterioError("IReadBlock failed")

    monkeypatch.setattr(source, "read", unreadable)
    with pytest.raises(FormatError, match="IReadBlock failed"):
        grid.open()
    assert not list(cache_folder.iterdir())


def test_two_decodings_at_once_do_not_write_into_each_other(tmp_path: Path) -> None:
    place = tmp_path / "grid.samples"
    with unfinished_file(place) as first, unfinished_file(place) as second:
        second.write(b"second")
        first.write(b"first")
    assert place.read_bytes() == b"first", "the last one that ends gives the file"
    assert list(tmp_path.iterdir()) == [place]


def test_regions_are_read_alone_also_across_the_seam(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    crs = SimpleNamespace(
        is_geographic=True, to_string=lambda: "x", to_wkt=lambda: "x", to_dict=lambda: {"R": 1_737_400}
    )
    source = StandIn(crs=crs)
    use(monkeypatch, source)
    grid = read_grid(file)
    assert grid.layout.wraps
    assert grid.georeference.ellipsoid.semi_major == 1_737_400
    part = heights(grid.region(Region(6, 1, 4, 3)))
    assert part == [[source.values[row, column % 8] for column in range(6, 10)] for row in range(1, 4)]


@pytest.mark.parametrize(
    ("axes", "kind"), [({"R": 1_737_400}, "planetocentric"), ({"a": 3e6, "b": 2.9e6}, "planetographic")]
)
def test_latitudes_on_an_ellipsoid_are_of_its_vertical(
    file: Path, monkeypatch: pytest.MonkeyPatch, axes: dict[str, float], kind: str
) -> None:
    crs = SimpleNamespace(is_geographic=True, to_string=lambda: "x", to_wkt=lambda: "x", to_dict=lambda: axes)
    use(monkeypatch, StandIn(crs=crs))
    assert read_grid(file).georeference.latitude_kind == kind


@pytest.mark.parametrize("place", [(8, 0), (-1, 0), (0, 1), (10**12, 0), (0, -1)])
def test_a_region_that_is_not_on_the_raster_is_told(
    file: Path, monkeypatch: pytest.MonkeyPatch, place: tuple[int, int]
) -> None:
    use(monkeypatch, StandIn())
    grid = read_grid(file)
    assert grid.layout.columns == 8
    with pytest.raises(FormatError, match="are not on its 8 x"):
        replace(grid, decoding=Decoding("rasterio", *place)).open()


def test_void_factor_and_offset(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    values = np.array([[1, -9999], [2, 3]], dtype=np.int16)
    use(monkeypatch, StandIn(values=values, nodata=-9999.0, scales=(0.5,), offsets=(10.0,)))
    assert heights(read_grid(file)) == [[10.5, None], [11.0, 11.5]]


def test_the_void_is_rounded_as_the_samples_are(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    values = np.array([[1, -9999.9], [2, 3]], dtype=np.float32)
    use(monkeypatch, StandIn(values=values, nodata=-9999.9))
    assert heights(read_grid(file)) == [[1.0, None], [2.0, 3.0]]


@pytest.mark.parametrize(("unit", "metres"), [("ft", 0.3048), ("US survey foot", 1200 / 3937), ("m", 1.0)])
def test_heights_in_the_unit_of_the_band_become_metres(
    file: Path, monkeypatch: pytest.MonkeyPatch, unit: str, metres: float
) -> None:
    values = np.array([[1, 2], [3, 4]], dtype=np.int16)
    use(monkeypatch, StandIn(values=values, scales=(10.0,), offsets=(5.0,), units=(unit,)))
    grid = read_grid(file)
    assert heights(grid)[1][1] == pytest.approx(45.0 * metres)
    assert grid.georeference.vertical_unit == unit


def test_a_unit_of_heights_that_is_not_known_is_told(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, StandIn(units=("fathom",)))
    assert any("fathom" in note for note in read_grid(file).notes)


WGS_84 = (
    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["{meridian}",{longitude}],UNIT["degree",0.0174532925199433]]'
)
FEET = (
    'PROJCS["in feet",' + WGS_84.format(meridian="Greenwich", longitude=0) + ',PROJECTION["{method}"],'
    'PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",-123],'
    'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",1640416.667],PARAMETER["false_northing",0],'
    'UNIT["US survey foot",0.304800609601219]]'
)


def system(wkt: str, **others: Any) -> SimpleNamespace:
    """What rasterio says of a coordinate system."""
    return SimpleNamespace(
        to_string=lambda: "x", to_wkt=lambda: wkt, is_geographic=wkt.startswith("GEOGCS"), **others
    )


@pytest.mark.parametrize("method", ["Transverse_Mercator", "Krovak"])
def test_a_map_in_feet_becomes_metres(file: Path, monkeypatch: pytest.MonkeyPatch, method: str) -> None:
    transform = SimpleNamespace(a=100.0, b=0.0, c=1640366.667, d=0.0, e=-100.0, f=500.0)
    use(monkeypatch, StandIn(crs=system(FEET.format(method=method)), transform=transform))
    grid = read_grid(file)
    assert grid.layout.cell_width == pytest.approx(30.48006096)
    assert grid.georeference.first_x == pytest.approx(500_000.0, abs=0.01)
    assert grid.georeference.first_y == pytest.approx(450 * 0.3048006096)
    place = grid.georeference.longitude_latitude(0.0, 0.0)
    assert (place is None) == (method == "Krovak")
    assert place is None or place[0] == pytest.approx(237.0, abs=1e-6)


def test_the_unit_of_a_map_whose_text_says_nothing_is_asked_for(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    crs = system("PROJCRS[]", linear_units_factor=("foot", 0.3048), to_dict=dict)
    use(monkeypatch, StandIn(crs=crs))
    assert read_grid(file).layout.cell_width == pytest.approx(45.0 * 0.3048)


def test_longitudes_are_counted_from_greenwich(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, StandIn(crs=system(WGS_84.format(meridian="Paris", longitude=2.33722917))))
    assert read_grid(file).georeference.first_x == pytest.approx(-157.5 + 2.33722917)


@pytest.mark.parametrize(("radius", "kind"), [("298.257223563", "planetographic"), ("0", "planetocentric")])
def test_latitudes_are_those_of_the_ellipsoid(
    file: Path, monkeypatch: pytest.MonkeyPatch, radius: str, kind: str
) -> None:
    wkt = WGS_84.format(meridian="Greenwich", longitude=0).replace("298.257223563", radius)
    use(monkeypatch, StandIn(crs=system(wkt)))
    assert read_grid(file).georeference.latitude_kind == kind


def test_degrees_without_a_coordinate_system_are_assumed(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    transform = SimpleNamespace(a=0.001, b=0.0, c=7.0, d=0.0, e=-0.001, f=47.0)
    use(monkeypatch, StandIn(transform=transform))
    grid = read_grid(file)
    assert grid.layout.cell_height == pytest.approx(111.17, abs=0.05)
    assert any("assumed" in note for note in grid.notes)


@pytest.mark.parametrize(
    ("source", "named"),
    [
        (StandIn(values=np.zeros((4, 4), dtype=complex)), "complex128"),
        (StandIn(values=np.zeros((1, 4), dtype=np.int16)), "grid"),
        (StandIn(count=0), "no band"),
        (StandIn(transform=SimpleNamespace(a=1.0, b=0.5, c=0.0, d=0.0, e=-1.0, f=0.0)), "north up"),
        (StandIn(transform=SimpleNamespace(a=1.0, b=0.0, c=0.0, d=0.0, e=1.0, f=0.0)), "Flip"),
    ],
)
def test_rasters_that_make_no_grid(
    file: Path, monkeypatch: pytest.MonkeyPatch, source: StandIn, named: str
) -> None:
    use(monkeypatch, source)
    assert named in complaint(file)


def test_more_samples_than_memory_should_hold(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    huge = np.lib.stride_tricks.as_strided(np.zeros(1, np.float32), (100_000, 100_000), (0, 0))
    use(monkeypatch, StandIn(values=huge))
    assert "40,000,000,000 bytes" in complaint(file)


def test_what_no_driver_reads_is_refused(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, None, RuntimeError("not a raster"))
    assert "none of GDAL's drivers" in complaint(file)


def test_drivers_that_lead_to_other_files_are_not_asked() -> None:
    assert not {"VRT", "WMS", "WCS", "HTTP", "STACIT", "ERS", "Zarr"} & set(rasterio_library.DRIVERS)


def test_a_raster_that_is_gone_when_it_is_opened(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, StandIn())
    grid = read_grid(file)
    use(monkeypatch, None)
    with pytest.raises(FormatError, match="not installed any more"):
        grid.open()


def test_pictures_are_not_tried(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, StandIn())
    for name, content in (
        ("a.img", b"\x89PNG\r\n\x1a\n"),
        ("b.img", b"<VRTDataset><SourceFilename>/etc/passwd"),
    ):
        (tmp_path / name).write_bytes(content)
        assert "content" in complaint(tmp_path / name)


def test_a_tiff_that_is_packed_in_another_way_is_left_to_rasterio(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "zstd.tif").write_bytes(TiffFile(rough(5, 8), tags={259: (SHORT, [50000])}).data())
    use(monkeypatch, None)
    assert "Compression" in complaint(tmp_path / "zstd.tif")
    use(monkeypatch, StandIn())
    assert "rasterio" in read_grid(tmp_path / "zstd.tif").format


def test_a_tiff_that_is_damaged_is_not(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "cut.tif").write_bytes(TiffFile(rough(5, 8)).data()[:100])
    use(monkeypatch, StandIn())
    assert "rasterio" not in complaint(tmp_path / "cut.tif").replace("with rasterio", "")
