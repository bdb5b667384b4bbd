"""Animated objects that feel the terrain."""

from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests.addon.scene import contents, curves_of, import_grid, module
from tests.formats.megdr_pair import MegdrPair, planet, rough

PLACES = ((1, (-4.0, -2.0, 2.0)), (10, (-3.0, -1.0, -1.0)), (30, (3.0, 1.5, -0.5)), (40, (4.0, 2.0, 2.0)))
"""Frames, and where the goal is: down, under the ground, and up again."""


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    bpy.context.scene.frame_end = 40
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path))


def moving(name: str = "Goal", places: Any = PLACES) -> bpy.types.Object:
    """Make an Empty that moves, and make it active."""
    goal = bpy.data.objects.new(name, None)
    bpy.context.scene.collection.objects.link(goal)
    for frame, place in places:
        goal.location = place
        goal.keyframe_insert("location", frame=frame)
    bpy.context.view_layer.objects.active = goal
    return goal


def described(goal: bpy.types.Object, terrain: bpy.types.Object, **options: Any) -> Any:
    """Describe a bake as the operator does."""
    animated, handle = module("record.animated"), module("touch.handle").Handle
    frames = options.pop("frames", (bpy.context.scene.frame_start, bpy.context.scene.frame_end))
    return module("record.bake").bake_of(
        bpy.context,
        animated.Animated(handle.to(goal), **options),
        terrain,
        animated.Frames(*frames, module("record.bake").SAMPLES_PER_FRAME),
    )


def result_of(bake: Any) -> Any:
    """Bake to the end."""
    work = module("record.bake").baked(bake)
    try:
        while True:
            next(work)
    except StopIteration as done:
        return done.value


def columns_of(goal: bpy.types.Object, terrain: bpy.types.Object, **options: Any) -> Any:
    return result_of(described(goal, terrain, **options)).data.columns


def goals(columns: Any) -> np.ndarray[Any, Any]:
    return np.stack([columns[f"goal_{axis}"] for axis in ("east", "north", "up")], axis=1)


def digest(columns: Any) -> str:
    whole = hashlib.sha256()
    for name in sorted(columns):
        whole.update(name.encode() + columns[name].tobytes())
    return whole.hexdigest()


def frame_of(terrain: bpy.types.Object) -> Any:
    return module("terrain.kept").recall_frame(terrain)


def test_a_bake_is_a_take_of_its_own(terrain: bpy.types.Object) -> None:
    goal = moving()
    before = set(bpy.data.objects)
    assert bpy.ops.haptic_terrain.bake() == {"FINISHED"}
    made = {thing.name.split(".")[0] for thing in set(bpy.data.objects) - before}
    assert {"Touch Take", "Touch Trail"} <= made
    take = next(thing for thing in set(bpy.data.objects) - before if thing.name.startswith("Touch Take"))
    keys = [len(curve.keyframe_points) for curve in curves_of(take) if curve.data_path == "location"]
    assert keys == [40, 40, 40]
    assert curves_of(goal)[0].keyframe_points[0].co[:] == (1.0, -4.0)


def test_twice_the_same_bits(terrain: bpy.types.Object) -> None:
    goal = moving()
    first = digest(columns_of(goal, terrain))
    bpy.context.scene.frame_set(17)
    assert digest(columns_of(goal, terrain)) == first


def test_the_proxy_stays_on_the_ground_while_the_goal_is_under_it(terrain: bpy.types.Object) -> None:
    columns = columns_of(moving(), terrain)
    touching = columns["feature"] != 0.0
    assert 0.5 < touching.mean() < 1.0
    grid = module("terrain.kept").recall(terrain).grid.open()
    ground = [
        grid.elevation_at(east, north)
        for east, north in zip(columns["proxy_east"], columns["proxy_north"], strict=True)
    ]
    apart = (columns["proxy_up"] - np.array(ground))[touching]
    assert np.abs(apart).max() < 1e-3
    assert (columns["force_z"][touching] > 0.0).all()
    assert (columns["force_z"][~touching] == 0.0).all()


def test_every_millisecond_has_a_tick_and_every_frame_its_goal(terrain: bpy.types.Object) -> None:
    goal = moving()
    columns = columns_of(goal, terrain)
    assert len(columns["time"]) == 39 * 1000 / 24 + 1
    assert np.diff(columns["time"]) == pytest.approx(0.001)
    for frame in (1, 13, 25, 37):
        bpy.context.scene.frame_set(frame)
        expected = frame_of(terrain).to_terrain(*goal.matrix_world.translation[:])
        tick = round((frame - 1) * 1000 / 24)
        assert goals(columns)[tick] == pytest.approx(expected, rel=1e-6, abs=1e-6 * abs(expected[0]))


def test_between_frames_the_goal_is_where_subframes_have_it(terrain: bpy.types.Object) -> None:
    goal = moving()
    columns = columns_of(goal, terrain)
    frame = frame_of(terrain)
    for tick in (123, 517, 901):
        at = 1.0 + tick * 24 / 1000
        bpy.context.scene.frame_set(int(at), subframe=at % 1.0)
        expected = np.array(frame.to_terrain(*goal.matrix_world.translation[:]))
        apart = (goals(columns)[tick] - expected) * (1.0, 1.0, frame.exaggeration) * frame.units_per_metre
        assert np.abs(apart).max() < 2e-4


def test_drivers_and_constraints_move_the_goal(terrain: bpy.types.Object) -> None:
    leader = moving("Leader")
    goal = bpy.data.objects.new("Led", None)
    bpy.context.scene.collection.objects.link(goal)
    copied = goal.constraints.new("COPY_LOCATION")
    copied.target = leader
    copied.use_z = False
    driver = goal.driver_add("location", 2).driver
    driver.expression = "-1.0 + 0.01 * frame"
    columns = columns_of(goal, terrain)
    frame = frame_of(terrain)
    heights = (columns["goal_up"] - frame.up) * frame.units_per_metre * frame.exaggeration
    at = 1.0 + columns["time"] * 24.0
    assert heights == pytest.approx(-1.0 + 0.01 * at, abs=1e-5)
    assert columns["goal_east"] == pytest.approx(columns_of(leader, terrain)["goal_east"], rel=1e-9)


def rig() -> bpy.types.Object:
    """A rig of one bone that swings down."""
    armature = bpy.data.armatures.new("Rig")
    thing = bpy.data.objects.new("Rig", armature)
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")
    bone = armature.edit_bones.new("Arm")
    bone.head, bone.tail = (0.0, 0.0, 1.0), (0.0, 2.0, 1.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    posed = thing.pose.bones["Arm"]
    posed.rotation_mode = "XYZ"
    for frame, angle in ((1, 0.0), (40, -math.pi / 2.0)):
        posed.rotation_euler.x = angle
        posed.keyframe_insert("rotation_euler", frame=frame)
    thing.location.x = 0.5
    return thing


@pytest.mark.parametrize(("tip", "last"), [("TAIL", (0.5, 0.0, -1.0)), ("HEAD", (0.5, 0.0, 1.0))])
def test_the_end_of_a_bone_is_a_goal(terrain: bpy.types.Object, tip: str, last: Any) -> None:
    columns = columns_of(rig(), terrain, bone="Arm", tip=tip)
    expected = frame_of(terrain).to_terrain(*last)
    assert goals(columns)[-1] == pytest.approx(expected, rel=1e-5, abs=1e-5 * abs(expected[0]))
    assert bool(columns["feature"].any()) == (tip == "TAIL")


def test_in_pose_mode_the_active_bone_is_meant(terrain: bpy.types.Object) -> None:
    thing = rig()
    bpy.ops.object.mode_set(mode="POSE")
    thing.data.bones.active = thing.data.bones["Arm"]
    assert module("ui.goal_choices").chosen_goal(bpy.context, "", "", "TAIL").bone == "Arm"
    with pytest.raises(RuntimeError, match="has no bone Leg"):
        bpy.ops.haptic_terrain.bake(bone="Leg")


def test_the_frame_is_restored(terrain: bpy.types.Object) -> None:
    scene, goal = bpy.context.scene, moving()
    scene.frame_set(7, subframe=0.25)
    columns_of(goal, terrain)
    assert (scene.frame_current, scene.frame_subframe) == (7, 0.25)
    for frame, x in ((20, 0.0), (40, 1.0)):
        terrain.location.x = x
        terrain.keyframe_insert("location", frame=frame)
    scene.frame_set(7, subframe=0.25)
    with pytest.raises(module("record.animated").AnimationError, match="moves at frame 20"):
        columns_of(goal, terrain)
    assert (scene.frame_current, scene.frame_subframe) == (7, 0.25)


def test_a_cancelled_bake_leaves_nothing(terrain: bpy.types.Object) -> None:
    scene, goal = bpy.context.scene, moving()
    scene.frame_set(7)
    before = contents()
    work = module("record.bake").baked(described(goal, terrain))
    shares = [next(work) for _ in range(20)]
    assert shares == sorted(shares)
    assert 0.0 < shares[-1] < 1.0
    assert scene.frame_current != 7
    work.close()
    assert scene.frame_current == 7
    assert contents() == before


def test_an_object_that_is_deleted_meanwhile_ends_the_bake(terrain: bpy.types.Object) -> None:
    scene, goal = bpy.context.scene, moving()
    work = module("record.bake").baked(described(goal, terrain))
    next(work)
    bpy.data.objects.remove(goal)
    with pytest.raises(module("record.animated").AnimationError, match="Goal is gone"):
        for _share in work:
            pass
    assert scene.frame_current == 1


@pytest.mark.parametrize(
    ("frames", "words"), [((40, 1), "run backwards, from 40 to 1"), ((5, 5), "Frame 5 alone is no path")]
)
def test_frames_that_are_no_path_are_refused(
    terrain: bpy.types.Object, frames: tuple[int, int], words: str
) -> None:
    moving()
    before = contents()
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.haptic_terrain.bake(frame_start=frames[0], frame_end=frames[1])
    assert contents() == before


def test_too_many_frames_are_refused(terrain: bpy.types.Object) -> None:
    moving()
    with pytest.raises(RuntimeError, match="bake it in parts"):
        bpy.ops.haptic_terrain.bake(frame_start=1, frame_end=1_000_000)


def test_film_on_video_keeps_its_time(terrain: bpy.types.Object) -> None:
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = 24, 1.001
    scene.frame_step = 2
    goal = moving()
    columns = columns_of(goal, terrain)
    seconds = 39 * 1.001 / 24
    assert seconds <= columns["time"][-1] < seconds + 0.001
    assert bpy.ops.haptic_terrain.bake() == {"FINISHED"}
    take = next(thing for thing in bpy.data.objects if thing.name.startswith("Touch Take"))
    assert {len(curve.keyframe_points) for curve in curves_of(take) if curve.data_path == "location"} == {40}


def test_stretched_time_is_refused(terrain: bpy.types.Object) -> None:
    moving()
    bpy.context.scene.render.frame_map_new = 200
    with pytest.raises(RuntimeError, match="Time Stretching"):
        bpy.ops.haptic_terrain.bake()


def test_a_goal_that_stands_still_is_told(terrain: bpy.types.Object) -> None:
    goal = moving(places=((1, (0.0, 0.0, -1.0)),))
    result = result_of(described(goal, terrain))
    assert any("does not move from frame 1 to 40" in note for note in result.notes)
    assert np.ptp(result.data.columns["proxy_east"]) == 0.0


def test_a_goal_in_the_air_is_told(terrain: bpy.types.Object) -> None:
    goal = moving(places=((1, (0.0, 0.0, 5.0)), (40, (1.0, 0.0, 5.0))))
    assert any("never touches" in note for note in result_of(described(goal, terrain)).notes)


def test_the_terrain_itself_is_no_goal(terrain: bpy.types.Object) -> None:
    bpy.context.view_layer.objects.active = terrain
    with pytest.raises(RuntimeError, match="is the terrain itself"):
        bpy.ops.haptic_terrain.bake()


def test_a_child_of_the_terrain_is_a_goal_as_any(terrain: bpy.types.Object) -> None:
    goal = moving()
    alone = columns_of(goal, terrain)
    goal.parent = terrain
    assert digest(columns_of(goal, terrain)) == digest(alone)


def test_a_terrain_that_moves_is_refused(terrain: bpy.types.Object) -> None:
    moving()
    for frame, x in ((1, 0.0), (40, 1.0)):
        terrain.location.x = x
        terrain.keyframe_insert("location", frame=frame)
    with pytest.raises(RuntimeError, match=r"moves at frame 1\.25"):
        bpy.ops.haptic_terrain.bake()


def test_a_terrain_may_stand_anywhere(terrain: bpy.types.Object) -> None:
    goal = moving()
    plain = columns_of(goal, terrain)
    mother = bpy.data.objects.new("Mother", None)
    bpy.context.scene.collection.objects.link(mother)
    goal.parent = mother
    mother.location = terrain.location = (8.0, -16.0, 4.0)
    mother.rotation_euler = terrain.rotation_euler = (0.0, 0.0, math.pi / 2.0)
    moved = columns_of(goal, terrain)
    assert goals(moved) == pytest.approx(goals(plain), abs=1e-5 / frame_of(terrain).units_per_metre)


def test_a_goal_that_is_no_number_is_told(terrain: bpy.types.Object) -> None:
    goal = moving()
    goal.parent = bpy.data.objects.new("Nowhere", None)
    bpy.context.scene.collection.objects.link(goal.parent)
    goal.parent.location.x = math.nan
    before = contents()
    with pytest.raises(RuntimeError, match="Goal at frame 1 is not a number"):
        bpy.ops.haptic_terrain.bake()
    assert contents() == before


def test_an_object_that_blender_does_not_evaluate_is_told(terrain: bpy.types.Object) -> None:
    goal = moving()
    goal.hide_set(True)
    assert columns_of(goal, terrain)["feature"].any()
    goal.hide_viewport = True
    with pytest.raises(module("record.animated").AnimationError, match="disabled in viewports"):
        columns_of(goal, terrain)


def test_a_goal_under_the_ground_from_the_beginning_is_felt_at_once(terrain: bpy.types.Object) -> None:
    goal = moving(places=((1, (-2.0, 0.0, -1.0)), (40, (2.0, 0.0, -1.0))))
    assert (columns_of(goal, terrain)["feature"] != 0.0).all()


@pytest.mark.parametrize("model", ["surface_walk", "proxy_graph", "god_object_release", "virtual_proxy"])
def test_the_chosen_model_answers(terrain: bpy.types.Object, model: str) -> None:
    bpy.context.scene.haptic_terrain.contact_model = model
    goal = moving(places=((1, (-2.0, 0.0, -1.0)), (40, (2.0, 0.0, -1.0))))
    result = result_of(described(goal, terrain))
    assert result.data.about.models == (model,)
    assert (result.data.columns["feature"] != 0.0).all()


def test_the_force_is_that_of_the_spring_up_to_the_largest(terrain: bpy.types.Object) -> None:
    bpy.context.scene.haptic_terrain.max_force = 3.0
    result = result_of(described(moving(), terrain))
    touching = result.data.in_contact
    pressed = np.minimum(500.0 * result.data.depth, 3.0)
    assert result.data.force[touching] == pytest.approx(pressed[touching], rel=1e-9)
    assert 0.0 < pressed[touching].min() < 3.0
    assert pressed.max() == 3.0


def test_a_goal_goes_on_over_the_seam(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    bpy.context.scene.frame_end = 20
    goal = moving(
        places=(
            (1, (4.0, 0.0, -1.0)),
            (10, (4.9, 0.0, -1.0)),
            (11, (-4.9, 0.0, -1.0)),
            (20, (-4.0, 0.0, -1.0)),
        )
    )
    for curve in curves_of(goal):
        for key in curve.keyframe_points:
            key.interpolation = "CONSTANT" if key.co.x == 10.0 else "LINEAR"
    columns = columns_of(goal, terrain)
    frame = frame_of(terrain)
    assert np.abs(np.diff(columns["goal_east"])).max() * frame.units_per_metre < 0.05
    assert columns["goal_east"][-1] > frame.turn
