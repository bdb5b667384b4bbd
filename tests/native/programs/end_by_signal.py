"""Be ended by SIGBUS from outside while a grid is open: this has to work.

Arguments: the file for the grid, and whether it is cut meanwhile (whole or cut).
"""

from __future__ import annotations

import os
import resource
import signal
import sys
from pathlib import Path


def main(path: Path, grid_file: str) -> None:
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    from proxygraph import Grid, GridLayout

    path.write_bytes(bytes(1 << 16))
    grid = Grid.open(path, GridLayout(2, 2, cell_width=1.0, cell_height=1.0))
    if grid_file == "cut":
        os.truncate(path, 0)
    os.kill(os.getpid(), signal.SIGBUS)
    print("lived on", grid.damaged)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2])
