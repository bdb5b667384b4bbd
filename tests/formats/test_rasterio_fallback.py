"""The last road, with a stand-in for rasterio: the tests do not need it."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from addon.formats import FormatError, Region, read_grid
from addon.formats.decoding import Decoding
from addon.formats.through_rasterio import rasterio_library
from tests.formats.megdr_pair import rough
from tests.formats.reading import complaint, heights

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
