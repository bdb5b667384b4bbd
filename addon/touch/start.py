"""Starting touch."""

from __future__ import annotations

from dataclasses import asdict

import bpy
from proxygraph import (
    STALE_AFTER,
    Grid,
    PlaybackDevice,
    ScriptedDevice,
    Session,
    SessionError,
    SimulatedDevice,
    Window,
)

from ..formats import FormatError
from ..terrain.frame import Point
from ..terrain.kept import KeptTerrain, is_terrain, recall
from ..terrain.opening import open_shown
from ..terrain.preview import preview_cells, preview_surface
from ..terrain.undone import undone_on_failure
from .cursor import make_cursor
from .error import TouchError
from .handle import Handle
from .live import Touch, live
from .model import chosen_model
from .placement import Placement
from .stop import stop_touch
from .target import above_ground, add_target, target_object, target_place
from .tick import UNUSABLE, tick
from .timer import start_timer
from .workspace import BETWEEN_WALLS, to_workspace, whole_map

Device = ScriptedDevice | SimulatedDevice | PlaybackDevice


def start_touch(
    context: bpy.types.Context,
    *,
    terrain: bpy.types.Object | None = None,
    device: Device | None = None,
    window: Window | None = None,
    modes: bool | None = None,
    on_the_clock: bool = True,
) -> Touch:
    """Put a hand on a terrain.

    Args:
        terrain: the terrain object; the chosen one where it is left out.
        device: the hand; a simulated one that follows the Empty "Touch Target" where it is left out.
        window: where the device's workspace lies; where it is left out, as the take lay that is played, or
            from the scene's settings.
        modes: whether the stylus button changes the mode, and walls keep the hand in the workspace; left out,
            for every device that a person holds: a script's hand goes where the script wants.
        on_the_clock: run at 1 kHz; otherwise ticks are done by ``session.step``, for tests and scripts.

    Raises:
        TouchError: there is nothing to touch, or touch runs already.
        FormatError: the terrain's grid file cannot be used any more.
    """
    if live.touch is not None:
        raise TouchError("Touch is already running: stop it before starting it again.")
    terrain = terrain or chosen_terrain(context)
    with undone_on_failure():
        try:
            has_modes = not isinstance(device, ScriptedDevice | PlaybackDevice) if modes is None else modes
            touch = _touch(context, terrain, device, window, has_modes=has_modes)
            if on_the_clock:
                touch.session.start()
            live.message = ""
            live.change(touch)
            if on_the_clock:
                start_timer()
            tick()
        except FormatError:
            raise
        except (ValueError, SessionError) as error:
            stop_touch()
            raise TouchError(f"Touch cannot start: {error}") from error
        except BaseException:
            # The hand must not stay on the terrain when the person is told that it is not there.
            stop_touch()
            raise
        if live.touch is None:
            raise TouchError(live.message)
    return touch


def _touch(
    context: bpy.types.Context,
    terrain: bpy.types.Object,
    device: Device | None,
    window: Window | None,
    *,
    has_modes: bool,
) -> Touch:
    """Make the session, not yet started.

    Raises:
        ValueError: naming what cannot be used.
    """
    scene = _open_scene(context)
    kept = recall(terrain)
    grid = open_shown(live.opened, kept)
    context.view_layer.update()
    placement = Placement.of(terrain, kept.frame)
    if not placement.is_usable:
        raise ValueError(UNUSABLE)
    workspace = (device or SimulatedDevice()).workspace
    if isinstance(device, PlaybackDevice):
        window = window or device.window
    window = window or _window(scene, placement, grid, kept, workspace, has_walls=has_modes)
    target = None
    if device is None:
        empty = target_object(scene) or add_target(context, placement, window)
        target = Handle.to(empty)
        place = above_ground(_place(empty, placement, grid), grid, window)
        device = SimulatedDevice(target=to_workspace(place, window, workspace[0]))
    make_cursor(scene)
    model = chosen_model(scene)
    session = Session(
        grid,
        device,
        window,
        max_force=scene.haptic_terrain.max_force,
        stale_after=stale_after(),
        walls=has_modes,
        modes=has_modes,
        **asdict(model),
    )
    session.set_twist(0.0)  # a handle has a direction from the beginning: turns are told from it
    return Touch(
        session=session,
        model=model,
        grid=grid,
        kept=kept,
        georeference=kept.grid.georeference,
        frame=kept.frame,
        surface=preview_surface(grid, preview_cells(grid.layout, kept.vertex_budget)),
        scene=Handle.to(scene),
        terrain=Handle.to(terrain),
        target=target,
        workspace=workspace,
        target_window=window,
        view_window=window,
        has_modes=has_modes,
        is_simulated=isinstance(device, SimulatedDevice),
    )


def stale_after() -> float | None:
    """Seconds without a look at the session after which the hand feels nothing.

    Where Blender draws, its timer looks, and what is felt must not go on without what is seen. In the
    background timers never fire, and a script may do what it likes between two looks.
    """
    return None if bpy.app.background else STALE_AFTER


def _open_scene(context: bpy.types.Context) -> bpy.types.Scene:
    if context.scene is None:
        raise TouchError("No scene is open.")
    return context.scene


def _place(empty: bpy.types.Object, placement: Placement, grid: Grid) -> Point:
    place = target_place(empty, placement, grid.layout)
    if place is None:
        raise ValueError(f"the location of {empty.name} is not a number; move it, or delete it.")
    return place


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
            "There is no terrain to touch: import a grid with File > Import > Elevation terrain."
        )
    if len(terrains) > 1:
        raise TouchError(f"Select the terrain to touch: there are {len(terrains)}.")
    return terrains[0]


def _window(
    scene: bpy.types.Scene,
    placement: Placement,
    grid: Grid,
    kept: KeptTerrain,
    workspace: tuple[float, float, float],
    *,
    has_walls: bool,
) -> Window:
    """Lay the workspace over the whole map, or as wide as the person wants it around the Empty."""
    east, north, whole = whole_map(grid.layout, workspace)
    if has_walls:
        whole /= BETWEEN_WALLS
    width = scene.haptic_terrain.window_width * 1000.0  # the setting has kilometres
    empty = target_object(scene)
    if width > 0.0 and empty is not None:
        east, north, _up = _place(empty, placement, grid)
    ground = grid.elevation_at(east, north)
    return Window(
        east,
        north,
        (kept.minimum + kept.maximum) / 2.0 if ground is None else ground,
        width=width or whole,
        exaggeration=placement.exaggeration,
    )
