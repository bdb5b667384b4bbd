"""The add-on's own preferences: the keys of Touch with Mouse."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from enable_addon import MODULE

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
    preferences, keys = module("ui.preferences"), module("ui.mouse_keys")
    changeable: list[str] = []

    def note(_maps: Any, _configuration: Any, keymap: Any, item: Any, _layout: Any, _level: int) -> None:
        assert item.name
        assert keymap.name == "3D View"
        changeable.append(item.properties.action)

    monkeypatch.setattr(preferences.rna_keymap_ui, "draw_kmi", note)
    layout = Layout()
    preferences.HapticTerrainPreferences.draw(SimpleNamespace(layout=layout), bpy.context)
    assert sorted(changeable) == sorted(action for action, _event, _rest in keys.DEFAULTS)
    named = {name: label for name, label, _description in keys.ACTIONS}
    assert layout.labels[1:] == [named[action] for action in changeable]
    assert layout.pointers == [("keymap", "3D View")] * len(changeable)


def test_keys_that_were_all_removed_are_told_how_to_come_back(monkeypatch: pytest.MonkeyPatch) -> None:
    preferences = module("ui.preferences")
    monkeypatch.setattr(preferences, "keymap_items", lambda _context: [])
    layout = Layout()
    preferences.HapticTerrainPreferences.draw(SimpleNamespace(layout=layout), bpy.context)
    assert "restore it" in layout.labels[-1]


def test_blender_knows_them_as_the_extensions() -> None:
    assert isinstance(
        bpy.context.preferences.addons[MODULE].preferences, module("ui.preferences").HapticTerrainPreferences
    )
