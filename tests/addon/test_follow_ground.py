"""Objects that stay on the terrain along their own animated path."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import bpy
import pytest
from mathutils import Matrix, Vector

from tests.addon.scene import contents, import_grid, module
from tests.addon.test_bake import moving
from tests.formats.megdr_pair import MegdrPair, planet, rough

PLACES = ((1, (-3.0, -1.0, 9.0)), (20, (0.5, 1.0, -9.0)), (40, (3.0, -1.5, 0.0)))


@pytest.fixture
def terrain(tmp_path: Path) -> bpy.types.Object:
    bpy.context.scene.frame_end = 40
    return import_grid(MegdrPair(rough(40, 60)).write(tmp_path), vertex_budget=150)


def follow(**options: Any) -> None:
    assert bpy.ops.haptic_terrain.follow_ground(**options) == {"FINISHED"}


def seen(thing: bpy.types.Object, frame: int) -> Matrix:
    """Where Blender puts an object."""
    bpy.context.scene.frame_set(frame)
    return thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world.copy()


def heights(terrain: bpy.types.Object, place: Vector) -> tuple[float, float]:
    """Scene heights of the real ground, and of the ground that is shown, under a place."""
    kept = module("terrain.kept").recall(terrain)
    preview = module("terrain.preview")
    grid = kept.grid.open()
    shown = preview.preview_surface(grid, preview.preview_cells(grid.layout, kept.vertex_budget))
    local = terrain.matrix_world.inverted() @ place
    east, north, _up = kept.frame.to_terrain(*local[:])
    found = []
    for up in (grid.elevation_at(east, north), shown.height_at(east, north)):
        assert up is not None
        found.append((terrain.matrix_world @ Vector(kept.frame.to_object(east, north, up))).z)
    return found[0], found[1]


@pytest.mark.parametrize("ground", ["HIGHEST", "REAL", "SHOWN"])
def test_an_object_stands_on_the_ground_in_every_frame(terrain: bpy.types.Object, ground: str) -> None:
    goal = moving(places=PLACES)
    path = [seen(goal, frame).translation for frame in range(1, 41)]
    follow(ground=ground, offset=0.25, oriented=False)
    differ = 0
    for frame, own in zip(range(1, 41), path, strict=True):
        place = seen(goal, frame).translation
        assert place.xy[:] == pytest.approx(own.xy[:], abs=1e-5)
        real, shown = heights(terrain, place)
        wanted = {"HIGHEST": max(real, shown), "REAL": real, "SHOWN": shown}[ground]
        assert place.z == pytest.approx(wanted + 0.25, abs=1e-4)
        differ += abs(real - shown) > 1e-3
    assert differ > 20, "the preview is coarser than the grid here"


def test_an_object_is_tilted_as_the_ground_is(tmp_path: Path) -> None:
    slope = [[100 * column for column in range(60)] for _row in range(40)]
    terrain = import_grid(MegdrPair(slope).write(tmp_path))
    bpy.context.scene.frame_end = 10
    goal = moving(places=((1, (-1.0, 0.0, 0.0)), (10, (1.0, 0.0, 0.0))))
    goal.rotation_euler.z = 0.7
    follow(footprint=(0.2, 0.4))
    bounds = [Vector(corner) for corner in terrain.bound_box]
    rise = (max(b.z for b in bounds) - min(b.z for b in bounds)) / (
        max(b.x for b in bounds) - min(b.x for b in bounds)
    )
    normal = Vector((-rise, 0.0, 1.0)).normalized()
    matrix = seen(goal, 5)
    assert (matrix.to_3x3() @ Vector((0, 0, 1))).angle(normal) < 1e-3
    upright = normal.rotation_difference(Vector((0, 0, 1))).to_matrix() @ matrix.to_3x3()
    assert upright.to_euler().z == pytest.approx(0.7, abs=1e-3)


@pytest.mark.parametrize("oriented", [True, False])
def test_no_point_of_the_footprint_is_buried(terrain: bpy.types.Object, oriented: bool) -> None:
    goal = moving(places=PLACES)
    follow(footprint=(0.6, 0.8), oriented=oriented, heading="PATH")
    for frame in range(1, 41, 3):
        matrix = seen(goal, frame)
        lowest = math.inf
        for x in (-0.3, 0.0, 0.3):
            for y in (-0.4, 0.0, 0.4):
                point = matrix @ Vector((x, y, 0.0))
                lowest = min(lowest, point.z - max(heights(terrain, point)))
        assert lowest == pytest.approx(0.0, abs=1e-4)


def test_an_object_looks_where_it_goes(terrain: bpy.types.Object) -> None:
    goal = moving(places=PLACES)
    before, after = seen(goal, 11).translation, seen(goal, 13).translation
    follow(heading="PATH", oriented=False)
    ahead = seen(goal, 12).to_3x3() @ Vector((0.0, 1.0, 0.0))
    assert ahead.xy.angle((after - before).xy) < 1e-3
    assert ahead.z == pytest.approx(0.0, abs=1e-6)


def test_parents_drivers_and_constraints_give_the_path(terrain: bpy.types.Object) -> None:
    leader = moving("Leader", places=PLACES)
    mother = bpy.data.objects.new("Mother", None)
    goal = bpy.data.objects.new("Led", None)
    for thing in (mother, goal):
        bpy.context.scene.collection.objects.link(thing)
    goal.parent = mother
    mother.driver_add("location", 1).driver.expression = "0.02 * frame"
    mother.rotation_euler.z = 0.3
    mother.scale = (2.0, 2.0, 2.0)
    copied = goal.constraints.new("COPY_LOCATION")
    copied.target, copied.use_offset = leader, True
    bpy.context.view_layer.objects.active = goal
    path = [seen(goal, frame).translation for frame in range(1, 41)]
    follow(oriented=False)
    for frame, own in zip(range(1, 41), path, strict=True):
        place = seen(goal, frame).translation
        assert place.xy[:] == pytest.approx(own.xy[:], abs=1e-5)
        assert place.z == pytest.approx(max(heights(terrain, place)), abs=1e-4)
    assert (goal.parent, len(goal.animation_data_create().drivers)) == (mother, 0)


def test_once_more_takes_the_place_of_the_first(terrain: bpy.types.Object) -> None:
    goal = moving(places=PLACES)
    follow(offset=1.0)
    high, made = seen(goal, 20).translation.z, contents()
    follow(offset=0.0)
    assert contents() == made
    assert high - seen(goal, 20).translation.z == pytest.approx(1.0, abs=0.2)


def test_an_object_can_leave_the_ground(terrain: bpy.types.Object) -> None:
    goal = moving(places=PLACES)
    own, before = seen(goal, 30), contents()
    follow()
    assert seen(goal, 30) != own
    assert bpy.ops.haptic_terrain.leave_ground() == {"FINISHED"}
    assert (seen(goal, 30), contents()) == (own, before)
    assert bpy.ops.haptic_terrain.leave_ground() == {"CANCELLED"}


def test_over_contact_an_object_follows_the_proxy(terrain: bpy.types.Object) -> None:
    goal = moving(places=((1, (-2.0, 0.0, -1.5)), (40, (2.0, 1.0, -1.5))))
    assert bpy.ops.haptic_terrain.bake() == {"FINISHED"}
    take = next(thing for thing in bpy.data.objects if thing.name.startswith("Touch Take"))
    bpy.context.view_layer.objects.active = goal
    follow(path="PROXY", oriented=False)
    for frame in range(1, 41):
        assert (seen(goal, frame).translation - seen(take, frame).translation).length < 1e-3


def test_beside_the_map_an_object_stays_as_it_is(terrain: bpy.types.Object) -> None:
    goal = moving(places=((1, (0.0, 0.0, 3.0)), (40, (20.0, 0.0, 3.0))))
    own = seen(goal, 40)
    follow()
    assert seen(goal, 40).translation[:] == pytest.approx(own.translation[:], abs=1e-5)
    assert seen(goal, 1).translation.z < 2.0


def test_on_a_curved_planet_up_is_away_from_its_middle(tmp_path: Path) -> None:
    terrain = import_grid(planet().write(tmp_path))
    assert bpy.ops.haptic_terrain.show_curvature(curved=True) == {"FINISHED"}
    bpy.context.scene.frame_end = 12
    kept = module("terrain.kept").recall(terrain)
    frame, grid = kept.frame, kept.grid.open()
    radius = frame.bend.radius * frame.units_per_metre
    goal = moving(places=((1, (0.3 * radius, 0.0, 0.2)), (12, (0.6 * radius, 0.2 * radius, -0.1))))
    own = [frame.to_terrain(*seen(goal, number).translation[:]) for number in range(1, 13)]
    follow(ground="REAL", offset=0.1 * radius, oriented=False, heading="PATH")
    for number, (east, north, _up) in enumerate(own, start=1):
        place = seen(goal, number)
        ground = grid.elevation_at(frame.on_map(east), north)
        assert ground is not None
        foot = Vector(frame.to_object(east, north, ground))
        assert (place.translation - foot).length == pytest.approx(0.1 * radius, rel=1e-4)
        middle = Vector((0.0, 0.0, -radius))
        assert (place.to_3x3() @ Vector((0.0, 0.0, 1.0))).angle(foot - middle) < 1e-3


def test_a_render_shows_the_object_on_the_ground(terrain: bpy.types.Object, tmp_path: Path) -> None:
    goal = moving(places=PLACES)
    follow(oriented=False)
    scene = bpy.context.scene
    rendered = []

    def look(_scene: Any, graph: Any = None) -> None:
        rendered.append((scene.frame_current, goal.evaluated_get(graph).matrix_world.translation.copy()))

    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.render.resolution_x = scene.render.resolution_y = 16
    scene.render.filepath = str(tmp_path / "frame")
    scene.frame_start, scene.frame_end = 19, 21
    bpy.app.handlers.frame_change_post.append(look)
    try:
        bpy.ops.render.render(animation=True)
    finally:
        bpy.app.handlers.frame_change_post.remove(look)
    assert {frame for frame, _place in rendered} >= {19, 20, 21}
    for _frame, place in rendered:
        assert place.z == pytest.approx(max(heights(terrain, place)), abs=1e-4)


def test_a_cancelled_search_leaves_the_object_as_it_was(terrain: bpy.types.Object) -> None:
    goal = moving(places=PLACES)
    follow()
    before, there = contents(), seen(goal, 20)
    part, frames = module("record.follow_ground"), module("record.animated").Frames(1, 40)
    animated = module("record.animated").Animated(module("touch.handle").Handle.to(goal))
    bake = module("record.bake").bake_of(bpy.context, animated, terrain, frames)
    work = part.followed(bake, module("record.standing").Follow(offset=5.0))
    next(work)
    assert all(tie.mute for tie in goal.constraints)
    work.close()
    assert (contents(), seen(goal, 20)) == (before, there)


def test_an_object_that_is_deleted_meanwhile_ends_the_search(terrain: bpy.types.Object) -> None:
    goal = moving(places=PLACES)
    follow()
    part, animated = module("record.follow_ground"), module("record.animated")
    goal_of = animated.Animated(module("touch.handle").Handle.to(goal))
    bake = module("record.bake").bake_of(bpy.context, goal_of, terrain, animated.Frames(1, 40))
    work = part.followed(bake, module("record.standing").Follow())
    next(work)
    bpy.data.objects.remove(goal)
    with pytest.raises(animated.AnimationError, match="Goal is gone"):
        next(work)


def test_a_bone_is_told(terrain: bpy.types.Object) -> None:
    goal = moving(places=PLACES)
    part, animated = module("record.follow_ground"), module("record.animated")
    bone = animated.Animated(module("touch.handle").Handle.to(goal), bone="Arm")
    bake = module("record.bake").bake_of(bpy.context, bone, terrain, animated.Frames(1, 40))
    with pytest.raises(animated.AnimationError, match="bone cannot be kept on the ground"):
        next(part.followed(bake, module("record.standing").Follow()))
