#!/usr/bin/env python3
"""Write the synthetic sample grid: a Mars-like planet as a MEGDR pair, the same bytes every time."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from sample_grid.megdr import write_pair
from sample_grid.planet import elevations

ROWS, COLUMNS = 720, 1440
"""4 cells per degree, as in MOLA's product C."""


def make_sample(folder: Path) -> Path:
    """Write ``sample.lbl`` and ``sample.img``; gives the label's path."""
    return write_pair(folder, "sample", elevations(ROWS, COLUMNS))


def main(arguments: list[str]) -> int:
    """Exit code 0 when written, 2 for wrong usage, 1 where the folder cannot be written."""
    parser = argparse.ArgumentParser(
        description=__doc__, epilog="The planet is invented: do not read Mars out of it."
    )
    parser.add_argument(
        "--output",
        type=Path,
        default=Path("build/sample"),
        help="folder for sample.lbl and sample.img (%(default)s)",
    )
    chosen = parser.parse_args(arguments)
    try:
        label = make_sample(chosen.output)
    except OSError as error:
        print(f"The sample grid cannot be written: {error}", file=sys.stderr)
        return 1
    print(f"Synthetic sample grid: {label}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
