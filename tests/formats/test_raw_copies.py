"""Raw samples that are copied because they cannot be used where they lie."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from struct import calcsize, pack, unpack

import pytest
from proxygraph import CancelledError, GridLayout, Progress

from addon.formats import ElevationGrid, FormatError, Region
from addon.formats.body.ellipsoid import Ellipsoid
from addon.formats.decoding import Decoding
from addon.formats.georeference import Georeference
from addon.formats.projections import Geographic
from addon.formats.raw.raw_samples import DECODED, RAW_BYTES, RawSample, RawSamples
from tests.formats.megdr_pair import planet, rough

CODES: dict[RawSample, str] = {
    "i8": "b",
    "u8": "B",
    "i16": "h",
    "u16": "H",
    "i32": "i",
    "u32": "I",
    "i64": "q",
    "u64": "Q",
    "f32": "f",
    "f64": "d",
}
"""Of ``struct``."""

EXTREMES: dict[RawSample, tuple[float, float]] = {
    "i8": (-128, 127),
    "u8": (0, 255),
    "i16": (-32768, 32767),
    "u16": (0, 65535),
    "i32": (-(2**31), 2**31 - 1),
    "u32": (0, 2**32 - 1),
    "i64": (-(2**53), 2**53),
    "u64": (0, 2**53),
    "f32": (-1.5, 2.0**127),
    "f64": (-1e-9, 1e99),
}

ROWS, COLUMNS = 4, 6


def grid_of(path: Path, samples: RawSamples, void: float | None = None) -> ElevationGrid:
    """A grid that is copied; a planet where it wraps."""
    step = 360.0 / samples.columns if samples.wraps else 1e-4
    return ElevationGrid(
        path=path,
        data_path=path,
        layout=samples.decoded(1.0, 1.0, void=void),
        georeference=Georeference("", Ellipsoid.sphere(1e6), Geographic(), 0.0, 1.0, step, 1e-4, ""),
        title="",
        format="",
        decoding=Decoding.of_raw(samples),
    )


def heights_of(grid: ElevationGrid) -> list[list[float | None]]:
    """Every sample."""
    samples = grid.open()
    return [
        [samples.elevation(column, row) for column in range(grid.layout.columns)]
        for row in range(grid.layout.rows)
    ]


def interleaved(
    order: str, code: str, bands: list[list[list[int]]], arrangement: str
) -> tuple[bytes, int, int]:
    """Bytes of bands, and the strides of one; ``arrangement``: BSQ, BIL or BIP."""
    rows, columns, size = len(bands[0]), len(bands[0][0]), calcsize(order + code)
    places = {
        "BSQ": [(b, r, c) for b in range(len(bands)) for r in range(rows) for c in range(columns)],
        "BIL": [(b, r, c) for r in range(rows) for b in range(len(bands)) for c in range(columns)],
        "BIP": [(b, r, c) for r in range(rows) for c in range(columns) for b in range(len(bands))],
    }[arrangement]
    data = b"".join(pack(order + code, bands[b][r][c]) for b, r, c in places)
    pixel = size * len(bands) if arrangement == "BIP" else size
    row = columns * size * (1 if arrangement == "BSQ" else len(bands))
    return data, pixel, row


@pytest.mark.parametrize("sample", list(CODES))
@pytest.mark.parametrize(("byte_order", "order"), [("big", ">"), ("little", "<")])
def test_every_type_keeps_its_extremes(
    tmp_path: Path, sample: RawSample, byte_order: str, order: str
) -> None:
    low, high = EXTREMES[sample]
    path = tmp_path / "raw"
    values = [low, high, 0, 1] if "f" in sample else [int(low), int(high), 0, 1]
    path.write_bytes(b"head" + pack(f"{order}4{CODES[sample]}", *values))
    assert byte_order in {"big", "little"}
    samples = RawSamples(2, 2, sample, "big" if order == ">" else "little", offset=4)
    grid = grid_of(path, samples)
    assert grid.layout.sample == DECODED[sample]
    assert heights_of(grid) == [[low, high], [0.0, 1.0]]


@pytest.mark.parametrize("arrangement", ["BSQ", "BIL", "BIP"])
@pytest.mark.parametrize("sample", ["u8", "i16", "u32"])
@pytest.mark.parametrize("band", [0, 1, 2])
def test_one_band_among_others(tmp_path: Path, arrangement: str, sample: RawSample, band: int) -> None:
    bands = [[[100 * b + 10 * r + c for c in range(COLUMNS)] for r in range(ROWS)] for b in range(2)]
    bands.append([[255 - c for c in range(COLUMNS)] for _ in range(ROWS)])
    data, pixel, row = interleaved("<", CODES[sample], bands, arrangement)
    (tmp_path / "raw").write_bytes(data)
    size = RAW_BYTES[sample]
    before = {"BSQ": ROWS * COLUMNS * size, "BIL": COLUMNS * size, "BIP": size}[arrangement]
    samples = RawSamples(
        ROWS, COLUMNS, sample, "little", offset=band * before, pixel_stride=pixel, row_stride=row
    )
    assert samples.byte_length <= len(data)
    assert heights_of(grid_of(tmp_path / "raw", samples)) == bands[band]


def test_rows_from_south_to_north_are_turned_over(tmp_path: Path) -> None:
    heights = rough(ROWS, COLUMNS)
    data = b"".join(pack(">h", height) for row in reversed(heights) for height in row)
    (tmp_path / "raw").write_bytes(data)
    grid = grid_of(tmp_path / "raw", RawSamples(ROWS, COLUMNS, "i16", "big", south_first=True))
    assert heights_of(grid) == heights
    assert heights_of(grid.region(Region(1, 1, 3, 2))) == [row[1:4] for row in heights[1:3]]


def test_columns_across_the_seam_are_brought_together(tmp_path: Path) -> None:
    heights = rough(ROWS, COLUMNS)
    (tmp_path / "raw").write_bytes(b"".join(pack("<h", height) for row in heights for height in row))
    grid = grid_of(tmp_path / "raw", RawSamples(ROWS, COLUMNS, "i16", "little", wraps=True))
    for first in range(COLUMNS):
        for columns in range(2, COLUMNS + 1):
            part = grid.region(Region(first, 1, columns, 2))
            wanted = [[row[(first + column) % COLUMNS] for column in range(columns)] for row in heights[1:3]]
            assert heights_of(part) == wanted


def test_a_region_of_a_region_across_the_seam(tmp_path: Path) -> None:
    heights = rough(ROWS, COLUMNS)
    (tmp_path / "raw").write_bytes(b"".join(pack("<h", height) for row in heights for height in row))
    grid = grid_of(tmp_path / "raw", RawSamples(ROWS, COLUMNS, "i16", "little", wraps=True))
    part = grid.region(Region(4, 0, 5, 4)).region(Region(2, 1, 2, 3))
    assert heights_of(part) == [row[0:2] for row in heights[1:]]


def test_a_mapped_planet_is_copied_across_its_seam(tmp_path: Path) -> None:
    from addon.formats import read_grid

    pair = planet()
    grid = read_grid(pair.write(tmp_path))
    part = grid.region(Region(350, 80, 20, 10))
    assert part.decoding is not None
    wanted = [[row[(350 + column) % 360] for column in range(20)] for row in pair.heights[80:90]]
    assert heights_of(part) == wanted


def test_scale_offset_and_void_stay_what_they_are(tmp_path: Path) -> None:
    (tmp_path / "raw").write_bytes(bytes([1, 255, 3, 4]))
    samples = RawSamples(2, 2, "u8", "big")
    layout = samples.decoded(1.0, 1.0, scale=0.5, value_offset=10.0, void=255.0)
    grid = replace(grid_of(tmp_path / "raw", samples), layout=layout)
    assert heights_of(grid) == [[10.5, None], [11.5, 12.0]]


def test_bits_of_doubles_are_kept(tmp_path: Path) -> None:
    bits = [0x7FF8_0000_DEAD_BEEF, 0xC059_0000_0000_0001, 0x0000_0000_0000_0001, 0x4059_0000_0000_0000]
    for order, wanted in ((">", "big"), ("<", "little")):
        (tmp_path / "raw").write_bytes(pack(f"{order}4Q", *bits))
        samples = RawSamples(2, 2, "f64", "big" if wanted == "big" else "little")
        heights = heights_of(grid_of(tmp_path / "raw", samples))
        assert heights[0][0] is None
        assert heights[0][1] == unpack(">d", pack(">Q", bits[1]))[0]
        assert heights[1] == [5e-324, 100.0]


def test_only_what_is_wanted_is_read(tmp_path: Path) -> None:
    path = tmp_path / "sparse"
    with path.open("wb") as file:
        file.seek(3_000_000_000 * 2 - 8)
        file.write(pack("<4h", 1, 2, 3, 4))
    samples = RawSamples(30_000, 100_000, "i16", "little")
    grid = grid_of(path, samples).region(Region(99_998, 29_998, 2, 2))
    assert heights_of(grid) == [[0.0, 0.0], [3.0, 4.0]]


def test_a_written_decoding_is_read_again() -> None:
    samples = RawSamples(
        3, 2**31, "u8", "little", offset=2**40, pixel_stride=7, row_stride=2**35, south_first=True, wraps=True
    )
    assert RawSamples.kept(Decoding.of_raw(samples).options["samples"]) == samples
    layout = GridLayout(
        2, 3, cell_width=1.0, cell_height=1.0, sample="u16", offset=9, row_stride=20, wraps=True
    )
    assert RawSamples.of(layout).byte_length == layout.byte_length


def test_copying_can_be_cancelled(tmp_path: Path) -> None:
    (tmp_path / "raw").write_bytes(bytes(4))
    grid = grid_of(tmp_path / "raw", RawSamples(2, 2, "u8", "big"))
    progress = Progress()
    grid.open(progress)
    assert progress.share == 1.0
    progress.cancel()
    with pytest.raises(CancelledError):
        grid.open(progress)


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"rows": 5}, "length"),
        ({"offset": 1}, "length"),
        ({"offset": 2**60}, "length"),
        ({"row_stride": 2**60}, "length"),
        ({"rows": 2**32 - 1, "row_stride": 2**63}, "length"),
        ({"row_stride": 11}, "row_stride"),
        ({"row_stride": 0}, "row_stride"),
        ({"pixel_stride": 1}, "pixel_stride"),
        ({"pixel_stride": 0}, "pixel_stride"),
        ({"pixel_stride": 2**62}, "row_stride"),
        ({"columns": 0}, "columns and rows"),
        ({"rows": 3}, "region"),
        ({"columns": 5}, "region"),
        ({"sample": "u16"}, "sample type"),
        ({"rows": 2**40}, "samples"),
        ({"offset": -1}, "samples"),
        ({"sample": "u24"}, "samples"),
        ({"byte_order": "middle"}, "samples"),
    ],
)
def test_places_that_cannot_be(tmp_path: Path, changes: dict[str, object], field: str) -> None:
    (tmp_path / "raw").write_bytes(bytes(ROWS * COLUMNS * 2))
    samples = RawSamples(ROWS, COLUMNS, "i16", "big", row_stride=2 * COLUMNS)
    grid = grid_of(tmp_path / "raw", samples)
    spoilt = Decoding("raw", options={"samples": {**samples.properties(), **changes}})
    with pytest.raises((FormatError, ValueError), match="expected") as caught:
        replace(grid, decoding=spoilt).open()
    if field != "samples":
        assert str(caught.value).startswith(f"raw: {field}: found")


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "missing"):
        with pytest.raises(FormatError):
            grid_of(path, RawSamples(2, 2, "u8", "big")).open()
