"""Read a cut file through a mapping of Python's own while a grid is open: this has to end the process.

Arguments: a scratch folder, when to enable faulthandler (never, before or after the grid is opened, or
between two grids), and whether the grid's file is cut too (whole or cut).
"""

from __future__ import annotations

import faulthandler
import mmap
import os
import resource
import sys
from pathlib import Path


def main(scratch: Path, reports_faults: str, grid_file: str) -> None:
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if reports_faults == "before":
        faulthandler.enable()
    from proxygraph import Grid, GridLayout

    mapped = scratch / "mapped.img"
    mapped.write_bytes(bytes(1 << 16))
    grid = Grid.open(mapped, GridLayout(2, 2, cell_width=1.0, cell_height=1.0))
    if reports_faults in ("after", "between"):
        faulthandler.enable()
    if reports_faults == "between":
        second = scratch / "second.img"
        second.write_bytes(bytes(1 << 16))
        grids = [grid, Grid.open(second, GridLayout(2, 2, cell_width=1.0, cell_height=1.0))]
        assert not any(opened.damaged for opened in grids)
    if grid_file == "cut":
        os.truncate(mapped, 0)

    own = scratch / "own.bin"
    own.write_bytes(bytes(1 << 16))
    with own.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as mapping:
        os.truncate(own, 0)
        print("reading", flush=True)
        print(mapping[100])
    print("lived on", grid.damaged)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], sys.argv[3])
