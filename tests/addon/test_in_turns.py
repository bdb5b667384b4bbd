"""Long work in turns, as a window has it: a timer, keys, and a person who may change their mind."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import bpy
import pytest

from tests.addon.scene import module


class Manager:
    """Stands in for Blender's window manager."""

    def __init__(self) -> None:
        self.timers, self.shares, self.is_shown, self.handlers = 0, list[float](), False, list[Any]()

    def event_timer_add(self, _seconds: float, window: object) -> object:
        self.timers += 1
        return object()

    def event_timer_remove(self, _timer: object) -> None:
        self.timers -= 1

    def progress_begin(self, _low: float, _high: float) -> None:
        self.is_shown = True

    def progress_update(self, share: float) -> None:
        self.shares.append(share)

    def progress_end(self) -> None:
        self.is_shown = False

    def modal_handler_add(self, operator: Any) -> None:
        self.handlers.append(operator)


@pytest.fixture
def context() -> Any:
    texts: list[str | None] = []
    workspace = SimpleNamespace(status_text_set=texts.append, texts=texts)
    return SimpleNamespace(window=object(), window_manager=Manager(), workspace=workspace)


@pytest.fixture(autouse=True)
def windowed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the operator think that there is a window."""
    in_turns = module("ui.in_turns")
    monkeypatch.setattr(in_turns, "bpy", SimpleNamespace(app=SimpleNamespace(background=False), ops=bpy.ops))
    monkeypatch.setattr(in_turns, "TURN_SECONDS", 0.0)


def operator(steps: int = 3, fails_at: int | None = None) -> Any:
    """An operator whose work has some steps."""

    class Counting(module("ui.in_turns").InTurns):  # type: ignore[misc]
        bl_idname, bl_label = "haptic_terrain.counting", "Counting"

        def __init__(self) -> None:
            self.answered, self.reports, self.is_closed, self.written = True, list[Any](), False, list[Any]()

        def report(self, kind: set[str], text: str) -> None:
            self.reports.append((kind, text))

        def work(self, _context: Any) -> Any:
            return self._steps()

        def write(self, result: Any, _tell: Any) -> None:
            self.written.append(result)

        def _steps(self) -> Any:
            try:
                for step in range(steps):
                    if step == fails_at:
                        raise ValueError("the third stone is missing")
                    yield (step + 1) / steps
            finally:
                self.is_closed = True
            return "all of it"

    return Counting()


def event(kind: str) -> Any:
    return SimpleNamespace(type=kind, value="PRESS")


def is_tidy(context: Any) -> bool:
    manager = context.window_manager
    return manager.timers == 0 and not manager.is_shown and context.workspace.texts[-1] is None


def test_work_is_done_in_turns_and_written_at_the_end(context: Any) -> None:
    counting = operator()
    assert counting.invoke(context, event("NONE")) == {"RUNNING_MODAL"}
    statuses = [counting.modal(context, event("TIMER")) for _turn in range(4)]
    assert statuses == [{"RUNNING_MODAL"}] * 3 + [{"FINISHED"}]
    assert counting.written == ["all of it"]
    assert context.window_manager.shares[:3] == pytest.approx([1 / 3, 2 / 3, 1.0])
    assert is_tidy(context)


def test_escape_ends_it_and_nothing_is_written(context: Any) -> None:
    counting = operator()
    counting.invoke(context, event("NONE"))
    counting.modal(context, event("TIMER"))
    assert counting.modal(context, event("MOUSEMOVE")) == {"RUNNING_MODAL"}
    assert counting.modal(context, event("ESC")) == {"CANCELLED"}
    assert (counting.is_closed, counting.written) == (True, [])
    assert counting.reports == [({"INFO"}, "Counting cancelled: nothing was added")]
    assert is_tidy(context)


def test_what_a_person_can_mend_is_told(context: Any) -> None:
    counting = operator(fails_at=2)
    counting.invoke(context, event("NONE"))
    statuses = [counting.modal(context, event("TIMER")) for _turn in range(3)]
    assert statuses[-1] == {"CANCELLED"}
    assert counting.reports == [({"ERROR"}, "the third stone is missing")]
    assert is_tidy(context)


def test_nothing_is_done_while_a_picture_is_rendered(context: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module("touch.live").live, "rendering", True)
    counting = operator()
    counting.invoke(context, event("NONE"))
    for _turn in range(5):
        assert counting.modal(context, event("TIMER")) == {"RUNNING_MODAL"}
    assert context.window_manager.shares == []
    counting.cancel(context)
    assert is_tidy(context)


def test_a_person_is_asked_first(context: Any) -> None:
    asked: list[Any] = []
    context.window_manager.invoke_props_dialog = asked.append
    counting = operator()
    counting.answered = False
    assert counting.invoke(context, event("NONE")) == {"RUNNING_MODAL"}
    assert asked == [counting]
    assert context.window_manager.timers == 0
