"""The keys of the stylus button, as a person has set them.

They are read when they are first drawn: before Blender has handled an event, the person's keymaps may hold
what is not there any more.
"""

from __future__ import annotations

import bpy

PRESS = ("Object Mode", "haptic_terrain.press")
"""Keymap and operator of the key that grabs."""

MOUSE_KEY = ("3D View", "haptic_terrain.mouse_key")
"""Those of the mouse's keys, of which one is the button."""

BUTTON = "BUTTON"

NO_KEY = "stylus"
"""Where no key is set, a device's own button grabs."""


def grab_key(context: bpy.types.Context) -> str:
    """The key that grabs, in words."""
    keymap = _keymap(context, PRESS[0])
    found = keymap.keymap_items.find_from_operator(PRESS[1]) if keymap is not None else None
    return NO_KEY if found is None else _words(found)


def mouse_grab_key(context: bpy.types.Context) -> str:
    """The key that grabs while the mouse is the hand, in words."""
    keymap = _keymap(context, MOUSE_KEY[0])
    for item in keymap.keymap_items if keymap is not None else ():
        if item.idname == MOUSE_KEY[1] and item.properties.action == BUTTON:
            return _words(item)
    return NO_KEY


def _keymap(context: bpy.types.Context, name: str) -> bpy.types.KeyMap | None:
    configuration = context.window_manager.keyconfigs.user
    return configuration.keymaps.get(name) if configuration is not None else None


def _words(item: bpy.types.KeyMapItem) -> str:
    return str(item.to_string()) if item.active and item.type != "NONE" else NO_KEY
