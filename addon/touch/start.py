"""Starting touch."""

from __future__ import annotations

import bpy
from proxygraph import Grid, GridLayout, ScriptedDevice, Session, SessionError, SimulatedDevice, Window

from ..terrain.frame import map_centre, map_size, nearest_on_map
from ..terrain.kept import KeptTerrain, is_terrain, recall
from ..terrain.preview import preview_cells, preview_surface
from .handle import Handle
from .live import Touch, live
from .placement import Placement
from .target import above_ground, add_target, target_object, to_workspace
from .tick import tick
from .timer import start_timer

Device = ScriptedDevice | SimulatedDevice


class TouchError(RuntimeError):
    """Touch cannot start; the text says what to do."""


def start_touch(
    context: bpy.types.Context,
    *,
    terrain: bpy.types.Object | None = None,
    device: Device | None = None,
    window: Window | None = None,
    on_the_clock: bool = True,
) -> Touch:
    """Put a hand on a terrain.

    Args:
        terrain: the terrain object; the chosen one where it is left out.
        device: the hand; a simulated one that follows the Empty "Touch Target" where it is left out.
        window: where the device's workspace lies; from the scene's settings where it is left out.
        on_the_clock: run at 1 kHz; otherwise ticks are done by ``session.step``, for tests and scripts.

    Raises:
        TouchError: there is nothing to touch, or touch runs already.
        FormatError: the terrain's grid file cannot be used any more.
    """
    if live.touch is not None:
        raise TouchError("Touch is already running: stop it before starting it again.")
    terrain = terrain or chosen_terrain(context)
    kept = recall(terrain)
    grid = kept.grid.open()
    context.view_layer.update()
    placement = Placement.of(terrain, kept.frame)
    workspace = (device or SimulatedDevice()).workspace
    window = window or _window(context, placement, grid, kept, workspace)
    target = None
    if device is None:
        empty = target_object(context) or add_target(context, placement, window)
        target = Handle.to(empty)
        place = nearest_on_map(grid.layout, placement.to_terrain(empty.matrix_world.translation))
        place = above_ground(place, grid, window)
        device = SimulatedDevice(target=to_workspace(place, window, workspace[0]))
    touch = Touch(
        session=_session(grid, device, window),
        grid=grid,
        georeference=kept.grid.georeference,
        frame=kept.frame,
        surface=preview_surface(grid, preview_cells(grid.layout, kept.vertex_budget)),
        terrain=Handle.to(terrain),
        target=target,
        workspace_width=workspace[0],
    )
    if on_the_clock:
        try:
            touch.session.start()
        except SessionError as error:
            raise TouchError(f"Touch cannot start: {error}") from error
        start_timer()
    live.touch = touch
    live.message = ""
    tick()
    return touch


def _session(grid: Grid, device: Device, window: Window) -> Session:
    try:
        return Session(grid, device, window)
    except (ValueError, SessionError) as error:
        raise TouchError(f"Touch cannot start: {error}") from error


def chosen_terrain(context: bpy.types.Context) -> bpy.types.Object:
    """Find the terrain that is meant: the active one, else the only one.

    Raises:
        TouchError: there is none, or there are several.
    """
    active = context.view_layer.objects.active
    if active is not None and is_terrain(active):
        return active
    terrains = [thing for thing in context.scene.objects if is_terrain(thing)]
    if not terrains:
        raise TouchError(
            "There is no terrain to touch: import a grid with File > Import > Planetary Terrain."
        )
    if len(terrains) > 1:
        raise TouchError(f"Select the terrain to touch: there are {len(terrains)}.")
    return terrains[0]


def _window(
    context: bpy.types.Context,
    placement: Placement,
    grid: Grid,
    kept: KeptTerrain,
    workspace: tuple[float, float, float],
) -> Window:
    """Lay the workspace over the whole map, or as wide as the person wants it around the Empty."""
    width = context.scene.haptic_terrain.window_width * 1000.0  # the setting has kilometres
    east, north = map_centre(grid.layout)
    empty = target_object(context)
    if width > 0.0 and empty is not None:
        context.view_layer.update()
        east, north, _up = placement.to_terrain(empty.matrix_world.translation)
    ground = grid.elevation_at(east, north)
    return Window(
        east,
        north,
        (kept.minimum + kept.maximum) / 2.0 if ground is None else ground,
        width=width or _whole_map(grid.layout, workspace),
        exaggeration=placement.exaggeration,
    )


def _whole_map(layout: GridLayout, workspace: tuple[float, float, float]) -> float:
    """Find the width, in metres, with which the workspace holds the map in both directions."""
    across, down = map_size(layout)
    return max(across, down * workspace[0] / workspace[1])
