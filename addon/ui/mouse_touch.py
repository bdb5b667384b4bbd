"""Touch with Mouse: mouse and keyboard as a haptic device, as long as it runs.

The pointer moves the hand under it, the wheel presses, the space bar is the stylus button. What it does not
take passes through: navigation, panels, menus, all other shortcuts. Over anything but a 3D view it takes
nothing, and the hand stays where it is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, cast

import bpy
from proxygraph import SessionError, SimulatedDevice

from ..formats import FormatError
from ..touch.error import TouchError
from ..touch.live import RENDERING, Touch, live
from ..touch.mouse import BEGINNING, give_back_hand, grab, let_go, take_hand
from ..touch.mouse_hand import NOTCH, MouseHand
from ..touch.placement import Placement
from ..touch.pointer_map import PointerMap
from ..touch.pointer_view import PointerView, Rows
from ..touch.start import chosen_terrain, start_touch
from ..touch.stop import stop_touch
from .mouse_keys import Key, keys, labels
from .operator_status import OperatorStatus
from .status_bar import status_bar
from .view_under_pointer import SeenView, has_view, view_under_pointer

BETWEEN_LOOKS = 0.1
"""Seconds between two events of the operator's own timer, by which it learns that touch has ended."""

TWIST = math.radians(5.0)
"""Radians that the handle turns for a press of a key; it repeats while it is held."""

DEAF = 0.5
"""Seconds without any event after which an operator above is taken for one that lets none pass: nor would it
let the release of a button pass. Timers get by it, and keys that are held down repeat themselves."""

IDNAME = "HAPTIC_TERRAIN_OT_mouse_touch"
"""Of the operator, as Blender lists those that run."""

MOVES = ("MOUSEMOVE", "INBETWEEN_MOUSEMOVE")

_running: list[Any] = []
"""The operator that runs, for when the extension is taken away."""


class HAPTIC_TERRAIN_OT_mouse_touch(bpy.types.Operator):
    """Touch the terrain with the mouse: it moves the hand, the wheel presses, the space bar grabs"""

    bl_idname = "haptic_terrain.mouse_touch"
    bl_label = "Touch with Mouse"

    _hand: MouseHand | None = None
    _began = False
    """Whether touch began with it, and ends with it."""
    _keys: tuple[Key, ...] = ()
    _button: str | None = None
    """The key that holds the stylus button down."""
    _timer: bpy.types.Timer | None = None
    _is_crosshair = False

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Only in a window, with a terrain, and where the hand is a simulated one."""
        reason = _refusal(context)
        if reason is not None:
            cls.poll_message_set(reason)
        return reason is None

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Take the hand, or begin to touch with one; it comes to the pointer, if that is over a 3D view."""
        self._began = live.touch is None
        try:
            touch = live.touch or start_touch(context, device=SimulatedDevice(target=BEGINNING))
        except (TouchError, FormatError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if self._began:
            # Else the cursor lies between two steps, and the next undo takes it, and touch, away.
            bpy.ops.ed.undo_push(message=self.bl_label)
        self._hand = take_hand(touch, BEGINNING if self._began else None)
        self._keys = tuple(keys(context))
        self._timer = context.window_manager.event_timer_add(BETWEEN_LOOKS, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set(cast("str", status_bar(*hints(self._keys))))
        _running.append(self)
        over = self._over(context, event, touch)
        if over is not None:
            self._hand.go_under(*over)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> OperatorStatus:
        """Take what moves the hand, and let all else pass."""
        touch, hand = live.touch, self._hand
        if touch is None or hand is None or touch.mouse is not hand or not has_view(context.window):
            self._end(context)
            return {"CANCELLED"}
        if event.type.startswith("TIMER"):
            if hand.pulled_at - hand.heard_at > DEAF and _is_below(context.window):
                self._release(touch)
            return {"PASS_THROUGH"}
        hand.heard_at = hand.pulled_at
        if event.type == "WINDOW_DEACTIVATE":  # keys that are let go now are let go unheard
            self._release(touch)
            hand.stay()
            return {"PASS_THROUGH"}
        if event.type == self._button and event.value == "RELEASE":
            self._release(touch)
            return {"RUNNING_MODAL"}
        over = self._over(context, event, touch)
        self._show_pointer(context, is_crosshair=over is not None)
        if over is None:
            hand.stay()
            return {"PASS_THROUGH"}
        key = next((key for key in self._keys if key.is_meant(event)), None)
        if event.type in MOVES:
            self._move(touch, hand, over, lifts=key is not None and key.action == "HEIGHT")
            return {"PASS_THROUGH"}
        if key is None:
            if event.value != "RELEASE":  # whatever begins now moves the pointer for itself
                hand.stay()
            return {"PASS_THROUGH"}
        return self._act(context, touch, hand, key, event, over)

    def cancel(self, context: bpy.types.Context) -> None:
        """Blender takes it away: another file is loaded, or the window is closed."""
        self._end(context)

    def _act(
        self,
        context: bpy.types.Context,
        touch: Touch,
        hand: MouseHand,
        key: Key,
        event: bpy.types.Event,
        over: tuple[tuple[float, float], PointerMap],
    ) -> OperatorStatus:
        """Do what a key says."""
        pointer, seen = over
        zooms = _mode(touch) == "zoom"
        if key.action == "END":
            self._end(context)
            return {"FINISHED"}
        if key.action == "BUTTON":
            self._press(touch, event)
        elif key.action == "RAISE":
            hand.go_out(pointer, seen, NOTCH, upright=zooms)
        elif key.action == "LOWER":
            hand.go_out(pointer, seen, -NOTCH, upright=zooms)
        elif key.action == "HEIGHT":  # of a trackpad, whose fingers move and whose pointer does not
            pixels = event.mouse_y - event.mouse_prev_y
            hand.go_out(pointer, seen, pixels * seen.metres_per_pixel(hand.goal), upright=zooms)
        else:
            hand.turn_left += TWIST if key.action == "TWIST_LEFT" else -TWIST
        return {"RUNNING_MODAL"}

    def _move(
        self,
        touch: Touch,
        hand: MouseHand,
        over: tuple[tuple[float, float], PointerMap],
        *,
        lifts: bool,
    ) -> None:
        """Follow the pointer. In zoom mode only the hand's height counts: there the mouse has no other."""
        pointer, seen = over
        mode = _mode(touch)
        if lifts or mode == "zoom":
            hand.lift_with(pointer, seen, upright=mode == "zoom")
        else:
            hand.move(pointer, seen, catches_up=mode == "normal")

    def _press(self, touch: Touch, event: bpy.types.Event) -> None:
        if event.is_repeat:
            return
        try:
            grab(touch)
            self._button = event.type
        except SessionError as error:
            self.report({"WARNING"}, str(error))

    def _release(self, touch: Touch) -> None:
        let_go(touch)
        self._button = None

    def _over(
        self, context: bpy.types.Context, event: bpy.types.Event, touch: Touch
    ) -> tuple[tuple[float, float], PointerMap] | None:
        """The pointer in a view of the touched scene, and what it means there."""
        if context.window is None or context.window.scene != touch.scene.find():
            return None
        found = view_under_pointer(context.window, event.mouse_x, event.mouse_y)
        terrain = touch.terrain.find()
        if found is None or terrain is None:
            return None
        placement = Placement.of(terrain, touch.frame)
        return (found.pointer, _map(touch, placement, found)) if placement.is_usable else None

    def _show_pointer(self, context: bpy.types.Context, *, is_crosshair: bool) -> None:
        if is_crosshair == self._is_crosshair:
            return
        self._is_crosshair = is_crosshair
        if is_crosshair:
            context.window.cursor_modal_set("CROSSHAIR")
        else:
            context.window.cursor_modal_restore()

    def _end(self, context: bpy.types.Context) -> None:
        """Give back the hand, and all that shows that it was taken; harmless the second time."""
        hand, self._hand = self._hand, None
        if self in _running:
            _running.remove(self)
        if context.window is not None:
            self._show_pointer(context, is_crosshair=False)
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            self._timer = None
        if context.workspace is not None:
            context.workspace.status_text_set(None)
        touch = live.touch
        if touch is None or hand is None or touch.mouse is not hand:
            return
        give_back_hand(touch)
        if self._began:
            stop_touch()


def unregister() -> None:
    """End the operator that runs, before Blender forgets it."""
    while _running:
        _running.pop().cancel(bpy.context)


def hints(known: Sequence[Key]) -> list[str]:
    """Which keys do what, for the status bar."""
    all_hints = (
        ("Mouse", "hand"),
        (labels(known, "RAISE", "LOWER", "HEIGHT"), "up and down, press"),
        (labels(known, "BUTTON"), "grab: pan on the ground, zoom in the air"),
        (labels(known, "TWIST_LEFT", "TWIST_RIGHT"), "twist while zooming"),
        (labels(known, "END"), "end"),
    )
    return [f"{key}: {what}" for key, what in all_hints if key]


def _refusal(context: bpy.types.Context) -> str | None:
    """Why it cannot run now."""
    if bpy.app.background:
        return "In the background there is no mouse: Start Touch, and move the Touch Target"
    if live.rendering:
        return RENDERING
    if live.touch is None:
        try:
            chosen_terrain(context)
        except TouchError as error:
            return str(error)
        return None
    if live.touch.mouse is not None:
        return "The mouse touches already; Esc over the 3D view ends it"
    if not live.touch.is_simulated:
        return "Another device holds the hand: stop touch first"
    return None


def _is_below(window: Any) -> bool:
    """Whether another operator runs that hears of everything first."""
    running = window.modal_operators
    return len(running) > 0 and running[0].bl_idname != IDNAME


def _mode(touch: Touch) -> str:
    return touch.readout.mode if touch.readout is not None else "normal"


def _map(touch: Touch, placement: Placement, found: SeenView) -> PointerMap:
    view, world = found.view, cast("Rows", placement.matrix)
    seen = PointerView.of(view.view_matrix, view.window_matrix, world, found.size)
    return PointerMap(seen, touch.frame, touch.view_window, touch.workspace)
