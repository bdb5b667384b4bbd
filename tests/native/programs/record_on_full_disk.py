"""Record stepped where files may have 1 MB only, and print what became of the take, as JSON.

Argument: the file to spool to.
"""

from __future__ import annotations

import json
import resource
import sys
from pathlib import Path

ROOT = str(Path(__file__).resolve().parents[3])

if ROOT not in sys.path:
    sys.path.append(ROOT)

from tests.native.grounds import flat  # noqa: E402
from tests.native.touching import pressing, touch  # noqa: E402


def main(spool: Path) -> None:
    session = touch(flat(), pressing())
    session.start_recording(spool=spool)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1_000_000, resource.RLIM_INFINITY))
    for _ in range(10):
        session.step(1000)
    recording = session.recording
    assert recording is not None
    warnings = session.warnings()
    take = session.stop_recording()
    print(
        json.dumps(
            {
                "ticks": len(take),
                "spooled": recording.spooled,
                "failures": [recording.spool_failure, take.spool_failure],
                "warnings": warnings,
            }
        )
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]))
