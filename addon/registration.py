"""Making the extension known to Blender, and taking it back in reverse order."""

from __future__ import annotations

from pathlib import Path

import bpy

from .formats.cache import cache
from .overlay import handlers as overlay
from .record.playing import stop_playing
from .terrain import saving
from .touch import timer
from .touch.live import live
from .ui import (
    bake_operators,
    import_operator,
    keymap,
    mouse_keys,
    mouse_touch,
    overview_gizmo,
    panel,
    place_operators,
    preferences,
    profile_operators,
    record_operators,
    settings,
    stylus_operators,
    take_operators,
    touch_operators,
)
from .ui.panels import bake, colours, georeference, profile, take
from .ui.panels import overlay as overlay_panel

CLASSES: tuple[type, ...] = (
    settings.HapticTerrainSettings,
    preferences.HapticTerrainPreferences,
    import_operator.HAPTIC_TERRAIN_OT_import_grid,
    import_operator.HAPTIC_TERRAIN_FH_grid,
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
)


def register() -> None:
    """Add classes, the scene's settings, the menu entry, the handlers and the key."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.haptic_terrain = bpy.props.PointerProperty(type=settings.HapticTerrainSettings)
    bpy.types.TOPBAR_MT_file_import.append(import_operator.draw_menu)  # type: ignore[arg-type]
    bpy.types.TOPBAR_MT_file_import.append(take_operators.draw_import)  # type: ignore[arg-type]
    bpy.types.TOPBAR_MT_file_export.append(take_operators.draw_export)  # type: ignore[arg-type]
    # Extensions write nowhere else.
    cache.folder = Path(bpy.utils.extension_path_user(__package__, path="cache"))
    live.spool_folder = Path(bpy.utils.extension_path_user(__package__, path="takes"))
    saving.register()
    timer.register()
    overlay.register()
    keymap.register()
    mouse_keys.register()


def unregister() -> None:
    """Remove what ``register`` added."""
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
    del bpy.types.Scene.haptic_terrain
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
