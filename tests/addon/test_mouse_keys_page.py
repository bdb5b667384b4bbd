"""The keys of Touch with Mouse on the preferences' page."""

from __future__ import annotations

from typing import Any

import bpy
import pytest

from tests.addon.scene import module


class Layout:
    """Takes notes."""

    def __init__(self) -> None:
        self.labels: list[str] = []
        self.pointers: list[Any] = []

    def box(self) -> Layout:
        return self

    def column(self) -> Layout:
        return self

    def label(self, *, text: str, icon: str = "NONE") -> None:
        self.labels.append(text)

    def context_pointer_set(self, name: str, value: Any) -> None:
        self.pointers.append((name, value.name))


def test_every_key_is_shown_by_what_it_does_and_can_be_changed(monkeypatch: pytest.MonkeyPatch) -> None:
    bpy.context.window_manager.keyconfigs.update()
    keys = module("ui.mouse_keys")
    changeable: list[str] = []

    def note(_maps: Any, _configuration: Any, keymap: Any, item: Any, _layout: Any, _level: int) -> None:
        assert item.name
        assert keymap.name == "3D View"
        changeable.append(item.properties.action)

    monkeypatch.setattr(keys.rna_keymap_ui, "draw_kmi", note)
    layout = Layout()
    keys.draw_keys(layout, bpy.context)
    assert sorted(changeable) == sorted(action for action, _event, _rest in keys.DEFAULTS)
    named = {name: label for name, label, _description in keys.ACTIONS}
    assert layout.labels[1:] == [named[action] for action in changeable]
    assert layout.pointers == [("keymap", "3D View")] * len(changeable)


def test_keys_that_were_all_removed_are_told_how_to_come_back(monkeypatch: pytest.MonkeyPatch) -> None:
    keys = module("ui.mouse_keys")
    monkeypatch.setattr(keys, "keymap_items", lambda _context: [])
    layout = Layout()
    keys.draw_keys(layout, bpy.context)
    assert "restore it" in layout.labels[-1]
