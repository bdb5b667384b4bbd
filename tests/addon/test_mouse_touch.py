"""Touch with Mouse, driven by events as Blender would send them; in the background there are none."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from proxygraph import SessionError

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.addon.stand_in import StandIn
from tests.addon.status_bar import said
from tests.formats.megdr_pair import MegdrPair, planet

PASSED, TAKEN, ENDED = {"PASS_THROUGH"}, {"RUNNING_MODAL"}, {"FINISHED"}

SIDEBAR = (750.0, 200.0)
OUTLINER = (950.0, 200.0)


class Screen:
    """A window with one 3D view seen from above, its sidebar, and another editor; and the events' manager."""

    def __init__(self, scene: Any) -> None:
        self.status: list[Any] = []
        self.timers = 0
        self.pointers: list[str] = []
        # Ten units are 500 pixels high: 0.02 units for a pixel.
        projection = (
            (2.0 / 16.0, 0.0, 0.0, 0.0),
            (0.0, 0.2, 0.0, 0.0),
            (0.0, 0.0, -0.01, 0.0),
            (0.0, 0.0, 0.0, 1.0),
        )
        self.view = SimpleNamespace(
            view_matrix=(
                (1.0, 0.0, 0.0, 0.0),
                (0.0, 1.0, 0.0, 0.0),
                (0.0, 0.0, 1.0, -20.0),
                (0.0, 0.0, 0.0, 1.0),
            ),
            window_matrix=projection,
        )
        box = SimpleNamespace
        regions = [
            box(type="WINDOW", x=0, y=0, width=800, height=500, data=self.view),
            box(type="UI", x=700, y=0, width=100, height=500, data=None),
            box(type="TOOLS", x=0, y=0, width=1, height=500, data=None),
        ]
        areas = [
            box(type="VIEW_3D", x=0, y=0, width=800, height=500, regions=regions),
            box(type="OUTLINER", x=802, y=0, width=300, height=500, regions=[]),
        ]
        self.window = SimpleNamespace(
            scene=scene,
            screen=SimpleNamespace(areas=areas),
            modal_operators=[SimpleNamespace(bl_idname="HAPTIC_TERRAIN_OT_mouse_touch")],
            cursor_modal_set=self.pointers.append,
            cursor_modal_restore=lambda: self.pointers.append("as ever"),
        )
        self.context = SimpleNamespace(
            window=self.window,
            window_manager=SimpleNamespace(
                event_timer_add=self._add,
                event_timer_remove=self._remove,
                modal_handler_add=lambda _operator: None,
                keyconfigs=bpy.context.window_manager.keyconfigs,
            ),
            workspace=SimpleNamespace(status_text_set=self.status.append),
            scene=scene,
            view_layer=bpy.context.view_layer,
        )

    def hints(self) -> str:
        """What the status bar says."""
        return said(self.status[-1])

    def _add(self, _seconds: float, *, window: object) -> object:
        self.timers += 1
        return object()

    def _remove(self, _timer: object) -> None:
        self.timers -= 1


class Mouse:
    """The operator, and a person who moves the mouse and presses keys."""

    def __init__(self) -> None:
        bpy.context.window_manager.keyconfigs.update()
        self.screen = Screen(bpy.context.scene)
        self.place = (400.0, 250.0)
        self.reports: list[tuple[set[str], str]] = []
        cls = module("ui.mouse_touch").HAPTIC_TERRAIN_OT_mouse_touch
        self.operator = SimpleNamespace(
            bl_label=cls.bl_label,
            _hand=None,
            _began=False,
            _keys=(),
            _button=None,
            _timer=None,
            _is_crosshair=False,
        )
        self.operator.report = lambda kind, text: self.reports.append((kind, text))
        for name in (
            "invoke",
            "modal",
            "cancel",
            "_act",
            "_move",
            "_press",
            "_release",
            "_over",
            "_show_pointer",
            "_end",
        ):
            setattr(self.operator, name, getattr(cls, name).__get__(self.operator))

    def begin(self) -> Any:
        """Start the operator with the pointer where it is."""
        assert self.operator.invoke(self.screen.context, self._event("LEFTMOUSE", "PRESS")) == TAKEN
        return touch()

    def move(self, x: float, y: float, **held: bool) -> set[str]:
        self.place = (x, y)
        return self.send("MOUSEMOVE", "NOTHING", **held)

    def send(self, kind: str, value: str = "PRESS", **rest: Any) -> set[str]:
        result: set[str] = self.operator.modal(self.screen.context, self._event(kind, value, **rest))
        return result

    def _event(self, kind: str, value: str, **rest: Any) -> SimpleNamespace:
        held = dict.fromkeys(("shift", "ctrl", "alt", "oskey", "is_repeat"), False)
        place = {"mouse_x": self.place[0], "mouse_y": self.place[1], "mouse_prev_y": self.place[1]}
        return SimpleNamespace(type=kind, value=value, **{**held, **place, **rest})


@pytest.fixture(autouse=True)
def stepped(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Let the operator begin a touch that tests step, and leave no operator behind."""
    operator, start = module("ui.mouse_touch"), module("touch.start").start_touch

    def start_stepped(context: Any, **options: Any) -> Any:
        return start(bpy.context, **options, on_the_clock=False)

    monkeypatch.setattr(operator, "start_touch", start_stepped)
    yield
    operator._running.clear()


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    """Give gentle hills: what is felt on them follows from how deep a hand is."""
    hills = [
        [round(800.0 * math.sin(column / 9.0) + 500.0 * math.cos(row / 7.0)) for column in range(60)]
        for row in range(40)
    ]
    return import_grid(MegdrPair(hills).write(tmp_path))


@pytest.fixture
def mouse(terrain: bpy.types.Object) -> Mouse:
    return Mouse()


def touch() -> Any:
    return module("touch.live").live.touch


def step(ticks: int = 600, mouse: Mouse | None = None) -> None:
    """Let servo and timers run, and the operator hear of its own."""
    for _ in range(ticks // 20):
        touch().session.step(20)
        module("touch.tick").tick()
        if mouse is not None:
            mouse.send("TIMER", "NOTHING")


def shown_hand() -> tuple[float, float]:
    """Pixels where the hand is seen."""
    east, north, up = touch().session.state().goal
    x, y, _z = touch().frame.to_object(east, north, up)
    return 400.0 + x / 0.02, 250.0 + y / 0.02


def test_in_the_background_it_says_what_to_do_instead(terrain: bpy.types.Object) -> None:
    assert not bpy.ops.haptic_terrain.mouse_touch.poll()
    with pytest.raises(RuntimeError, match="In the background there is no mouse"):
        bpy.ops.haptic_terrain.mouse_touch("INVOKE_DEFAULT")


def test_it_begins_to_touch_without_an_empty_and_ends_what_it_began(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    assert not [thing for thing in bpy.data.objects if thing.type == "EMPTY"]
    assert begun.has_modes
    for hint in ("Space", "Wheel Down", "Page Up", "Esc: end"):
        assert hint in mouse.screen.hints()
    assert mouse.send("ESC") == ENDED
    assert touch() is None
    assert not begun.session.running
    assert (mouse.screen.timers, mouse.screen.status[-1]) == (0, None)
    assert mouse.send("MOUSEMOVE", "NOTHING") == {"CANCELLED"}, "an event that was under way"


def test_the_hand_stays_under_the_pointer(mouse: Mouse) -> None:
    mouse.begin()
    step(mouse=mouse)
    assert shown_hand() == pytest.approx((400.0, 250.0), abs=1.0)
    for place in ((500.0, 300.0), (250.0, 180.0)):
        assert mouse.move(*place) == PASSED, "others may look where the pointer is"
        step(mouse=mouse)
        assert shown_hand() == pytest.approx(place, abs=1.0)
    assert mouse.screen.pointers == ["CROSSHAIR"]


def test_the_wheel_presses_and_lifts(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    assert not begun.readout.in_contact
    for _ in range(8):
        assert mouse.send("WHEELDOWNMOUSE") == TAKEN
    step(1500, mouse)
    assert begun.readout.in_contact
    force = begun.readout.force
    assert force > 0.5
    for _ in range(3):
        mouse.send("WHEELDOWNMOUSE")
    step(1500, mouse)
    assert begun.readout.force == pytest.approx(force + 3 * 0.375, rel=0.3)
    for _ in range(15):
        mouse.send("WHEELUPMOUSE")
    step(1500, mouse)
    assert not begun.readout.in_contact


def test_who_has_no_wheel_presses_by_a_modifier_or_with_two_fingers(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    place, height = shown_hand(), begun.mouse.goal[2]
    assert mouse.move(430.0, 230.0, alt=True) == PASSED
    assert begun.mouse.goal[2] < height
    step(mouse=mouse)
    assert shown_hand() == pytest.approx(place, abs=1.0)
    low = begun.mouse.goal[2]
    assert mouse.send("TRACKPADPAN", "NOTHING", alt=True, mouse_prev_y=mouse.place[1] - 12.0) == TAKEN
    assert begun.mouse.goal[2] > low
    assert mouse.send("TRACKPADPAN", "NOTHING") == PASSED, "without the modifier it turns the view"


def test_the_space_bar_grabs_the_ground_and_the_ground_follows(mouse: Mouse) -> None:
    begun = mouse.begin()
    for _ in range(8):
        mouse.send("WHEELDOWNMOUSE")
    step(1500, mouse)
    before = begun.session.window.east
    assert mouse.send("SPACE") == TAKEN
    assert mouse.send("SPACE", is_repeat=True) == TAKEN, "a key that repeats does not play the animation"
    step(60, mouse)
    assert begun.readout.mode == "pan"
    for x in range(400, 500, 10):
        mouse.move(float(x), 250.0)
        step(60, mouse)
    step(1000, mouse)
    moved = (before - begun.session.window.east) * begun.frame.units_per_metre
    assert moved == pytest.approx(90 * 0.02, rel=0.25)
    assert mouse.send("SPACE", "RELEASE") == TAKEN
    step(40, mouse)
    assert begun.readout.mode == "normal"


def test_in_the_air_it_zooms_by_the_pointers_height_and_twists(mouse: Mouse) -> None:
    begun = mouse.begin()
    for _ in range(4):
        mouse.send("WHEELUPMOUSE")
    step(1000, mouse)
    width = begun.session.window.width
    mouse.send("SPACE")
    step(60, mouse)
    assert begun.readout.mode == "zoom"
    mouse.move(400.0, 251.0)
    mouse.move(400.0, 330.0)
    step(1500, mouse)
    assert begun.session.window.width < 0.8 * width
    assert mouse.send("PAGE_UP") == TAKEN
    assert mouse.send("PAGE_UP", is_repeat=True) == TAKEN
    step(400, mouse)
    assert begun.session.window.turn == pytest.approx(-math.radians(10.0))
    mouse.send("PAGE_DOWN")
    step(400, mouse)
    assert begun.session.window.turn == pytest.approx(-math.radians(5.0))
    hand = begun.session.state().hand
    mouse.send("SPACE", "RELEASE")
    step(400, mouse)
    assert begun.session.state().hand == pytest.approx(hand, abs=3e-3), "the hand stays where it was let go"


@pytest.mark.parametrize(
    ("kind", "value", "rest"),
    [
        ("MIDDLEMOUSE", "PRESS", {}),
        ("MIDDLEMOUSE", "PRESS", {"shift": True}),
        ("WHEELUPMOUSE", "PRESS", {"ctrl": True}),
        ("NUMPAD_7", "PRESS", {}),
        ("TRACKPADZOOM", "NOTHING", {}),
        ("NDOF_MOTION", "NOTHING", {}),
        ("S", "PRESS", {"ctrl": True}),
        ("Z", "PRESS", {"ctrl": True}),
        ("F12", "PRESS", {}),
        ("N", "PRESS", {}),
        ("LEFTMOUSE", "PRESS", {}),
        ("RIGHTMOUSE", "PRESS", {}),
        ("SPACE", "PRESS", {"ctrl": True}),
    ],
)
def test_navigation_saving_and_all_else_pass_through(
    mouse: Mouse, kind: str, value: str, rest: dict[str, bool]
) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    goal = begun.mouse.goal
    assert mouse.send(kind, value, **rest) == PASSED
    assert mouse.move(600.0, 400.0) == PASSED
    assert begun.mouse.goal == goal, "the pointer may have been moved for something else"
    assert (begun.is_pressed, touch()) == (False, begun)


def test_a_key_that_comes_up_passes_and_changes_nothing(mouse: Mouse) -> None:
    begun = mouse.begin()
    mouse.move(401.0, 250.0)
    step(mouse=mouse)
    for kind in ("PAGE_UP", "ESC", "S", "SPACE"):
        assert mouse.send(kind, "RELEASE") == PASSED
    mouse.move(450.0, 250.0)
    step(mouse=mouse)
    assert touch() is begun
    assert shown_hand() == pytest.approx((450.0, 250.0), abs=1.0)


@pytest.mark.parametrize("place", [SIDEBAR, OUTLINER, (-50.0, 9000.0)])
def test_over_anything_else_everything_passes_and_the_hand_stays(
    mouse: Mouse, place: tuple[float, float]
) -> None:
    begun = mouse.begin()
    mouse.move(401.0, 250.0)
    step(mouse=mouse)
    goal = begun.mouse.goal
    for kind in ("SPACE", "WHEELDOWNMOUSE", "PAGE_UP", "ESC", "LEFTMOUSE"):
        mouse.place = place
        assert mouse.send(kind) == PASSED
    assert mouse.move(*place) == PASSED
    assert mouse.screen.pointers[-1] == "as ever"
    step(mouse=mouse)
    assert begun.mouse.goal == goal
    mouse.move(600.0, 400.0)
    assert begun.mouse.goal == goal, "nor does it jump where the pointer comes back"
    mouse.move(610.0, 400.0)
    assert begun.mouse.goal != goal


def test_a_button_that_is_let_go_elsewhere_is_let_go(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    mouse.send("SPACE")
    mouse.place = OUTLINER
    assert mouse.send("SPACE", "RELEASE") == TAKEN
    assert not begun.is_pressed
    assert mouse.send("SPACE", "RELEASE") == PASSED


def test_a_window_that_is_left_lets_the_button_go(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    mouse.send("SPACE")
    step(mouse=mouse)
    assert mouse.send("WINDOW_DEACTIVATE", "NOTHING") == PASSED
    assert not begun.is_pressed
    step(40, mouse)
    assert begun.readout.mode == "normal"


def test_an_operator_above_that_takes_all_events_makes_the_hand_let_go_and_stay(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    mouse.send("SPACE")
    step(1000, mouse)
    assert begun.is_pressed, "a hand that holds still holds on"
    assert mouse.send("MIDDLEMOUSE") == PASSED
    mouse.screen.window.modal_operators.insert(0, SimpleNamespace(bl_idname="VIEW3D_OT_rotate"))
    step(400, mouse)
    assert begun.is_pressed, "half a second may pass"
    goal = begun.mouse.goal
    step(200, mouse)
    assert not begun.is_pressed
    mouse.screen.window.modal_operators.pop(0)
    mouse.move(600.0, 400.0)
    assert begun.mouse.goal == goal
    mouse.send("SPACE")
    step(600, mouse)
    assert begun.is_pressed, "afterwards all is as before"


def test_an_operator_above_that_lets_events_pass_changes_nothing(mouse: Mouse) -> None:
    begun = mouse.begin()
    mouse.screen.window.modal_operators.insert(0, SimpleNamespace(bl_idname="OTHER_OT_screencast"))
    step(mouse=mouse)
    mouse.send("SPACE")
    for _ in range(5):
        step(400, mouse)
        mouse.send("SPACE", is_repeat=True)
    assert begun.is_pressed


def test_a_servo_that_is_busy_hears_of_the_release_later(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    session = begun.session
    mouse.send("SPACE")

    def refuse(*_arguments: object) -> None:
        raise SessionError("256 commands wait for the servo already")

    begun.session = StandIn(session, release=refuse)
    mouse.send("SPACE", "RELEASE")
    assert begun.is_pressed
    begun.session = StandIn(session, press=refuse)
    step(40, mouse)
    assert not begun.is_pressed
    mouse.send("SPACE")
    assert mouse.reports[-1][0] == {"WARNING"}
    assert "256 commands wait" in mouse.reports[-1][1]
    assert not begun.is_pressed
    begun.session = session


def test_the_empty_gives_the_hand_and_gets_it_back_where_it_is(mouse: Mouse) -> None:
    module("touch.start").start_touch(bpy.context, on_the_clock=False)
    empty = bpy.data.objects["Touch Target"]
    step(mouse=None)
    begun = mouse.begin()
    place = empty.location.copy()
    mouse.move(401.0, 250.0)
    mouse.move(600.0, 400.0)
    step(mouse=mouse)
    assert empty.location == place
    hand = begun.session.state().hand
    assert hand[0] > 0.02
    assert mouse.send("ESC") == ENDED
    assert touch() is begun, "touch had begun before"
    bpy.context.view_layer.update()
    assert empty.location != place
    step()
    assert begun.session.state().hand == pytest.approx(hand, abs=1e-3)


def test_the_hand_is_carried_across_the_seam(tmp_path: Path) -> None:
    import_grid(planet().write(tmp_path))
    mouse = Mouse()
    begun = mouse.begin()
    window, turn = begun.session.window, begun.frame.turn
    seam = type(window)(
        0.01 * turn, window.north, window.up, width=0.2 * turn, exaggeration=window.exaggeration
    )
    module("touch.follow").lay_window(begun, seam)
    step(mouse=mouse)
    for x in (170.0, 160.0, 150.0, 140.0, 130.0, 120.0, 110.0, 100.0):
        mouse.move(x, 250.0)
        step(200, mouse)
    # The map's western edge is 250 pixels left of the middle, at 150.
    east = begun.session.state().goal[0]
    assert east < -0.02 * turn
    assert bpy.data.objects["Haptic Cursor"].matrix_world.translation.x > 0.0, "it is shown at the other edge"


def test_another_hand_is_not_taken_away(terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch) -> None:
    operator = module("ui.mouse_touch")
    monkeypatch.setattr(operator.bpy, "app", SimpleNamespace(background=False))
    refusal = operator._refusal
    assert refusal(bpy.context) is None
    module("touch.start").start_touch(bpy.context, device=sweep(), on_the_clock=False)
    assert "Another device holds the hand" in refusal(bpy.context)
    module("touch.stop").stop_touch()
    Mouse().begin()
    assert "touches already" in refusal(bpy.context)
    module("touch.live").live.rendering = True
    assert "rendered" in refusal(bpy.context)
    module("touch.live").live.rendering = False
    module("touch.stop").stop_touch()
    bpy.data.objects.remove(terrain)
    assert "import a grid" in refusal(bpy.context)


def test_a_terrain_that_cannot_be_touched_is_explained(mouse: Mouse, tmp_path: Path) -> None:
    (tmp_path / "grid.img").unlink()
    assert mouse.operator.invoke(mouse.screen.context, None) == {"CANCELLED"}
    assert mouse.reports[0][0] == {"ERROR"}
    assert "grid.img" in mouse.reports[0][1]
    assert (mouse.screen.timers, mouse.screen.status) == (0, [])


def stop_it(_mouse: Mouse) -> None:
    bpy.ops.haptic_terrain.touch_stop()


def delete_terrain(_mouse: Mouse) -> None:
    bpy.data.objects.remove(touch().terrain.find())
    module("touch.tick").tick()


def close_view(mouse: Mouse) -> None:
    mouse.screen.window.screen.areas.pop(0)


def start_again(_mouse: Mouse) -> None:
    module("touch.stop").stop_touch()
    module("touch.start").start_touch(bpy.context, on_the_clock=False)


@pytest.mark.parametrize("happens", [stop_it, delete_terrain, close_view, start_again])
def test_it_ends_with_what_it_needs(mouse: Mouse, happens: Callable[[Mouse], None]) -> None:
    begun = mouse.begin()
    mouse.send("SPACE")
    step(100, mouse)
    happens(mouse)
    assert mouse.send("TIMER", "NOTHING") == {"CANCELLED"}
    assert (mouse.screen.timers, mouse.screen.status[-1]) == (0, None)
    assert mouse.screen.pointers[-1] == "as ever"
    assert touch() is not begun
    assert module("ui.mouse_touch")._running == []


def test_another_file_ends_it(mouse: Mouse, tmp_path: Path) -> None:
    begun = mouse.begin()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "scene.blend"))
    assert not begun.session.running
    mouse.operator.cancel(mouse.screen.context)
    assert (mouse.screen.timers, mouse.screen.status[-1], touch()) == (0, None, None)


def test_disabling_the_extension_ends_it(mouse: Mouse, monkeypatch: pytest.MonkeyPatch) -> None:
    import addon_utils
    from enable_addon import MODULE, enable

    begun = mouse.begin()
    # In the background bpy.context has no events to take back; the operator is asked with its own.
    operator = module("ui.mouse_touch")
    monkeypatch.setattr(mouse.operator, "cancel", lambda _context: mouse.operator._end(mouse.screen.context))
    addon_utils.disable(MODULE)
    assert operator._running == []
    assert not begun.session.running
    assert (mouse.screen.timers, mouse.screen.status[-1], begun.mouse) == (0, None, None)
    enable()


def test_undo_leaves_the_hand_to_the_mouse(mouse: Mouse) -> None:
    bpy.context.preferences.edit.use_global_undo = True
    bpy.ops.ed.undo_push(message="imported")
    begun = mouse.begin()
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.ed.undo_push(message="something else")
    step(mouse=mouse)
    bpy.ops.ed.undo()
    mouse.screen.window.scene = bpy.context.scene
    mouse.move(401.0, 250.0)
    mouse.move(500.0, 300.0)
    step(mouse=mouse)
    assert touch() is begun
    assert shown_hand() == pytest.approx((500.0, 300.0), abs=1.5)


def test_while_a_picture_is_rendered_the_servo_and_the_hand_go_on(mouse: Mouse) -> None:
    begun = mouse.begin()
    step(mouse=mouse)
    live, cursor = module("touch.live").live, bpy.data.objects["Haptic Cursor"]
    before, ticks = cursor.matrix_world.copy(), begun.session.statistics().ticks
    live.rendering = True
    mouse.move(401.0, 250.0)
    mouse.move(550.0, 250.0)
    step(mouse=mouse)
    live.rendering = False
    assert cursor.matrix_world == before
    assert begun.session.statistics().ticks == ticks + 600
    assert shown_hand() == pytest.approx((550.0, 250.0), abs=1.5)


def test_keys_can_be_changed_and_are_read_when_it_begins(mouse: Mouse) -> None:
    keys = module("ui.mouse_keys")
    items = keys.keymap_items(bpy.context)
    assert sorted({item.properties.action for item in items}) == sorted(name for name, _l, _d in keys.ACTIONS)
    button = next(item for item in items if item.properties.action == "BUTTON")
    button.type, button.shift = "B", True
    begun = mouse.begin()
    assert "Shift B" in mouse.screen.hints()
    assert mouse.send("SPACE") == PASSED
    assert mouse.send("B") == PASSED
    assert not begun.is_pressed
    assert mouse.send("B", shift=True) == TAKEN
    assert begun.is_pressed
    button.type, button.shift = "SPACE", False


def test_keys_do_nothing_by_themselves_and_go_with_the_extension() -> None:
    import addon_utils
    from enable_addon import MODULE, enable

    def added() -> int:
        keymaps = bpy.context.window_manager.keyconfigs.addon.keymaps
        return sum(
            item.idname == "haptic_terrain.mouse_key" for keymap in keymaps for item in keymap.keymap_items
        )

    assert added() == len(module("ui.mouse_keys").DEFAULTS)
    assert not bpy.ops.haptic_terrain.mouse_key.poll()
    addon_utils.disable(MODULE)
    assert added() == 0
    enable()
