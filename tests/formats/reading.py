"""What tests of readers ask."""

from __future__ import annotations

from pathlib import Path

import pytest

from addon.formats import ElevationGrid, FormatError, read_grid
from addon.formats.decoders import DECODERS

SHARED = Path(__file__).resolve().parents[3] / "shared" / "data"
"""Real grids that may lie beside the checkout."""

needs_raw_decoder = pytest.mark.skipif("raw" not in DECODERS, reason="the decoder of raw samples is not here")


def needs(name: str) -> pytest.MarkDecorator:
    """Skip where a real grid is not there."""
    return pytest.mark.skipif(
        not (SHARED / name).is_file(), reason=f"the real {name} is not beside the checkout"
    )


def complaint(path: Path) -> str:
    """The text of the error that reading the file raises."""
    with pytest.raises(FormatError) as caught:
        read_grid(path)
    return str(caught.value)


def assert_looked_through(grid: ElevationGrid) -> None:
    """Check the range and the voids that the reader found against all samples."""
    found = grid.open().range()
    if found is None:
        assert (grid.range, grid.voids) == (None, grid.samples)
        return
    assert grid.range == pytest.approx((found.minimum, found.maximum), rel=1e-6)
    assert grid.voids == found.voids


def heights(grid: ElevationGrid) -> list[list[float | None]]:
    """Every elevation of a small grid, metres; ``None`` where void."""
    samples = grid.open()
    return [
        [samples.elevation(column, row) for column in range(grid.layout.columns)]
        for row in range(grid.layout.rows)
    ]
