"""Researchers open MOLA without Blender."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests.formats.megdr_pair import MegdrPair, rough

ROOT = Path(__file__).resolve().parents[2]

SCRIPT = """
import sys
for name in ("bpy", "mathutils", "bmesh", "bpy_extras", "numpy"):
    sys.modules[name] = None
from pathlib import Path
import addon
from addon.formats import bodies, profile, projections, read_grid
from addon.record import resample
from addon.terrain import frame
from addon.touch import recorder
print(read_grid(Path(sys.argv[1])).samples)
"""


def test_a_grid_is_read_and_ticks_are_resampled_with_bpy_blocked(tmp_path: Path) -> None:
    label = MegdrPair(rough(3, 4)).write(tmp_path)
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(label)], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "12"
