"""The keys of Touch with Mouse, in *Preferences > Keymap > 3D View* and in the add-on's own preferences.

Blender lets no add-on have a modal keymap. So each key is an item of the 3D view's keymap that does nothing
by itself, for its operator never runs; *Touch with Mouse*, which hears of every event first while it runs,
reads from the items what each key means.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import bpy
import rna_keymap_ui

from .operator_status import OperatorStatus

KEYMAP = "3D View"

ACTIONS = (
    ("BUTTON", "Stylus Button", "Held down on the ground it pans, in the air it zooms"),
    ("HEIGHT", "Height", "The pointer's way up or down moves the hand up or down, not along the ground"),
    ("RAISE", "Raise", "Move the hand up; away, where the view looks along the ground"),
    ("LOWER", "Lower", "Move the hand down, to press; nearer, where the view looks along the ground"),
    ("TWIST_LEFT", "Twist Left", "Turn the handle counter-clockwise, seen from above"),
    ("TWIST_RIGHT", "Twist Right", "Turn the handle clockwise, seen from above"),
    ("END", "End", "Take the mouse off the terrain"),
)
"""What a key can do: name, label, description."""

DEFAULTS: tuple[tuple[str, Any, dict[str, Any]], ...] = (
    ("BUTTON", "SPACE", {}),
    ("RAISE", "WHEELUPMOUSE", {}),
    ("LOWER", "WHEELDOWNMOUSE", {}),
    ("HEIGHT", "MOUSEMOVE", {"value": "ANY", "alt": True}),
    ("HEIGHT", "TRACKPADPAN", {"value": "ANY", "alt": True}),
    ("TWIST_LEFT", "PAGE_UP", {"repeat": True}),
    ("TWIST_RIGHT", "PAGE_DOWN", {"repeat": True}),
    ("END", "ESC", {}),
)
"""Action, event and the rest. Of these Blender's 3D view has only space bar and wheel, which it gets back
when the mouse no longer touches; meanwhile Ctrl and the middle button zoom the view, or the keypad."""

MODIFIERS = ("shift", "ctrl", "alt", "oskey")

_items: list[tuple[bpy.types.KeyMap, bpy.types.KeyMapItem]] = []


class HAPTIC_TERRAIN_OT_mouse_key(bpy.types.Operator):
    """A key of Touch with Mouse"""

    bl_idname = "haptic_terrain.mouse_key"
    bl_label = "Touch with Mouse: Key"
    bl_options = {"INTERNAL"}  # noqa: RUF012

    action: bpy.props.EnumProperty(name="Action", items=ACTIONS)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Never on its own: the key goes on to whatever else it means."""
        cls.poll_message_set("Touch with Mouse reads this key while it runs")
        return False

    def execute(self, context: bpy.types.Context) -> OperatorStatus:
        """Nothing: see the module."""
        return {"PASS_THROUGH"}


@dataclass(frozen=True)
class Key:
    """What a keymap's item says, for it may be gone while the operator runs."""

    action: str
    type: str
    value: str
    modifiers: tuple[int, ...] | None
    """Of ``MODIFIERS``: 1 down, 0 up, -1 either; ``None`` where none matters."""
    label: str
    """In words."""

    def is_meant(self, event: Any) -> bool:
        """Whether an event is this key."""
        if event.type != self.type or self.value not in ("ANY", event.value):
            return False
        downs = (int(getattr(event, name)) for name in MODIFIERS)
        return self.modifiers is None or all(
            wanted in (-1, down) for wanted, down in zip(self.modifiers, downs, strict=True)
        )


def keys(context: bpy.types.Context) -> list[Key]:
    """Read what the keys are now, as a person may have changed them."""
    return [
        Key(
            action=item.properties.action,
            type=item.type,
            value=item.value,
            modifiers=None if item.any else tuple(int(getattr(item, name)) for name in MODIFIERS),
            label=item.to_string(),
        )
        for item in keymap_items(context)
        if item.active
    ]


def keymap_items(context: bpy.types.Context) -> list[bpy.types.KeyMapItem]:
    """The items of a person's own keymap."""
    configuration = context.window_manager.keyconfigs.user
    keymap = configuration.keymaps.get(KEYMAP) if configuration is not None else None
    items = keymap.keymap_items if keymap is not None else ()
    return [item for item in items if item.idname == HAPTIC_TERRAIN_OT_mouse_key.bl_idname]


def labels(known: Sequence[Key], *actions: str) -> str:
    """The keys of some actions in words."""
    return ", ".join(key.label for action in actions for key in known if key.action == action)


def draw_keys(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """Let a person change the keys, each under what it does."""
    box = layout.box()
    box.label(text="Keys of Touch with Mouse", icon="MOUSE_MOVE")
    configuration = context.window_manager.keyconfigs.user
    items = keymap_items(context)
    if configuration is None or not items:
        box.label(text="The keymap has none: restore it in Preferences > Keymap > 3D View.")
        return
    named = {name: label for name, label, _description in ACTIONS}
    keymap = configuration.keymaps[KEYMAP]
    for item in items:
        column = box.column()
        column.label(text=named[item.properties.action])
        column.context_pointer_set("keymap", keymap)  # what the buttons of an item work on
        rna_keymap_ui.draw_kmi([], configuration, keymap, item, column, 0)


def register() -> None:
    """Add the keys; there is no keymap where Blender has no windows at all."""
    configuration = bpy.context.window_manager.keyconfigs.addon
    if configuration is None:
        return
    keymap = configuration.keymaps.new(name=KEYMAP, space_type="VIEW_3D", region_type="WINDOW")
    for action, event, rest in DEFAULTS:
        options = {"value": "PRESS", **rest}
        item = keymap.keymap_items.new(HAPTIC_TERRAIN_OT_mouse_key.bl_idname, event, **options)
        item.properties.action = action
        _items.append((keymap, item))


def unregister() -> None:
    """Take the keys back."""
    for keymap, item in reversed(_items):
        keymap.keymap_items.remove(item)
    _items.clear()
