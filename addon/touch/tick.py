"""What happens between two drawings of the screen: the scene follows the hand.

The timer calls this; so do scripts and tests, for in the background Blender's timers never fire.
"""

from __future__ import annotations

import math
from contextlib import suppress

import bpy
from mathutils import Vector
from proxygraph import SessionError, State

from ..terrain.frame import is_on_map, place_in_grid
from ..terrain.kept import KeptError, recall_frame
from .control import keep_control
from .cursor import SIZE, find_cursor, shape_of, show_cursor
from .follow import carry_target, follow_target, lay_window
from .follow_view import follow_view
from .live import Readout, Touch, live
from .model import keep_model
from .mouse import keep_mouse
from .placement import Placement
from .pre_roll import keep_pre_roll
from .refresh import refresh
from .shortcomings import shortcomings
from .show_detail import show_detail
from .shown import Shown, force_in_scene, to_hand
from .stop import note_model, stop_touch
from .windows import stretched

UNUSABLE = "the terrain's location, rotation or scale cannot be used; give it a scale that is not 0."


def tick() -> None:
    """Bring everything up to date with the newest state of the servo."""
    touch = live.touch
    if touch is None:
        return
    note_model(touch)
    fault = touch.session.fault
    if fault is not None:
        stop_touch(f"Touch stopped: {fault}")
        return
    terrain, scene = touch.terrain.find(), touch.scene.find()
    if terrain is None or scene is None:
        stop_touch("Touch stopped: the terrain is gone from the scene.")
        return
    cursor = find_cursor(scene)
    if cursor is None:
        stop_touch("Touch stopped: its cursor was deleted, or its start was undone.")
        return
    with suppress(KeptError):  # what was changed by hand is told when touch starts again
        touch.frame = recall_frame(terrain)
    placement = Placement.of(terrain, touch.frame)
    if not placement.is_usable:
        stop_touch(f"Touch stopped: {UNUSABLE}")
        return
    # The setting calls this at once; undo changes settings without telling them.
    keep_model(touch, scene)
    keep_control(touch, scene)
    keep_pre_roll(touch, scene)
    # As many commands may wait as the servo takes at a time: the next tick tells it the same, or better.
    state = touch.session.state()
    with suppress(SessionError):
        if state.mode == "normal":  # what is held in pan and zoom must not be torn away
            carry_target(touch, placement)
            _keep_exaggeration(touch, placement)
        keep_mouse(touch, state)
        follow_target(touch, placement)
    touch.shortcomings = shortcomings(terrain, scene, placement)
    touch.readout = _readout(touch, state)
    if not live.rendering:
        follow_view(touch, scene, placement)
        show_detail(touch, scene, terrain, placement, state)
        _show(touch, cursor, placement, state)
        refresh(touch, scene)


def lifted(up: float, preview: float | None) -> float:
    """Lift a height onto the preview where the preview lies above the real surface."""
    return up if preview is None else max(up, preview)


def _keep_exaggeration(touch: Touch, placement: Placement) -> None:
    """Let the hand feel heights as they are seen, also after a person stretched the terrain."""
    window = touch.session.window
    if not math.isclose(window.exaggeration, placement.exaggeration, rel_tol=1e-4):
        lay_window(touch, stretched(window, placement.exaggeration))


def _show(touch: Touch, cursor: bpy.types.Object, placement: Placement, state: State) -> None:
    """Move the cursor to the proxy."""
    east, north, up = state.proxy
    shown = touch.detail.surface if touch.detail is not None else None
    height = (shown or touch.surface).height_at(touch.frame.on_map(east), north)
    place: Vector = placement.to_scene(east, north, lifted(up, height))
    size = SIZE * placement.longest_side(touch.grid.layout) * touch.view_scale
    turn = placement.upright(east, north)
    shape = shape_of(state.mode, in_contact=state.in_contact)
    show_cursor(cursor, place, turn, size, shape)
    touch.shown = Shown(
        place=place,
        turn=turn,
        size=size,
        shape=shape,
        hand=to_hand(placement, state),
        force=force_in_scene(placement, state, touch.workspace[0]),
        units_per_metre=placement.units_per_metre,
    )


def _readout(touch: Touch, state: State) -> Readout:
    east, north, _up = state.proxy
    statistics = touch.session.statistics()
    column, row = place_in_grid(touch.grid.layout, east, north)
    coordinates = touch.georeference.longitude_latitude(column, row)
    return Readout(
        mode=state.mode,
        window=state.window,
        in_contact=state.in_contact,
        proxy=state.proxy,
        coordinates=coordinates,
        own=(touch.georeference.x(column), touch.georeference.y(row)),
        on_map=is_on_map(touch.grid.layout, east, north),
        elevation=touch.grid.elevation_at(east, north),
        force=math.hypot(*state.force),
        ticks=statistics.ticks,
        missed_ticks=statistics.missed_ticks,
        active_ticks=statistics.active_ticks,
        load=statistics.mean_load,
        worst_load=statistics.load(0.999),
        late_us=statistics.late_us(0.99),
        priority=touch.session.priority,
        held=state.held,
        warnings=tuple(touch.session.warnings()),
    )
