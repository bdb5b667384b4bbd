"""Making the extension known to Blender, and taking it back in reverse order."""

from __future__ import annotations

import bpy

from .formats.cache import cache
from .overlay import handlers as overlay
from .package import OwnFolder, own_folder
from .record.playing import stop_playing
from .terrain import saving
from .touch import timer
from .touch.live import live
from .ui import (
    bake_operators,
    download_operator,
    import_operator,
    keymap,
    mouse_keys,
    mouse_touch,
    overview_gizmo,
    panel,
    place_operators,
    preference_operators,
    preferences,
    presets,
    profile_operators,
    record_operators,
    settings,
    stylus_operators,
    take_operators,
    terrain_operators,
    terrain_properties,
    touch_operators,
    translations,
)
from .ui.panels import bake, colours, georeference, profile, take, terrain_data
from .ui.panels import overlay as overlay_panel

CLASSES: tuple[type, ...] = (
    settings.HapticTerrainSettings,
    terrain_properties.HapticTerrainObject,
    import_operator.HAPTIC_TERRAIN_OT_import_grid,
    import_operator.HAPTIC_TERRAIN_FH_grid,
    download_operator.HAPTIC_TERRAIN_OT_download_mola,
    touch_operators.HAPTIC_TERRAIN_OT_touch_start,
    touch_operators.HAPTIC_TERRAIN_OT_touch_update,
    touch_operators.HAPTIC_TERRAIN_OT_touch_stop,
    mouse_touch.HAPTIC_TERRAIN_OT_mouse_touch,
    mouse_keys.HAPTIC_TERRAIN_OT_mouse_key,
    stylus_operators.HAPTIC_TERRAIN_OT_press,
    stylus_operators.HAPTIC_TERRAIN_OT_release,
    stylus_operators.HAPTIC_TERRAIN_OT_twist,
    record_operators.HAPTIC_TERRAIN_OT_record_start,
    record_operators.HAPTIC_TERRAIN_OT_record_stop,
    record_operators.HAPTIC_TERRAIN_OT_record_discard,
    bake_operators.HAPTIC_TERRAIN_OT_bake,
    bake_operators.HAPTIC_TERRAIN_OT_follow_ground,
    bake_operators.HAPTIC_TERRAIN_OT_leave_ground,
    take_operators.HAPTIC_TERRAIN_OT_export_take,
    take_operators.HAPTIC_TERRAIN_OT_import_take,
    record_operators.HAPTIC_TERRAIN_OT_recover_take,
    place_operators.HAPTIC_TERRAIN_OT_go_to,
    place_operators.HAPTIC_TERRAIN_OT_show_curvature,
    place_operators.HAPTIC_TERRAIN_OT_colour_by,
    profile_operators.HAPTIC_TERRAIN_OT_mark,
    profile_operators.HAPTIC_TERRAIN_OT_add_profile,
    profile_operators.HAPTIC_TERRAIN_OT_export_profile,
    terrain_operators.HAPTIC_TERRAIN_OT_rebuild,
    terrain_operators.HAPTIC_TERRAIN_OT_relink,
    presets.HAPTIC_TERRAIN_MT_touch_presets,
    presets.HAPTIC_TERRAIN_OT_touch_preset_add,
    preference_operators.HAPTIC_TERRAIN_OT_copy_diagnostics,
    preference_operators.HAPTIC_TERRAIN_OT_clear_folder,
    preferences.HapticTerrainPreferences,
    panel.HAPTIC_TERRAIN_PT_terrain,
    georeference.HAPTIC_TERRAIN_PT_georeference,
    colours.HAPTIC_TERRAIN_PT_colours,
    profile.HAPTIC_TERRAIN_PT_profile,
    panel.HAPTIC_TERRAIN_PT_touch,
    overlay_panel.HAPTIC_TERRAIN_PT_overlay,
    panel.HAPTIC_TERRAIN_PT_safety,
    panel.HAPTIC_TERRAIN_PT_record,
    bake.HAPTIC_TERRAIN_PT_bake,
    bake.HAPTIC_TERRAIN_PT_follow_ground,
    take.HAPTIC_TERRAIN_PT_take,
    overview_gizmo.HAPTIC_TERRAIN_OT_overview_go,
    overview_gizmo.HAPTIC_TERRAIN_GT_overview,
    overview_gizmo.HAPTIC_TERRAIN_GGT_overview,
    terrain_data.HAPTIC_TERRAIN_PT_data,
)


def register() -> None:
    """Add classes, the settings of scenes and objects, the menu entry, the handlers, the key and words."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.haptic_terrain = bpy.props.PointerProperty(type=settings.HapticTerrainSettings)
    bpy.types.Object.haptic_terrain = bpy.props.PointerProperty(type=terrain_properties.HapticTerrainObject)
    bpy.types.TOPBAR_MT_file_import.append(import_operator.draw_menu)  # type: ignore[arg-type]
    bpy.types.TOPBAR_MT_file_import.append(take_operators.draw_import)  # type: ignore[arg-type]
    bpy.types.TOPBAR_MT_file_export.append(take_operators.draw_export)  # type: ignore[arg-type]
    # Extensions write nowhere else.
    cache.folder = own_folder(OwnFolder.CACHE)
    live.spool_folder = own_folder(OwnFolder.TAKES)
    saving.register()
    timer.register()
    overlay.register()
    keymap.register()
    mouse_keys.register()
    presets.register()
    translations.register()
    preferences.apply(bpy.context)


def unregister() -> None:
    """Remove what ``register`` added."""
    translations.unregister()
    presets.unregister()
    mouse_touch.unregister()
    mouse_keys.unregister()
    keymap.unregister()
    overlay.unregister()
    if live.recording is not None:
        stop_playing(bpy.context, live.recording)
    timer.unregister()
    live.spool_folder = None
    saving.unregister()
    bpy.types.TOPBAR_MT_file_export.remove(take_operators.draw_export)  # type: ignore[arg-type]
    bpy.types.TOPBAR_MT_file_import.remove(take_operators.draw_import)  # type: ignore[arg-type]
    bpy.types.TOPBAR_MT_file_import.remove(import_operator.draw_menu)  # type: ignore[arg-type]
    del bpy.types.Object.haptic_terrain
    del bpy.types.Scene.haptic_terrain
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
