"""Grids that are opened again after their import: what lasts is shown."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Event
from typing import Any

import bpy
import pytest
from proxygraph import CancelledError, Grid

from tests.addon.decoded import copying, decode_everything
from tests.addon.scene import import_grid, module
from tests.formats.megdr_pair import MegdrPair, rough

WAIT = 10.0
"""Seconds after which a thread of a test has failed."""


class Display:
    """In place of the pointer: remembers what it was told, and lets the decoder go on once it shows."""

    def __init__(self) -> None:
        self.shares: list[float] = []
        self.shown = Event()
        self.displays = 0

    @contextmanager
    def __call__(self, _context: bpy.types.Context) -> Iterator[Callable[[float], None]]:
        self.displays += 1
        try:
            yield self.tell
        finally:
            self.displays -= 1

    def tell(self, share: float) -> None:
        self.shares.append(share)
        if share >= 0.25:
            self.shown.set()

    def decode(self, path: Path, layout: Any, decoding: Any, progress: Any) -> Grid:
        progress.step(1, 4)
        assert self.shown.wait(WAIT), "nobody showed how far it is"
        return copying(path, layout, decoding, progress)


@pytest.fixture
def terrain(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> bpy.types.Object:
    decode_everything(monkeypatch)
    return import_grid(MegdrPair(rough(9, 13)).write(tmp_path))


@pytest.fixture
def display(terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch) -> Display:
    """After a .blend was loaded: the terrain is there, no grid is open."""
    made = Display()
    module("touch.live").live.opened.clear()
    monkeypatch.setitem(module("formats.decoders").DECODERS, "test", made.decode)
    monkeypatch.setattr(module("terrain.opening"), "progress", made)
    return made


def mark_both() -> set[str]:
    """The second mark measures the ground between them."""
    bpy.ops.haptic_terrain.mark(which="A")
    marked: set[str] = bpy.ops.haptic_terrain.mark(which="B")
    return marked


@pytest.mark.parametrize(
    "use",
    [
        lambda: bpy.ops.haptic_terrain.touch_start(),
        lambda: bpy.ops.haptic_terrain.go_to(longitude=25.0, latitude=5.0),
        lambda: bpy.ops.haptic_terrain.show_curvature(curved=True),
        mark_both,
    ],
)
def test_what_decodes_a_grid_again_shows_how_far_it_is(
    terrain: bpy.types.Object, display: Display, use: Callable[[], set[str]]
) -> None:
    assert use() == {"FINISHED"}
    assert 0.25 in display.shares
    assert display.displays == 0


def test_a_grid_that_is_open_shows_nothing(terrain: bpy.types.Object, display: Display) -> None:
    keeping, opening = module("terrain.kept"), module("terrain.opening")
    opened, kept = module("touch.live").live.opened, keeping.recall(terrain)
    grid = opening.open_shown(opened, kept)
    display.shares.clear()
    assert opening.open_shown(opened, kept) is grid
    assert display.shares == []


def test_an_interrupt_ends_the_thread(
    terrain: bpy.types.Object, display: Display, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended = Event()

    def decode(path: Path, layout: Any, decoding: Any, progress: Any) -> Grid:
        try:
            while not ended.wait(0.001):
                progress.step(1, 4)
        except CancelledError:
            ended.set()
            raise
        raise AssertionError

    def interrupt(_share: float) -> None:
        raise KeyboardInterrupt

    monkeypatch.setitem(module("formats.decoders").DECODERS, "test", decode)
    monkeypatch.setattr(display, "tell", interrupt)
    with pytest.raises(KeyboardInterrupt):
        module("terrain.opening").open_shown(
            module("touch.live").live.opened, module("terrain.kept").recall(terrain)
        )
    assert ended.is_set()
    assert display.displays == 0
