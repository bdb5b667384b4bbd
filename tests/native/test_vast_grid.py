"""A grid larger than memory should be asked to hold."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

PROGRAM = Path(__file__).parent / "programs" / "touch_vast_grid.py"
FOUR_GIGABYTES = 1 << 32

pytestmark = pytest.mark.skipif(
    not Path("/proc/self/status").is_file(), reason="this system does not tell a process's resident memory"
)


@pytest.fixture
def vast_file(tmp_path: Path) -> Iterator[Path]:
    """Four gigabytes that take no room."""
    path = tmp_path / "vast.img"
    path.touch()
    os.truncate(path, FOUR_GIGABYTES)
    yield path
    path.unlink()


def test_four_gigabytes_are_touched_in_little_memory(vast_file: Path) -> None:
    ended = subprocess.run(
        [sys.executable, str(PROGRAM), str(vast_file)],
        capture_output=True,
        text=True,
        timeout=180,
        check=True,
    )
    told = json.loads(ended.stdout)
    assert told["layout_bytes"] == FOUR_GIGABYTES
    assert told["fault"] is None
    assert told["contact_ticks"] > 4000
    assert told["cells"] > 60_000
    assert told["live_ticks"] >= 500
    assert told["opened_kilobytes"] < 5_000
    assert told["touched_kilobytes"] < 50_000
