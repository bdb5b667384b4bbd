"""What people do to the scene, the view and the device while they touch."""

from __future__ import annotations

import itertools
import math
import os
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from mathutils import Euler, Matrix, Vector
from proxygraph import SessionError, Window

from tests.addon.hands import sweep
from tests.addon.scene import import_grid, module
from tests.addon.test_panels import drawn
from tests.formats.megdr_pair import MegdrPair, planet, rough


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    """Give gentle hills."""
    hills = [
        [round(800.0 * math.sin(column / 9.0) + 500.0 * math.cos(row / 7.0)) for column in range(60)]
        for row in range(40)
    ]
    return import_grid(MegdrPair(hills).write(tmp_path))


def start(**options: Any) -> Any:
    return module("touch.start").start_touch(bpy.context, **{"on_the_clock": False, **options})


def tick() -> None:
    module("touch.tick").tick()


def step(touch: Any, ticks: int) -> None:
    for _ in range(ticks // 20):
        touch.session.step(20)
        tick()


def live() -> Any:
    return module("touch.live").live


def target() -> bpy.types.Object:
    return bpy.data.objects["Touch Target"]


def cursor_place() -> Vector:
    return bpy.data.objects["Haptic Cursor"].matrix_world.translation.copy()


def drag(touch: Any, x: float, y: float, z: float, ticks: int = 2000) -> None:
    """Move the Empty by so much, Blender units, and let the hand arrive."""
    target().location += Vector((x, y, z))
    bpy.context.view_layer.update()
    step(touch, ticks)


# ---------------------------------------------------------------- the device


@pytest.mark.skipif(sys.platform != "linux", reason="a mapped file is cut as Linux allows it")
def test_a_mode_change_after_the_hand_was_taken_away_is_refused_or_harmless(tmp_path: Path) -> None:
    import_grid(MegdrPair(rough(64, 128)).write(tmp_path))
    touch = start()
    step(touch, 100)
    os.truncate(tmp_path / "grid.img", 4096)
    target().location.z = -0.5
    bpy.context.view_layer.update()
    module("touch.follow").follow_target(
        touch, module("touch.placement").Placement.of(touch.terrain.find(), touch.frame)
    )
    with pytest.raises(SessionError, match="cut while in use"):
        touch.session.step(1000)
    module("touch.stylus").press(touch)  # before Blender's timer has looked
    module("touch.stylus").release(touch)
    tick()
    assert live().touch is None
    assert "Touch stopped" in live().message
    for operator in (bpy.ops.haptic_terrain.press, bpy.ops.haptic_terrain.release):
        with pytest.raises(RuntimeError, match="start it first"):
            operator()


def ratchet(touch: Any, way: float) -> list[float]:
    """Grab the air, go up or down by metres of the hand, let go, come back: widths and upward forces."""
    forces = []
    low = -way / 2.0
    touch.session.set_target(0.0, 0.0, low)
    touch.session.step(500)
    touch.session.press()
    touch.session.step(20)
    for share in range(1, 51):
        touch.session.set_target(0.0, 0.0, low + way * share / 50.0)
        touch.session.step(20)
        forces.append(touch.session.state().force[2])
    touch.session.release()
    touch.session.step(20)
    return forces


@pytest.mark.parametrize(("way", "limit"), [(0.1, 4.0), (-0.1, None)])
def test_zoom_ends_softly_at_both_limits(terrain: bpy.types.Object, way: float, limit: float | None) -> None:
    from proxygraph import SimulatedDevice

    touch = start(device=SimulatedDevice(target=(0.0, 0.0, 0.05)))
    layout = touch.grid.layout
    whole = max(layout.columns - 1, 0) * layout.cell_width
    high = touch.session.window
    # High above the ground a hand that goes down meets none.
    touch.session.set_window(
        Window(high.east, high.north, -50_000.0, width=high.width, exaggeration=high.exaggeration)
    )
    touch.session.step(100)
    widths = []
    for _ in range(20):
        forces = ratchet(touch, way)
        widths.append(touch.session.window.width)
        tick()
    assert widths[-1] == pytest.approx(widths[-2]), "the limit is reached"
    if limit is not None:
        cell = max(layout.cell_width, layout.cell_height)
        assert widths[-1] == pytest.approx(limit * cell, rel=1e-6)
        assert min(forces) < -1.0, "a wall is felt"
    else:
        assert widths[-1] == pytest.approx(2.0 * whole, rel=0.05)
        assert max(forces) > 1.0, "a wall is felt"
    slew = touch.session.max_slew * 0.02
    steps = [abs(after - before) for before, after in itertools.pairwise(forces)]
    assert max(steps) <= slew


# ---------------------------------------------------------------- the terrain's place


def follows(touch: Any, terrain: bpy.types.Object) -> None:
    """The cursor is where the terrain's evaluated matrix has the proxy."""
    step(touch, 20)
    evaluated = terrain.evaluated_get(bpy.context.evaluated_depsgraph_get())
    state = touch.session.state()
    expected = evaluated.matrix_world @ Vector(touch.frame.to_object(*state.proxy))
    assert (cursor_place() - expected).length < 0.02


def test_a_terrain_moved_turned_and_scaled_in_mid_touch_is_followed(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    step(touch, 400)
    terrain.location, terrain.rotation_euler, terrain.scale = (1.0, 2.0, 3.0), (0.4, -0.3, 1.0), (2.0,) * 3
    bpy.context.view_layer.update()
    follows(touch, terrain)
    assert touch.shortcomings == ()


def test_a_parent_and_a_constraint_are_followed(terrain: bpy.types.Object) -> None:
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    touch = start(device=sweep())
    step(touch, 400)
    terrain.parent = parent
    parent.location, parent.rotation_euler, parent.scale = (2.0, 0.0, 1.0), (0.0, 0.5, 0.2), (0.5,) * 3
    bpy.context.view_layer.update()
    follows(touch, terrain)
    assert (terrain.matrix_world.translation - Vector((2.0, 0.0, 1.0))).length < 1e-6
    constraint: Any = terrain.constraints.new("LIMIT_LOCATION")
    constraint.use_min_z, constraint.min_z = True, 4.0
    bpy.context.view_layer.update()
    assert terrain.matrix_world.translation.z == pytest.approx(4.0)
    follows(touch, terrain)
    assert touch.shortcomings == ()


def test_shear_cannot_be_felt_and_is_said(terrain: bpy.types.Object) -> None:
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    touch = start(device=sweep())
    step(touch, 400)
    terrain.parent, terrain.rotation_euler = parent, (0.0, 0.0, 0.5)
    parent.scale = (2.0, 1.0, 1.0)
    bpy.context.view_layer.update()
    follows(touch, terrain)
    assert touch.shortcomings == (module("touch.shortcomings").SHEARED,)
    assert "sheared" in " ".join(drawn("HAPTIC_TERRAIN_PT_touch").labels)
    parent.scale = (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    step(touch, 20)
    assert touch.shortcomings == ()


def test_ground_that_is_stretched_one_way_is_said(terrain: bpy.types.Object) -> None:
    touch = start(device=sweep())
    terrain.scale = (1.0, 1.5, 1.0)
    bpy.context.view_layer.update()
    follows(touch, terrain)
    assert touch.shortcomings == (module("touch.shortcomings").UNEVEN,)
    for scale in ((1.0, 1.0, 3.0), (-1.0, 1.0, 1.0), (1.0, 1.0, -1.0)):
        terrain.scale = scale
        bpy.context.view_layer.update()
        follows(touch, terrain)
        assert touch.shortcomings == (), "heights may be stretched, and mirrors are followed"


@pytest.mark.parametrize("how", ["object", "view", "collection"])
def test_a_hidden_terrain_is_touched_on_and_said(terrain: bpy.types.Object, how: str) -> None:
    touch = start(device=sweep())
    step(touch, 100)
    collection = bpy.data.collections.new("Ground")
    bpy.context.scene.collection.children.link(collection)
    if how == "object":
        terrain.hide_viewport = True
    elif how == "view":
        terrain.hide_set(True)
    else:
        collection.objects.link(terrain)
        bpy.context.scene.collection.objects.unlink(terrain)
        bpy.context.view_layer.layer_collection.children["Ground"].exclude = True
    bpy.context.view_layer.update()
    step(touch, 400)
    assert live().touch is touch
    assert touch.readout.in_contact
    assert touch.shortcomings == (module("touch.shortcomings").HIDDEN,)


def test_a_mirrored_terrain_turns_the_view_the_other_way(terrain: bpy.types.Object) -> None:
    follow_view = module("touch.follow_view")
    touch = start(device=sweep())
    for scale in ((1.0, 1.0, 1.0), (-1.0, 1.0, 1.0), (1.0, -1.0, 1.0), (1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)):
        terrain.scale, terrain.rotation_euler = scale, (0.1, 0.2, 0.3)
        bpy.context.view_layer.update()
        here = module("touch.placement").Placement.of(terrain, touch.frame)
        before, after = (Window(1e6, -1e6, 0.0, width=1e6, turn=turn) for turn in (0.2, 0.5))
        moved = follow_view.in_scene(after, here) @ follow_view.in_scene(before, here).inverted()
        ways = [_rightward(window, here) for window in (before, after)]
        turned = moved.to_3x3().normalized() @ ways[0]
        assert (turned - ways[1]).length < 1e-2


def _rightward(window: Window, here: Any) -> Vector:
    """Where the workspace's x goes in the scene, of length 1."""
    begin = here.to_scene(window.east, window.north, window.up)
    far = 1e5
    end = here.to_scene(
        window.east + far * math.cos(window.turn), window.north + far * math.sin(window.turn), window.up
    )
    way: Vector = (end - begin).normalized()
    return way


def test_the_scenes_unit_changes_neither_readouts_nor_sizes(tmp_path: Path) -> None:
    seen = []
    for scale in (1.0, 0.001, 1000.0):
        bpy.context.scene.unit_settings.scale_length = scale
        terrain = import_grid(MegdrPair(rough(40, 60)).write(tmp_path))
        touch = start(terrain=terrain)
        step(touch, 500)
        readout, window = touch.readout, touch.session.window
        seen.append(
            (
                terrain.dimensions.length,
                *readout.coordinates,
                readout.elevation,
                window.width,
                bpy.data.objects["Haptic Cursor"].scale.x,
                target().empty_display_size,
                target().location.length,
                cursor_place().length,
            )
        )
        module("touch.stop").stop_touch()
        bpy.data.batch_remove(list(bpy.data.objects))
    assert seen[1] == pytest.approx(seen[0])
    assert seen[2] == pytest.approx(seen[0])


# ---------------------------------------------------------------- views


@pytest.fixture
def looked_at(terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Touch, as if someone looked, with the hand in the air."""
    monkeypatch.setattr(module("touch.follow_view"), "someone_looks", lambda: True)
    touch = start()
    step(touch, 500)
    return touch


def space() -> Any:
    return next(area for area in bpy.context.window.screen.areas if area.type == "VIEW_3D").spaces.active


def zoom(touch: Any, rise: float = 0.5) -> float:
    """Grab the air and go up by Blender units; gives how much narrower the window became."""
    before = touch.session.window.width
    touch.session.press()
    step(touch, 40)
    drag(touch, 0.0, 0.0, rise)
    touch.session.release()
    step(touch, 40)
    return float(touch.session.window.width / before)


class View:
    """Stands in for one region's view."""

    def __init__(self, perspective: str = "PERSP", *, locked: bool = False) -> None:
        self.view_location = Vector((1.0, 2.0, 0.0))
        self.view_rotation = Euler((0.5, 0.0, 0.2)).to_quaternion()
        self.view_distance = 10.0
        self.view_perspective = perspective
        self.lock_rotation = locked


def shown_in(touch: Any, monkeypatch: pytest.MonkeyPatch, *spaces: Any) -> None:
    """Let the window have these 3D views, and no others."""
    window = SimpleNamespace(scene=bpy.context.scene)
    areas = [
        SimpleNamespace(spaces=SimpleNamespace(active=space), tag_redraw=lambda: None) for space in spaces
    ]
    monkeypatch.setattr(
        module("touch.follow_view"), "views", lambda _context: [(window, area) for area in areas]
    )


def space_of(*views: View, locked_camera: bool = False, camera: Any = None) -> Any:
    return SimpleNamespace(
        region_3d=views[-1],
        region_quadviews=list(views) if len(views) > 1 else [],
        clip_start=0.5,
        lock_camera=locked_camera,
        use_local_camera=camera is not None,
        camera=camera,
        as_pointer=lambda: id(views),
    )


def test_all_four_views_two_viewports_and_orthographic_ones_follow_once(
    looked_at: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    quad = [View("ORTHO", locked=True), View("ORTHO", locked=True), View("ORTHO", locked=True), View()]
    other = View("ORTHO")
    shown_in(looked_at, monkeypatch, space_of(*quad), space_of(other))
    share = zoom(looked_at)
    assert share < 0.9
    for view in (*quad, other):
        assert view.view_distance == pytest.approx(10.0 * share, rel=1e-3)
    looked_at.session.press()
    step(looked_at, 40)
    rotation = other.view_rotation.copy()
    looked_at.session.set_twist(0.5)
    step(looked_at, 40)
    assert other.view_rotation.rotation_difference(rotation).angle == pytest.approx(0.5, abs=1e-2)
    assert quad[0].view_rotation == rotation, "a side view stays one"
    assert quad[3].view_rotation != rotation


@pytest.mark.parametrize("kind", ["PERSP", "ORTHO"])
def test_a_camera_goes_along_only_where_it_is_locked_to_the_view(
    looked_at: Any, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.scene.collection.objects.link(camera)
    camera.data.type = kind
    camera.matrix_world = Matrix.LocRotScale((0.0, -5.0, 5.0), Euler((0.8, 0.0, 0.0)), (2.0, 2.0, 2.0))
    bpy.context.scene.camera = camera
    before, size = camera.matrix_world.copy(), camera.data.ortho_scale
    free = space_of(View("CAMERA"))
    shown_in(looked_at, monkeypatch, free, space_of(View("CAMERA"), camera=camera))
    zoom(looked_at)
    assert camera.matrix_world == before
    assert free.clip_start == 0.5
    placement = module("touch.placement").Placement.of(looked_at.terrain.find(), looked_at.frame)
    in_scene = module("touch.follow_view").in_scene
    old = in_scene(looked_at.session.window, placement)
    shown_in(
        looked_at,
        monkeypatch,
        space_of(View("CAMERA"), locked_camera=True),
        space_of(View("CAMERA"), locked_camera=True),
    )
    share = zoom(looked_at)
    bpy.context.view_layer.update()
    new = in_scene(looked_at.session.window, placement)
    seen_before, seen = old.inverted() @ before, new.inverted() @ camera.matrix_world
    assert (seen.translation - seen_before.translation).length < 1e-3, (
        "once, though two views look through it"
    )
    assert camera.matrix_world.to_scale()[:] == pytest.approx((2.0, 2.0, 2.0), rel=1e-4)
    expected = size * share if kind == "ORTHO" else size
    assert camera.data.ortho_scale == pytest.approx(expected, rel=1e-3)


def test_what_is_near_is_cut_off_again_when_the_view_goes_away_and_when_touch_ends(looked_at: Any) -> None:
    own = space().clip_start = 0.05
    space().region_3d.view_distance = 2.0
    zoom(looked_at, 1.0)
    near = space().clip_start
    assert near < own
    zoom(looked_at, -1.0)
    assert space().clip_start > near
    zoom(looked_at, 1.0)
    module("touch.stop").stop_touch()
    assert space().clip_start == pytest.approx(own)


def test_what_a_person_chose_since_stays(looked_at: Any) -> None:
    space().clip_start = 0.05
    space().region_3d.view_distance = 2.0
    zoom(looked_at, 1.0)
    space().clip_start = 0.001
    module("touch.stop").stop_touch()
    assert space().clip_start == pytest.approx(0.001)


# ---------------------------------------------------------------- the Empty


def drifting(touch: Any) -> None:
    """Push the ground and let it go in motion."""
    drag(touch, 0.0, 0.0, -0.6)
    touch.session.press()
    step(touch, 100)
    assert touch.readout.mode == "pan"
    for _ in range(10):
        drag(touch, 0.08, 0.0, 0.0, ticks=20)
    touch.session.release()
    step(touch, 160)  # the hand arrives, and the ground goes on


def test_dragging_the_empty_while_the_ground_drifts_does_not_fight(
    terrain: bpy.types.Object, monkeypatch: pytest.MonkeyPatch
) -> None:
    touch = start()
    drifting(touch)
    monkeypatch.setattr(module("touch.follow"), "is_dragging", lambda: True)
    begin, hand = target().location.copy(), touch.session.state().hand
    east = touch.session.window.east
    for frame in range(1, 51):  # as G does: where it began, and so much
        target().location = begin + Vector((-0.004 * frame, 0.0, 0.0))
        bpy.context.view_layer.update()
        step(touch, 20)
        expected = hand[0] - 0.004 * frame * 0.16 / (touch.target_window.width * touch.frame.units_per_metre)
        assert touch.session.state().hand[0] == pytest.approx(expected, abs=2.5e-3)
    assert touch.session.window.east != east, "it drifted meanwhile"
    dragged = touch.session.state().hand
    monkeypatch.setattr(module("touch.follow"), "is_dragging", lambda: False)
    step(touch, 1000)
    assert target().location.x != pytest.approx(begin.x - 0.2, abs=1e-3), "it is brought to the hand"
    assert touch.session.state().hand == pytest.approx(dragged, abs=2.5e-3)


def test_nothing_is_dragged_in_the_background() -> None:
    assert not module("touch.dragging").is_dragging()


def test_a_transform_in_any_window_is_a_drag(monkeypatch: pytest.MonkeyPatch) -> None:
    dragging = module("touch.dragging")

    def windows(*names: str) -> Any:
        operators = [SimpleNamespace(bl_idname=name) for name in names]
        return SimpleNamespace(
            context=SimpleNamespace(
                window_manager=SimpleNamespace(
                    windows=[SimpleNamespace(modal_operators=[]), SimpleNamespace(modal_operators=operators)]
                )
            )
        )

    monkeypatch.setattr(dragging, "bpy", windows("HAPTIC_TERRAIN_OT_mouse_touch", "SCREEN_OT_animation_play"))
    assert not dragging.is_dragging()
    monkeypatch.setattr(dragging, "bpy", windows("TRANSFORM_OT_translate"))
    assert dragging.is_dragging()


def test_the_empty_leads_the_hand_across_the_seam(tmp_path: Path) -> None:
    import_grid(planet().write(tmp_path))
    touch = start()
    window, turn = touch.session.window, touch.frame.turn
    seam = Window(0.01 * turn, window.north, window.up, width=0.2 * turn, exaggeration=window.exaggeration)
    module("touch.follow").lay_window(touch, seam)
    target().location = (-4.9, 0.0, 0.6)
    bpy.context.view_layer.update()
    step(touch, 2000)
    assert touch.session.state().goal[0] == pytest.approx(0.01 * turn, abs=1e-3 * turn)
    drag(touch, -0.5, 0.0, 0.0)
    assert touch.session.state().goal[0] == pytest.approx(-0.04 * turn, abs=1e-3 * turn)
    assert cursor_place().x == pytest.approx(4.6, abs=0.02), "beyond the seam it is shown at the other edge"
    assert touch.readout.coordinates[0] == pytest.approx(0.96 * 360.0, abs=0.5)
    hand = touch.session.state().hand
    target().location.x += 10.0  # there, where the same ground is seen
    bpy.context.view_layer.update()
    step(touch, 1000)
    assert touch.session.state().hand == pytest.approx(hand, abs=1e-3)


def test_a_window_can_lie_around_an_empty_beyond_the_seam(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    start()
    module("touch.stop").stop_touch()
    bpy.context.scene.haptic_terrain.window_width = 1000.0
    target().location = (-5.5, 1.0, 0.5)
    bpy.context.view_layer.update()
    touch = start(terrain=terrain)
    step(touch, 200)
    assert touch.readout.coordinates[0] == pytest.approx(0.95 * 360.0, abs=0.5)
    assert touch.readout.on_map


def test_undo_in_mid_touch_leaves_the_hand_within_its_walls(terrain: bpy.types.Object) -> None:
    bpy.context.preferences.edit.use_global_undo = True
    touch = start()
    bpy.ops.ed.undo_push(message="touching")
    drag(touch, 0.0, 0.0, -0.6)
    touch.session.press()
    step(touch, 100)
    assert touch.readout.mode == "pan"
    drag(touch, 1.0, 0.0, 0.0)
    touch.session.release()
    step(touch, 1000)
    bpy.ops.ed.undo_push(message="panned")
    bpy.ops.ed.undo()
    step(touch, 1000)
    assert live().touch is touch
    x, y, z = touch.session.state().hand
    assert abs(x) < 0.081
    assert abs(y) < 0.061
    assert math.isfinite(z)
    assert touch.session.state().mode == "normal"


def test_nothing_of_the_scene_or_its_views_changes_while_a_picture_is_rendered(looked_at: Any) -> None:
    touch = looked_at
    touch.session.press()
    step(touch, 40)
    before = (cursor_place(), target().location.copy(), space().region_3d.view_distance)
    ticks = touch.session.statistics().ticks
    live().rendering = True
    touch.session.set_target(0.0, 0.0, 0.05)
    for _ in range(50):
        touch.session.step(20)
        tick()
    touch.session.release()
    step(touch, 200)
    assert (cursor_place(), target().location, space().region_3d.view_distance) == before
    assert touch.session.statistics().ticks == ticks + 1200
    live().rendering = False
    step(touch, 40)
    assert cursor_place() != before[0]
