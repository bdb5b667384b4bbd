"""The keys of the stylus button, as a person has set them."""

from __future__ import annotations

import bpy

PRESS = "haptic_terrain.press"
"""The operator that grabs."""

KEYMAP = "Object Mode"
"""Where its key is."""

NO_KEY = "stylus"
"""Where no key is set, a device's own button grabs."""


def grab_key(context: bpy.types.Context) -> str:
    """The key that grabs, in words."""
    configuration = context.window_manager.keyconfigs.user
    keymap = configuration.keymaps.get(KEYMAP) if configuration is not None else None
    found = keymap.keymap_items.find_from_operator(PRESS) if keymap is not None else None
    return str(found.to_string()) if found is not None and found.active and found.type != "NONE" else NO_KEY
