"""Touch a 4 GB grid across its whole width, stepped and live, and print the memory it took, as JSON.

Argument: the grid's file.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

from proxygraph import Grid, GridLayout, ScriptedDevice, Session, Window

COLUMNS, ROWS = 65_536, 32_768
TICKS = 5000
"""Across the map at 13 cells a tick: as fast as a hand swipes (paper 4.4)."""


def main(path: Path) -> None:
    layout = GridLayout(ROWS, COLUMNS, cell_width=1.0, cell_height=1.0)
    before = resident_kilobytes()
    grid = Grid.open(path, layout)
    opened = resident_kilobytes()

    window = Window(COLUMNS / 2, -ROWS / 2, 0.0, width=COLUMNS)
    edge = 0.079
    script = [
        (0.0, -edge, 0.001, 0.001),
        (0.1, -edge, 0.001, -0.0001),
        (TICKS / 1000, edge, -0.001, -0.0001),
    ]
    session = Session(grid, ScriptedDevice(script), window, ring_seconds=1.0)
    session.step(TICKS)
    stepped = session.statistics()
    session.start()
    end = time.monotonic() + 60.0
    while session.statistics().ticks < TICKS + 500 and time.monotonic() < end:
        time.sleep(0.01)
    session.stop()
    print(
        json.dumps(
            {
                "layout_bytes": layout.byte_length,
                "opened_kilobytes": opened - before,
                "touched_kilobytes": resident_kilobytes() - before,
                "cells": stepped.goal_cells,
                "contact_ticks": stepped.contact_ticks,
                "live_ticks": session.statistics().ticks - TICKS,
                "fault": session.fault,
            }
        )
    )


def resident_kilobytes() -> int:
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1])
    raise RuntimeError("the system does not tell a process's resident memory")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
