"""What recording costs: ticks that are lost in ten minutes, and bytes a minute; prints JSON.

`python tests/bench/measure_spool.py [OUTPUT]` records ten minutes of touch, stepped at full speed, in memory
and on the disk at once, and writes the figures to OUTPUT too where it is given.
"""

from __future__ import annotations

import json
import struct
import sys
import tempfile
import time
from pathlib import Path

from proxygraph import Grid, GridLayout, ScriptedDevice, Session, Take, Window, read_take

MINUTES = 10
TICKS_A_MINUTE = 60_000
SIDE = 512


def main(output: Path | None) -> None:
    with tempfile.TemporaryDirectory() as folder:
        figures = measured(Path(folder) / "take.touch")
    text = json.dumps(figures, indent=2)
    print(text)
    if output is not None:
        output.write_text(f"{text}\n", encoding="utf-8")


def measured(spool: Path) -> dict[str, float]:
    """Record, and count."""
    session = session_over_waves()
    begin = time.perf_counter()
    session.start_recording(spool=spool)
    session.step(TICKS_A_MINUTE)
    # By then the ring, and what is kept for drains, has all the memory that it will ever have.
    before = resident_bytes()
    session.step((MINUTES - 1) * TICKS_A_MINUTE)
    in_memory = resident_bytes() - before
    take = session.stop_recording()
    seconds = time.perf_counter() - begin
    saved = read_take(spool)
    return {
        "ticks": MINUTES * TICKS_A_MINUTE,
        "ticks_lost_in_10_min": lost(take),
        "ticks_lost_on_disk_in_10_min": lost(saved),
        "record_bytes_per_minute": spool.stat().st_size / MINUTES,
        "memory_bytes_per_minute": in_memory / (MINUTES - 1),
        "seconds": seconds,
    }


def lost(take: Take) -> int:
    """Ticks that are not there, or not in their place."""
    there = set(take.column("tick").tolist())
    return len(set(range(1, MINUTES * TICKS_A_MINUTE + 1)) - there)


def session_over_waves() -> Session:
    """A hand that goes to and fro in a ground of small waves."""
    heights = [(row * 7 + column * 3) % 11 for row in range(SIDE) for column in range(SIDE)]
    layout = GridLayout(SIDE, SIDE, cell_width=1.0, cell_height=1.0)
    grid = Grid.from_buffer(struct.pack(f">{len(heights)}h", *heights), layout)
    path = [
        (number * 0.5, 0.05 * (-1.0) ** number, 0.02 * (-1.0) ** (number // 2), -0.005 if number else 0.1)
        for number in range(MINUTES * 120)
    ]
    window = Window(SIDE / 2, -SIDE / 2, 11.0, width=200.0)
    return Session(grid, ScriptedDevice(path), window)


def resident_bytes() -> int:
    """Memory that this process has now, as Linux counts it."""
    pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
    return pages * 4096


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
