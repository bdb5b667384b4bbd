"""Takes: every tick in memory and on the disk, as Python sees them."""

from __future__ import annotations

import json
import math
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from proxygraph import (
    ScriptedDevice,
    Session,
    SessionError,
    Take,
    TakeError,
    TakeInUseError,
    Ticks,
    claim_take,
    read_take,
)

from tests.native.grounds import flat, hills
from tests.native.touching import pressing, touch, wait_until, wandering

PROGRAMS = Path(__file__).parent / "programs"


def recorded(session: Session, ticks: int, spool: Path | None = None) -> Take:
    session.start_recording('{"about": "hills"}', spool=spool)
    session.step(ticks)
    return session.stop_recording()


def bits(take: Take) -> list[bytes]:
    """All columns."""
    return [take.column(name).tobytes() for name in take.columns]


def test_a_take_has_the_columns_of_drained_ticks() -> None:
    session = touch(hills(), wandering())
    session.step(10)
    session.drain()
    take = recorded(session, 700)
    ticks = session.drain()
    assert len(take) == len(ticks) == 700
    assert take.seconds == pytest.approx(0.699)
    assert set(take.columns) < set(Ticks.columns)
    for name in take.columns:
        in_take, in_ticks = take.column(name).tolist(), ticks.column(name).tolist()
        assert in_take == pytest.approx(in_ticks, rel=1e-6), name
        if not name.startswith("normal"):  # floats of 32 bits
            assert take.column(name).tobytes() == ticks.column(name).tobytes(), name
    assert {1.0} < set(take.column("feature").tolist())


def test_normals_are_unit_vectors_in_contact_and_zero_in_free_space() -> None:
    take = recorded(touch(hills(), wandering()), 900)
    normals = zip(*(take.column(f"normal_{axis}").tolist() for axis in "xyz"), strict=True)
    lengths = [math.hypot(*normal) for normal in normals]
    for length, feature in zip(lengths, take.column("feature").tolist(), strict=True):
        assert length == pytest.approx(float(feature != 0.0), abs=1e-6)


def test_the_normal_is_where_the_force_points_without_friction() -> None:
    take = recorded(touch(hills(), pressing(0.03)), 500)
    force = [take.column(f"force_{axis}")[499] for axis in "xyz"]
    newtons = math.hypot(*force)
    assert newtons > 0.1
    normal = [take.column(f"normal_{axis}")[499] for axis in "xyz"]
    assert normal == pytest.approx([part / newtons for part in force], abs=1e-6)


def test_buttons_and_twist_are_kept_and_a_key_is_the_stylus_button() -> None:
    path = [(0.0, 0.0, 0.0, 0.02)]
    device = ScriptedDevice(path, handle=[(0.0, 0.5, 0), (0.1, 0.5, 2)])
    session = touch(flat(), device, modes=True)
    session.start_recording()
    session.step(200)
    session.press()
    session.step(1)
    take = session.stop_recording()
    assert take.column("buttons").tolist() == [0.0] * 99 + [2.0] * 101 + [3.0]
    assert set(take.column("twist").tolist()) == {0.5}
    plain = recorded(touch(flat(), pressing()), 1)
    assert plain.column("twist").tolist() == [0.0]


def test_ten_minutes_at_full_speed_lose_nothing() -> None:
    session = touch(flat(), pressing())
    take = recorded(session, 600_000)
    assert (len(take), take.dropped, session.statistics().dropped) == (600_000, 0, 0)
    assert take.column("tick").tolist() == list(range(1, 600_001))


def test_an_unknown_column_is_named() -> None:
    with pytest.raises(KeyError, match=r"'depth' is not one of Take\.columns"):
        recorded(touch(flat(), pressing()), 1).column("depth")


def test_a_spool_becomes_a_whole_take_and_is_removed_on_demand(tmp_path: Path) -> None:
    spool = tmp_path / "take.touch"
    session = touch(hills(), wandering())
    session.set_pre_roll(0.1)
    session.step(500)
    take = recorded(session, 700, spool)
    read = read_take(spool)
    assert bits(read) == bits(take)
    assert (read.about, read.workspace, read.pre_roll) == ('{"about": "hills"}', (0.16, 0.12, 0.12), 100)
    assert (read.finished, read.lost, read.dropped) == (True, None, 0)
    with pytest.raises(TakeInUseError, match="recorded, or recovered"):
        claim_take(spool)
    take.discard_spool()
    take.discard_spool()
    assert not spool.exists()


def test_a_take_is_saved_over_an_older_one_or_not_at_all(tmp_path: Path) -> None:
    path = tmp_path / "take.touch"
    for ticks in (300, 20):
        take = recorded(touch(hills(), wandering()), ticks)
        take.save(path)
        assert bits(read_take(path)) == bits(take)
    with pytest.raises(OSError, match="missing") as refused:
        take.save(tmp_path / "missing" / "take.touch")
    assert refused.value.filename == str(tmp_path / "missing" / "take.touch")
    assert [file.name for file in tmp_path.iterdir()] == ["take.touch"]


def test_what_was_recorded_so_far_stays_as_it_was() -> None:
    session = touch(hills(), wandering())
    session.start_recording()
    session.step(1500)
    so_far = session.recorded()
    session.step(1500)
    assert (len(so_far), so_far.finished) == (1500, False)
    take = session.stop_recording()
    assert bits(so_far) == [take.column(name)[:1500].tobytes() for name in take.columns]


def test_one_take_at_a_time(tmp_path: Path) -> None:
    session = touch(flat(), pressing())
    for refused in (session.recorded, session.stop_recording):
        with pytest.raises(SessionError, match="no take is being recorded"):
            refused()
    assert session.recording is None
    session.start_recording()
    with pytest.raises(SessionError, match="recorded already"):
        session.start_recording(spool=tmp_path / "take.touch")
    assert not (tmp_path / "take.touch").exists()


def test_a_spool_that_cannot_be_made_is_refused_and_nothing_is_recorded(tmp_path: Path) -> None:
    session = touch(flat(), pressing())
    (tmp_path / "there").write_text("precious")
    with pytest.raises(FileExistsError):
        session.start_recording(spool=tmp_path / "there")
    assert (tmp_path / "there").read_text() == "precious"
    with pytest.raises(FileNotFoundError):
        session.start_recording(spool=tmp_path / "missing" / "take.touch")
    with pytest.raises(ValueError, match="at most 1048576"):
        session.start_recording(" " * 2_000_000, spool=tmp_path / "take.touch")
    assert session.recording is None
    assert [file.name for file in tmp_path.iterdir()] == ["there"]


def test_a_pre_roll_that_cannot_be_is_refused() -> None:
    for seconds in (-1.0, math.nan, 3600.1):
        with pytest.raises(ValueError, match="pre_roll"):
            touch(flat(), pressing()).set_pre_roll(seconds)


def test_what_is_no_take_is_told(tmp_path: Path) -> None:
    file = tmp_path / "file"
    with pytest.raises(FileNotFoundError) as missing:
        read_take(file)
    assert missing.value.filename == str(file)
    file.write_bytes(b"a label")
    with pytest.raises(TakeError, match=r"file: this is no take"):
        read_take(file)
    recorded(touch(flat(), pressing()), 10).save(file)
    whole = file.read_bytes()
    file.write_bytes(whole[:30])
    with pytest.raises(TakeError, match="cut within its header"):
        read_take(file)
    file.write_bytes(whole[:8] + b"\x07" + whole[9:])
    with pytest.raises(TakeError, match="version 7 of the format, expected 1"):
        read_take(file)
    file.write_bytes(whole[:-40])
    take = read_take(file)
    assert (len(take), take.finished) == (0, False)
    assert take.lost is not None
    assert "cut short" in take.lost


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_a_process_that_is_killed_loses_nothing_that_was_spooled(tmp_path: Path) -> None:
    spool = tmp_path / "take.touch"
    command = [sys.executable, str(PROGRAMS / "record_until_killed.py"), str(spool)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        spooled = 0
        while spooled < 500:
            spooled = int(process.stdout.readline())
        with pytest.raises(TakeInUseError):
            claim_take(spool)
        os.kill(process.pid, signal.SIGKILL)
    take = claim_take(spool)
    assert len(take) >= spooled
    assert (take.finished, take.about, take.dropped) == (False, '{"terrain": "flat"}', 0)
    ticks = take.column("tick").tolist()
    assert ticks == list(range(1, len(take) + 1))
    take.discard_spool()
    assert not spool.exists()


@pytest.mark.skipif(sys.platform == "win32", reason="limits on files")
def test_a_disk_that_is_full_ends_the_spool_and_not_the_take(tmp_path: Path) -> None:
    spool = tmp_path / "take.touch"
    command = [sys.executable, str(PROGRAMS / "record_on_full_disk.py"), str(spool)]
    told = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert told["ticks"] == 10_000
    assert told["spooled"] == 5000
    assert all("File too large" in failure for failure in told["failures"])
    assert "in memory only" in told["warnings"][0]
    assert str(spool) in told["warnings"][0]
    left = claim_take(spool)
    assert len(left) == 5000
    assert left.lost is not None


def test_a_live_take_is_whole_whoever_looks(tmp_path: Path) -> None:
    session = touch(flat(), pressing())
    session.start()
    session.start_recording(spool=tmp_path / "take.touch")
    wait_until(lambda: session.recording is not None and session.recording.spooled > 120)
    take = session.stop_recording()
    session.stop()
    ticks = take.column("tick").tolist()
    assert ticks == [ticks[0] + number for number in range(len(ticks))]
    assert take.dropped == 0
    assert bits(read_take(tmp_path / "take.touch")) == bits(take)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_fork_leaves_the_take_to_its_parent(tmp_path: Path) -> None:
    session = touch(flat(), pressing())
    session.start_recording(spool=tmp_path / "take.touch")
    session.start()
    wait_until(lambda: session.recording is not None and session.recording.spooled > 0)
    child = os.fork()
    if child == 0:
        session.stop()
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    take = session.stop_recording()
    session.stop()
    assert bits(read_take(tmp_path / "take.touch")) == bits(take)
    with pytest.raises(TakeInUseError):
        claim_take(tmp_path / "take.touch")
