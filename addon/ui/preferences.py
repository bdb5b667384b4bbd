"""The extension in Blender's preferences: defaults, keys, folders, and a bug report's facts."""

from __future__ import annotations

import bpy
import rna_keymap_ui

from ..formats.cache import MOST_ON_DISK, cache
from ..package import PACKAGE, OwnFolder, own_folder
from ..terrain.byte_size import in_bytes
from ..terrain.megdr import ADDRESS
from ..terrain.preview import VERTEX_BUDGET
from . import keymap, mouse_keys
from .preference_operators import (
    HAPTIC_TERRAIN_OT_clear_folder,
    HAPTIC_TERRAIN_OT_copy_diagnostics,
    folder_size,
)

GIGABYTE = 1 << 30

FOLDERS = ((OwnFolder.CACHE, "Decoded grids"), (OwnFolder.MOLA, "Downloaded grids"))


def _limit_cache(preferences: HapticTerrainPreferences, _context: bpy.types.Context) -> None:
    """Let the next decoding keep to the new limit."""
    cache.most_on_disk = preferences.cache_gigabytes * GIGABYTE


class HapticTerrainPreferences(bpy.types.AddonPreferences):
    """Of the person, whatever file is open."""

    bl_idname = PACKAGE

    vertex_budget: bpy.props.IntProperty(
        name="Vertices",
        description="How many samples an import shows at the most, unless it says otherwise",
        default=VERTEX_BUDGET,
        min=4,
        soft_min=1_000,
        soft_max=10_000_000,
    )
    mola_address: bpy.props.StringProperty(
        name="MOLA Address",
        description="The folder on the web that Download Mars (MOLA) offers: a mirror may be nearer",
        default=ADDRESS,
    )
    cache_gigabytes: bpy.props.IntProperty(
        name="Decoded Grids, GB",
        description="How much of the disk decoded grids may take; those unused for longest go first",
        default=MOST_ON_DISK // GIGABYTE,
        min=1,
        max=10_000,
        update=_limit_cache,
    )

    def draw(self, context: bpy.types.Context) -> None:
        """Everything on one page."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("vertex_budget", "mola_address", "cache_gigabytes"):
            layout.prop(self, name)
        for folder, title in FOLDERS:
            row = layout.row()
            row.label(text=f"{title}: {in_bytes(folder_size(own_folder(folder)))}")
            row.operator(HAPTIC_TERRAIN_OT_clear_folder.bl_idname, text="Clear", icon="TRASH").folder = folder
        _draw_keys(layout, context)
        mouse_keys.draw_keys(layout, context)
        layout.operator(HAPTIC_TERRAIN_OT_copy_diagnostics.bl_idname, icon="COPYDOWN")


def preferences(context: bpy.types.Context) -> HapticTerrainPreferences | None:
    """The person's preferences; ``None`` while the extension is not enabled as one, as in a script."""
    addon = context.preferences.addons.get(PACKAGE)
    return None if addon is None else addon.preferences


def apply(context: bpy.types.Context) -> None:
    """Let what was chosen in an earlier run hold in this one."""
    chosen = preferences(context)
    if chosen is not None:
        _limit_cache(chosen, context)


def _draw_keys(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The person's own version of each key, to be changed in place."""
    configuration = context.window_manager.keyconfigs.user
    if configuration is None:
        return
    column = layout.column()
    column.label(text="Keys")
    for keys, item in keymap.of_person(configuration):
        column.context_pointer_set("keymap", keys)
        rna_keymap_ui.draw_kmi([], configuration, keys, item, column, 0)
