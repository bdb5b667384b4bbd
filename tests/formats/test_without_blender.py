"""Researchers open MOLA without Blender."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.raw_grids import EhdrPair, EnviPair, GridFloatPair, Pds4Pair

ROOT = Path(__file__).resolve().parents[2]

SCRIPT = """
import sys
for name in ("bpy", "mathutils", "bmesh", "bpy_extras", "numpy"):
    sys.modules[name] = None
from pathlib import Path
import addon
from addon.formats import projections, read_grid
from addon.formats.body import bodies
from addon.formats.profiles import profile
from addon.terrain import frame
from addon.touch import recorder
print(read_grid(Path(sys.argv[1])).samples)
"""


def test_every_raw_format_is_read_with_bpy_and_numpy_blocked(tmp_path: Path) -> None:
    square = tmp_path / "N10E020.hgt"
    square.write_bytes(bytes(2 * 601 * 601))
    writers = (EhdrPair().write, GridFloatPair().write, EnviPair().write, Pds4Pair().write)
    paths = [square]
    for number, write in enumerate(writers):
        folder = tmp_path / str(number)
        folder.mkdir()
        paths.append(write(folder))
    script = SCRIPT.replace(
        "print(read_grid(Path(sys.argv[1])).samples)",
        "print([read_grid(Path(path)).open().layout.samples for path in sys.argv[1:]])",
    )
    done = subprocess.run(
        [sys.executable, "-c", script, *map(str, paths)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "[361201, 24, 6, 6, 6]"


def test_a_grid_is_read_with_bpy_blocked(tmp_path: Path) -> None:
    label = MegdrPair(rough(3, 4)).write(tmp_path)
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(label)], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "12"
