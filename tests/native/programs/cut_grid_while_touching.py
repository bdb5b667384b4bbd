"""Touch a mapped grid live, cut its file in mid-contact, and print how touch ended, as JSON.

Arguments: a scratch file, and when to enable faulthandler: never, before proxygraph is imported, or after
the grid is opened.
"""

from __future__ import annotations

import faulthandler
import json
import os
import struct
import sys
import time
from collections.abc import Callable
from pathlib import Path

SIDE = 512


def main(scratch: Path, reports_faults: str) -> None:
    if reports_faults == "before":
        faulthandler.enable()
    from proxygraph import Grid, GridLayout, ScriptedDevice, Session, SessionError, Window

    scratch.write_bytes(struct.pack(">h", 7) * SIDE * SIDE)
    layout = GridLayout(SIDE, SIDE, cell_width=1.0, cell_height=1.0)
    grid = Grid.open(scratch, layout)
    if reports_faults == "after":
        faulthandler.enable()

    path = [(0.0, 0.0, 0.0, 0.02), (0.02, 0.0, 0.0, -0.01)]
    session = Session(grid, ScriptedDevice(path), Window(SIDE / 2, -SIDE / 2, 7.0, width=16.0))
    session.start()
    wait_until(lambda: session.state().force[2] > 0.0)
    was_damaged = grid.damaged
    os.truncate(scratch, 0)
    wait_until(lambda: not session.running)

    state = session.state()
    try:
        session.start()
        refused = ""
    except SessionError as error:
        refused = str(error)
    print(
        json.dumps(
            {
                "fault": session.fault,
                "force": state.force,
                "was_damaged": was_damaged,
                "damaged": grid.damaged,
                "reads": grid.elevation(SIDE - 1, SIDE - 1),
                "refused": refused,
            }
        )
    )


def wait_until(happened: Callable[[], bool]) -> None:
    end = time.monotonic() + 60.0
    while not happened():
        if time.monotonic() > end:
            sys.exit("it did not happen within a minute")
        time.sleep(0.001)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2])
