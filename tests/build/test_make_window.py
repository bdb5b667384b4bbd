"""Making the window for tests says what is missing, and where there is one it is used as it is."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / ".ci" / "make-window"


def make_window(folder: Path, **programs: str) -> subprocess.CompletedProcess[str]:
    """Run the script where these programs are what they say, and the cache is the test's own."""
    stand_ins = folder / "bin"
    stand_ins.mkdir()
    for name, script in programs.items():
        program = stand_ins / name.replace("_", "-")
        program.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        program.chmod(0o755)
    environment = {
        "PATH": f"{stand_ins}:{os.defpath}",
        "XDG_CACHE_HOME": str(folder / "cache"),
        "HOME": str(folder),
    }
    return subprocess.run(
        ["bash", str(SCRIPT)], env=environment, capture_output=True, text=True, check=False, timeout=60
    )


@pytest.mark.parametrize(
    ("programs", "missing"),
    [
        ({"uname": "echo Darwin"}, "on Linux only"),
        ({"uname": "echo Linux", "id": "echo 1000"}, "needs root"),
        (
            {
                "uname": "echo Linux",
                "id": "echo 0",
                "debootstrap": "exit 1",
                "apt_get": "echo http://mirror.invalid/ubuntu/",
            },
            "no mirror of Debian",
        ),
    ],
)
def test_what_is_missing_is_said(tmp_path: Path, programs: dict[str, str], missing: str) -> None:
    done = make_window(tmp_path, **programs)
    assert done.returncode == 77
    assert done.stdout == ""
    assert "No window: " in done.stderr
    assert missing in done.stderr
    assert not (tmp_path / "cache").exists()


def test_a_failed_bootstrap_is_no_skip_and_leaves_no_window(tmp_path: Path) -> None:
    done = make_window(
        tmp_path,
        uname="echo Linux",
        id="echo 0",
        debootstrap="echo E: the mirror does not answer; exit 1",
        apt_get="echo http://mirror.invalid/debian/",
    )
    assert done.returncode == 1
    assert "E: the mirror does not answer" in done.stderr
    assert not (tmp_path / "cache/haptic-terrain/window-sid").exists()


def test_a_window_that_is_there_is_used(tmp_path: Path) -> None:
    window = tmp_path / "cache/haptic-terrain/window-sid"
    (window / "usr/bin").mkdir(parents=True)
    (window / "usr/bin/blender").touch()
    done = make_window(tmp_path, id="echo 1000")
    assert done.returncode == 0
    assert done.stdout == f"{window}\n"
