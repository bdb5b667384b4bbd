"""Sessions on the clock. Nothing here depends on how fast the machine is."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from itertools import pairwise
from pathlib import Path

import pytest
from proxygraph import Session, SessionError, SimulatedDevice, Window

from tests.native.grounds import flat, hills
from tests.native.touching import pressing, touch, wait_until, wandering

TASKS = Path("/proc/self/task")

needs_proc = pytest.mark.skipif(not TASKS.is_dir(), reason="this system does not list a process's threads")


def servo_threads() -> int:
    names = []
    for task in TASKS.iterdir():
        try:
            names.append((task / "comm").read_text().strip())
        except OSError:
            continue  # It ended meanwhile.
    return names.count("haptic-servo")


def test_a_live_session_counts_its_ticks_and_gives_every_one() -> None:
    session = touch(flat(), pressing())
    session.start()
    assert session.running
    wait_until(lambda: session.state().force[2] > 0.0)
    first = session.drain()
    wait_until(lambda: session.statistics().ticks >= len(first) + 20)
    session.stop()
    assert not session.running
    numbers = first.column("tick").tolist()
    times = first.column("time").tolist()
    rest = session.drain()
    numbers += rest.column("tick").tolist()
    times += rest.column("time").tolist()
    counts = session.statistics()
    assert numbers == list(range(1, counts.ticks + 1))
    assert all(one < other for one, other in pairwise(times))
    # A millisecond for every tick done or missed, and the last may be late by less than one.
    assert times[-1] < (counts.ticks + counts.missed_ticks + 1) / 1000
    assert counts.dropped == 0
    assert session.state().force == (0.0, 0.0, 0.0), "a session that stands gives no force"


def test_starting_twice_and_stepping_live_are_refused_in_words() -> None:
    session = touch(flat(), pressing())
    session.start()
    with pytest.raises(SessionError, match="already runs"):
        session.start()
    with pytest.raises(SessionError, match=r"live.*stop it"):
        session.step(1)
    assert session.running, "a refused call changes nothing"
    session.stop()


def test_stopping_is_harmless_and_a_stopped_session_goes_on() -> None:
    session = touch(flat(), pressing())
    session.stop()
    session.start()
    session.stop()
    session.stop()
    before = session.statistics().ticks
    session.step(2)
    assert session.statistics().ticks == before + 2
    session.start()
    wait_until(lambda: session.statistics().ticks > before + 2)
    session.stop()
    assert session.fault is None


@needs_proc
def test_dropping_the_object_ends_its_thread() -> None:
    before = servo_threads()
    session = touch(flat(), pressing())
    assert servo_threads() == before
    session.start()
    wait_until(lambda: servo_threads() == before + 1)
    other = touch(flat(), SimulatedDevice())
    other.start()
    wait_until(lambda: servo_threads() == before + 2)
    del session
    wait_until(lambda: servo_threads() == before + 1)
    assert other.running
    del other
    wait_until(lambda: servo_threads() == before)


def test_targets_and_windows_reach_a_live_session() -> None:
    session = touch(flat(), SimulatedDevice())
    session.start()
    session.set_target(0.0, 0.0, -0.02)
    wait_until(lambda: session.state().force[2] > 1.0)
    session.set_window(Window(10.0, -20.0, -100.0, width=16.0))
    # The window's floor lies far under ground, where nothing is touched.
    wait_until(lambda: session.state().goal[2] < -90.0)
    assert not session.state().in_contact
    session.stop()


def test_a_session_may_be_watched_and_stopped_from_other_threads() -> None:
    session = touch(hills(), wandering())
    session.start()
    seen: list[int] = []
    failures: list[BaseException] = []

    def watch() -> None:
        try:
            while session.running:
                seen.append(session.state().tick)
                session.drain()
        except BaseException as failure:
            failures.append(failure)

    watchers = [threading.Thread(target=watch) for _ in range(3)]
    for watcher in watchers:
        watcher.start()
    wait_until(lambda: session.statistics().ticks > 50)
    session.stop()
    for watcher in watchers:
        watcher.join(60.0)
        assert not watcher.is_alive()
    assert failures == []
    assert max(seen) > 0


def steps_while_another_thread_runs(session: Session, tries: int) -> bool:
    """Whether another Python thread did something while ``step`` ran."""
    done = threading.Event()
    rounds = 0

    def go_round() -> None:
        nonlocal rounds
        while not done.is_set():
            rounds += 1
            time.sleep(0.0)

    # Threads now change only where one of them lets go of the interpreter by itself.
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000.0)
    other = threading.Thread(target=go_round)
    other.start()
    try:
        for _ in range(tries):
            before = rounds
            session.step(20_000)
            if rounds > before:
                return True
        return False
    finally:
        done.set()
        other.join()
        sys.setswitchinterval(interval)


def test_stepping_lets_other_threads_run() -> None:
    assert steps_while_another_thread_runs(touch(hills(), wandering()), 100)


def test_stepping_is_ended_by_control_c() -> None:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it
    session = touch(flat(), pressing())
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    timer.start()
    asked = 2**62
    try:
        with pytest.raises(KeyboardInterrupt):
            session.step(asked)
    finally:
        signal.signal(signal.SIGINT, before)
    timer.join()
    assert 0 < session.state().tick < asked


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
@pytest.mark.filterwarnings("ignore:.*multi-threaded, use of fork.*:DeprecationWarning")
def test_a_forked_child_lets_go_of_a_running_session() -> None:
    session = touch(flat(), pressing())
    session.start()
    child = os.fork()
    if child == 0:
        ended = not session.running and "forked" in (session.fault or "")
        session.stop()
        os._exit(0 if ended and not session.running else 1)
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 0
    assert session.running
    session.stop()
