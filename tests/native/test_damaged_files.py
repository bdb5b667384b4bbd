"""What happens to a process whose mapped grid is cut: seen from outside, because it might end."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from proxygraph import Grid, GridLayout, ScriptedDevice, SessionError

from tests.native.touching import touch

PROGRAMS = Path(__file__).parent / "programs"

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="a mapped file is cut as Linux allows it")

WHEN_FAULTS_ARE_REPORTED = ["never", "before", "after"]


def run(program: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(PROGRAMS / program), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=180, check=False)


@pytest.mark.parametrize("reports_faults", WHEN_FAULTS_ARE_REPORTED)
def test_a_grid_cut_in_mid_contact_ends_touch_and_not_the_process(
    tmp_path: Path, reports_faults: str
) -> None:
    ended = run("cut_grid_while_touching.py", str(tmp_path / "grid.img"), reports_faults)
    assert ended.returncode == 0, ended.stderr
    told = json.loads(ended.stdout)
    assert "file was cut while in use" in told["fault"]
    assert told["refused"] == told["fault"], "it is not started again"
    assert told["force"] == [0.0, 0.0, 0.0]
    assert (told["was_damaged"], told["damaged"]) == (False, True)
    assert told["reads"] == 0.0


@pytest.mark.parametrize("grid_file", ["whole", "cut"])
@pytest.mark.parametrize("reports_faults", [*WHEN_FAULTS_ARE_REPORTED, "between"])
def test_a_fault_elsewhere_still_ends_the_process(
    tmp_path: Path, reports_faults: str, grid_file: str
) -> None:
    ended = run("fault_elsewhere.py", str(tmp_path), reports_faults, grid_file)
    assert ended.returncode == -signal.SIGBUS, ended.stdout
    assert ended.stdout == "reading\n"
    assert ("Bus error" in ended.stderr) == (reports_faults != "never")


def test_a_cut_is_noticed_before_anything_is_read(tmp_path: Path) -> None:
    path = tmp_path / "grid.img"
    path.write_bytes(bytes(1 << 16))
    grid = Grid.open(path, GridLayout(128, 128, cell_width=1.0, cell_height=1.0))
    assert not grid.damaged
    os.truncate(path, 0)
    assert grid.damaged


def test_a_session_whose_hand_rests_elsewhere_stops_when_its_file_is_cut(tmp_path: Path) -> None:
    path = tmp_path / "grid.img"
    path.write_bytes(bytes(1 << 16))
    grid = Grid.open(path, GridLayout(128, 128, cell_width=1.0, cell_height=1.0))
    session = touch(grid, ScriptedDevice([(0.0, 0.0, 0.0, 0.05)]))
    session.step(10)
    os.truncate(path, 1 << 15)
    session.state()
    with pytest.raises(SessionError, match="cut while in use"):
        session.step(1)


@pytest.mark.parametrize("grid_file", ["whole", "cut"])
def test_a_person_can_still_end_the_process_with_this_signal(tmp_path: Path, grid_file: str) -> None:
    ended = run("end_by_signal.py", str(tmp_path / "grid.img"), grid_file)
    assert ended.returncode == -signal.SIGBUS, ended.stdout
