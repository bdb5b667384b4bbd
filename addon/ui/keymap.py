"""The key that is the stylus button: E in the 3D view, in Object Mode, where Blender has none.

A tap grabs and the next one lets go. It is not held, for while the Touch Target is dragged Blender keeps all
keys to itself. The space bar, the paper's choice, goes on playing the animation. Without touch the key is not
taken. It can be changed in *Preferences > Keymap*.
"""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from .stylus_operators import HAPTIC_TERRAIN_OT_press, HAPTIC_TERRAIN_OT_release

_items: list[tuple[bpy.types.KeyMap, bpy.types.KeyMapItem]] = []


def register() -> None:
    """Add the key; there is no keymap where Blender has no windows at all."""
    configuration = bpy.context.window_manager.keyconfigs.addon
    if configuration is None:
        return
    keymap = configuration.keymaps.new(name="Object Mode", space_type="EMPTY")
    # Both wait for the same tap: each polls false where the other one is meant, and Blender goes on to it.
    _items.extend(
        (keymap, keymap.keymap_items.new(operator.bl_idname, "E", "PRESS", repeat=False))
        for operator in (HAPTIC_TERRAIN_OT_press, HAPTIC_TERRAIN_OT_release)
    )


def of_person(
    configuration: bpy.types.KeyConfig,
) -> Iterator[tuple[bpy.types.KeyMap, bpy.types.KeyMapItem]]:
    """The same keys as the person has them, who may have changed them."""
    own = {item.idname for _keymap, item in _items}
    for name in dict.fromkeys(keymap.name for keymap, _item in _items):
        keymap = configuration.keymaps.get(name)
        if keymap is not None:
            yield from ((keymap, item) for item in keymap.keymap_items if item.idname in own)


def unregister() -> None:
    """Take the key back."""
    for keymap, item in reversed(_items):
        keymap.keymap_items.remove(item)
    _items.clear()
