"""Imports in a thread: progress, cancel, and nothing half-made."""

from __future__ import annotations

from pathlib import Path
from threading import Event
from time import monotonic, sleep
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from proxygraph import Grid

from tests.addon.decoded import copying, decode_everything
from tests.addon.scene import contents, module
from tests.addon.status_bar import said
from tests.formats.megdr_pair import MegdrPair, rough
from tests.formats.usgs_dem_file import DemFile

WAIT = 30.0
"""Seconds after which a thread of a test has failed."""


class Gate:
    """A decoder that tells when it has begun, and waits until it may go on."""

    def __init__(self) -> None:
        self.begun, self.open = Event(), Event()

    def __call__(self, path: Path, layout: Any, decoding: Any, progress: Any) -> Grid:
        progress.step(1, 4)
        self.begun.set()
        assert self.open.wait(WAIT)
        progress.step(2, 4)
        return copying(path, layout, decoding, progress)


@pytest.fixture
def label(tmp_path: Path) -> Path:
    return MegdrPair(rough(9, 13)).write(tmp_path)


def job_of(*paths: Path) -> Any:
    return module("terrain.import_job").ImportJob(paths, module("terrain.options").ImportOptions())


def finish(job: Any) -> Any:
    return job.finish(bpy.context, module("terrain.opened").OpenedGrids())


def test_a_job_shows_where_it_is_and_adds_nothing_before_its_end(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, before = Gate(), contents()
    decode_everything(monkeypatch, gate)
    job = job_of(label)
    job.start()
    assert gate.begun.wait(WAIT)
    assert not job.poll()
    assert 0.05 < job.share < 0.5
    assert job.step == "grid.lbl: Decoding"
    assert contents() == before
    gate.open.set()
    assert [terrain.name for terrain in finish(job).terrains] == ["Mars grid"]
    assert job.poll()
    assert job.share == pytest.approx(1.0, abs=0.2)


def test_a_cancelled_job_ends_in_the_decoder_and_leaves_nothing(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, before = Gate(), contents()
    decode_everything(monkeypatch, gate)
    job = job_of(label, label.with_suffix(".img"))
    job.start()
    assert gate.begun.wait(WAIT)
    job.cancel()
    gate.open.set()
    imported = finish(job)
    assert (imported.terrains, imported.failures) == ([], [])
    assert contents() == before


def looked_through(path: Path, progress: Any) -> None:
    """Stand in for the look at every height of a grid of text."""
    for _ in range(int(WAIT / 0.01)):
        progress.step(1, 2)
        sleep(0.01)
    raise AssertionError(f"{path} was not cancelled")


@pytest.mark.parametrize(
    ("reader", "native", "content"),
    [
        ("esri_ascii", "EsriAscii", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n1 2 3 4\n"),
        ("usgs_dem", "UsgsDem", DemFile().data()),
    ],
)
def test_a_grid_of_text_that_is_looked_through_shows_it_and_can_be_cancelled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, reader: str, native: str, content: str | bytes
) -> None:
    path = tmp_path / "text.grid"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    monkeypatch.setattr(module(f"formats.text.{reader}"), native, SimpleNamespace(open=looked_through))
    job = job_of(path)
    job.start()
    until = monotonic() + WAIT
    while job.share == 0.0 and monotonic() < until and not job.poll():
        sleep(0.001)
    assert (job.step, job.share) == ("text.grid: Reading the header", pytest.approx(0.025))
    job.cancel()
    imported = finish(job)
    assert (imported.terrains, imported.failures) == ([], [])


def test_a_job_that_is_cancelled_when_all_is_prepared_adds_nothing(label: Path) -> None:
    before, job = contents(), job_of(label)
    job.run()
    job.cancel()
    assert finish(job).terrains == []
    assert contents() == before


def test_what_no_file_is_to_blame_for_is_raised_by_finish(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_arguments: object) -> None:
        raise MemoryError("too much")

    decode_everything(monkeypatch, fail)  # type: ignore[arg-type]
    job = job_of(label)
    job.start()
    with pytest.raises(MemoryError, match="too much"):
        finish(job)


SHOWING = ("begin_showing", "show_work", "end_showing")
"""Methods of operators that show long work."""


class Window:
    """What the operator needs of Blender's window manager, workspace and window."""

    def __init__(self, windows: tuple[object, ...] = ()) -> None:
        self.status: list[Any] = []
        self.timers = 0
        self.handlers: list[Any] = []
        manager = SimpleNamespace(
            event_timer_add=self._add,
            event_timer_remove=self._remove,
            modal_handler_add=self.handlers.append,
            progress_begin=lambda *_span: None,
            progress_update=lambda _share: None,
            progress_end=lambda: None,
            windows=windows,
        )
        self.context = SimpleNamespace(
            window_manager=manager,
            window=None,
            workspace=SimpleNamespace(status_text_set=self.status.append),
            collection=bpy.context.collection,
            view_layer=bpy.context.view_layer,
            selected_objects=[],
        )

    def _add(self, _seconds: float, *, window: object) -> object:
        self.timers += 1
        return object()

    def _remove(self, _timer: object) -> None:
        self.timers -= 1


def operator_for(label: Path) -> Any:
    """Stand in for an operator whose dialog was answered: the class itself cannot be made here."""
    cls = module("ui.import_operator").HAPTIC_TERRAIN_OT_import_grid
    choices = {"vertex_budget": 1000, "scale": "FIT", "exaggeration": 0.0, "region": "WHOLE"}
    operator = SimpleNamespace(
        **choices,
        fill_voids=False,
        placed=False,
        filepath=str(label),
        directory="",
        files=[],
        answered=True,
        reports=[],
        _job=None,
        _timer=None,
    )
    operator.report = lambda kind, text: operator.reports.append((kind, text))
    for name in ("invoke", "modal", "cancel", "begin", "_clear", "end", *SHOWING):
        setattr(operator, name, getattr(cls, name).__get__(operator))
    return operator


def run_until_done(operator: Any, context: Any) -> set[str]:
    """Send timer events until the operator has ended."""
    while True:
        result: set[str] = operator.modal(context, SimpleNamespace(type="TIMER", value="NOTHING"))
        if result & {"FINISHED", "CANCELLED"}:
            return result


def test_an_answered_dialog_imports_in_steps_that_leave_blender_free(
    label: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, window = Gate(), Window()
    decode_everything(monkeypatch, gate)
    operator = operator_for(label)
    assert operator.invoke(window.context, None) == {"RUNNING_MODAL"}
    assert window.handlers == [operator]
    assert gate.begun.wait(WAIT)
    assert operator.modal(window.context, SimpleNamespace(type="TIMER", value="NOTHING")) == {"PASS_THROUGH"}
    assert "Decoding" in said(window.status[-1])
    assert "Esc" in said(window.status[-1])
    moved = SimpleNamespace(type="MOUSEMOVE", value="NOTHING")
    assert operator.modal(window.context, moved) == {"PASS_THROUGH"}
    gate.open.set()
    assert run_until_done(operator, window.context) == {"FINISHED"}
    assert "Mars grid" in bpy.data.objects
    assert (window.timers, window.status[-1]) == (0, None)


def test_escape_cancels_and_leaves_nothing(label: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gate, window, before = Gate(), Window(), contents()
    decode_everything(monkeypatch, gate)
    operator = operator_for(label)
    operator.invoke(window.context, None)
    assert gate.begun.wait(WAIT)
    escape = SimpleNamespace(type="ESC", value="PRESS")
    assert operator.modal(window.context, escape) == {"RUNNING_MODAL"}
    gate.open.set()
    assert run_until_done(operator, window.context) == {"CANCELLED"}
    assert contents() == before
    assert operator.reports == [({"INFO"}, "Import cancelled: nothing was added")]
    assert (window.timers, window.status[-1]) == (0, None)


def test_an_import_that_blender_takes_away_ends(label: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gate, window, before = Gate(), Window(), contents()
    decode_everything(monkeypatch, gate)
    operator = operator_for(label)
    operator.invoke(window.context, None)
    job = operator._job
    operator.cancel(window.context)
    gate.open.set()
    assert finish(job).terrains == []
    assert (contents(), window.timers) == (before, 0)


def test_a_person_sees_errors_as_errors(tmp_path: Path) -> None:
    window = Window()
    label = MegdrPair(rough(9, 13), image={"LINES": 1}).write(tmp_path)
    operator = operator_for(label)
    operator.invoke(window.context, None)
    assert run_until_done(operator, window.context) == {"CANCELLED"}
    assert [kind for kind, _text in operator.reports] == [{"ERROR"}]


@pytest.mark.parametrize(("before", "after"), [("SOLID", "MATERIAL"), ("WIREFRAME", "WIREFRAME")])
def test_a_plain_view_shows_the_colours_of_what_was_imported(before: str, after: str) -> None:
    shading = SimpleNamespace(type=before)
    area = SimpleNamespace(
        type="VIEW_3D", spaces=SimpleNamespace(active=SimpleNamespace(shading=shading)), regions=[]
    )
    window = Window((SimpleNamespace(screen=SimpleNamespace(areas=[area])),))
    module("terrain.view").show_materials(window.context)
    assert shading.type == after
