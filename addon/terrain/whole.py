"""Files that are cut while they are mapped: what is lost reads as zeros, which are no heights."""

from __future__ import annotations

from proxygraph import Grid

from ..formats import ElevationGrid, FormatError


def refuse_damaged(grid: ElevationGrid, *opened: Grid) -> None:
    """Fail where the mapped file of any of these samples was cut since it was opened.

    Raises:
        FormatError: naming the grid's file.
    """
    if not any(samples.damaged for samples in opened):
        return
    what = "a file" if grid.decoding is None else "a cache file of its samples"
    raise FormatError(
        grid.data_path,
        "samples",
        found=f"{what} that was cut while it was read",
        expected="one that stays whole",
        way_out="Put the whole file back where nothing writes to it, and import the grid again.",
    )
