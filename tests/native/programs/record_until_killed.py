"""Record live until the end of this process, printing after each look how many ticks the spool has.

Argument: the file to spool to.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

ROOT = str(Path(__file__).resolve().parents[3])

if ROOT not in sys.path:
    sys.path.append(ROOT)

from tests.native.grounds import flat  # noqa: E402
from tests.native.touching import pressing, touch  # noqa: E402


def main(spool: Path) -> None:
    session = touch(flat(), pressing())
    session.start_recording('{"terrain": "flat"}', spool=spool)
    session.start()
    while session.running:
        recording = session.recording
        assert recording is not None
        print(recording.spooled, flush=True)
        time.sleep(0.01)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
