"""The pointer's ray, and where it puts the hand: no scene and no window are needed."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from mathutils import Euler, Matrix, Vector
from proxygraph import Window

from tests.addon.scene import module

WORKSPACE = (0.16, 0.12, 0.12)
SIZE = (800.0, 600.0)

PLACES = {
    "where it was": Matrix.Identity(4),
    "moved, turned and scaled": Matrix.LocRotScale(
        (3.0, -2.0, 1.0), Euler((0.2, -0.1, 0.8)), (2.0, 2.0, 2.0)
    ),
    "mirrored": Matrix.LocRotScale(None, None, (-1.0, 1.0, 1.0)),
    "stretched": Matrix.LocRotScale(None, Euler((0.0, 0.0, 0.4)), (1.0, 1.0, 3.0)),
    "sheared": Matrix.Shear("XY", 4, (0.3, 0.1)),
}

PERSPECTIVE = ((2.4, 0.0, 0.0, 0.0), (0.0, 3.2, 0.0, 0.0), (0.0, 0.0, -1.0, -0.02), (0.0, 0.0, -1.0, 0.0))
SHIFTED = ((2.4, 0.0, 0.3, 0.0), (0.0, 3.2, -0.2, 0.0), (0.0, 0.0, -1.0, -0.02), (0.0, 0.0, -1.0, 0.0))
ORTHOGRAPHIC = ((0.15, 0.0, 0.0, 0.05), (0.0, 0.2, 0.0, -0.1), (0.0, 0.0, -0.01, 0.0), (0.0, 0.0, 0.0, 1.0))
PROJECTIONS = {"perspective": PERSPECTIVE, "shifted camera": SHIFTED, "orthographic": ORTHOGRAPHIC}

FROM_ABOVE = Vector((1.0, -4.0, 12.0))
FROM_THE_SOUTH = Vector((0.0, -12.0, 0.3))


def frame(*, turn: float | None = None, bend: Any = None) -> Any:
    """Ten units for a thousand kilometres, heights x10."""
    return module("terrain.frame").TerrainFrame(
        east=5e5, north=-4e5, up=0.0, units_per_metre=1e-5, exaggeration=10.0, turn=turn, bend=bend
    )


def window(*, width: float = 4e5, turn: float = 0.3, east: float = 5.2e5) -> Window:
    return Window(east, -3.8e5, 500.0, width=width, exaggeration=10.0, turn=turn)


def looking(eye: Vector, at: Vector) -> Matrix:
    """A view from the eye to a place, the scene's z up."""
    turn = (at - eye).to_track_quat("-Z", "Y")
    return Matrix.LocRotScale(eye[:], turn, None).inverted()


def map_of(
    eye: Vector,
    projection: Any = PERSPECTIVE,
    world: Matrix | None = None,
    laid: Window | None = None,
    shown: Any = None,
) -> Any:
    """A view from an eye that is told in the terrain's own coordinates, on the middle of the window."""
    world, laid, shown = world or Matrix.Identity(4), laid or window(), shown or frame()
    middle = Vector(shown.to_object(laid.east, laid.north, laid.up))
    view = looking(world @ (middle + eye), world @ middle)
    seen = module("touch.pointer_view").PointerView.of(view, projection, world, SIZE)
    return module("touch.pointer_map").PointerMap(seen, shown, laid, WORKSPACE)


def pixel(seen: Any, hand: Any) -> tuple[float, float]:
    """Where a hand is seen, by the straight way: through all matrices."""
    place = np.append(seen._shown(hand), 1.0)
    clip = seen.view.projection @ seen.view.to_camera @ place
    x, y = clip[:2] / clip[3]
    return (x + 1.0) / 2.0 * SIZE[0], (y + 1.0) / 2.0 * SIZE[1]


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("projection", PROJECTIONS)
@pytest.mark.parametrize("turn", [0.0, 0.9, -2.5])
def test_seen_from_above_the_hand_is_under_the_pointer_at_its_own_height(
    place: str, projection: str, turn: float
) -> None:
    seen = map_of(FROM_ABOVE, PROJECTIONS[projection], PLACES[place], window(turn=turn))
    for x, y, z in itertools.product((-0.07, 0.0, 0.05), (-0.05, 0.02), (-0.01, 0.02)):
        found = seen.under(pixel(seen, (x, y, z)), (0.01, -0.02, z))
        assert found == pytest.approx((x, y, z), abs=2e-6)


@pytest.mark.parametrize("place", ["where it was", "mirrored", "stretched"])
@pytest.mark.parametrize("projection", PROJECTIONS)
def test_seen_along_the_ground_up_on_the_screen_is_up(place: str, projection: str) -> None:
    seen = map_of(FROM_THE_SOUTH, PROJECTIONS[projection], PLACES[place], window(turn=0.0))
    hand = (0.01, -0.02, 0.005)
    for x, z in itertools.product((-0.05, 0.03), (-0.01, 0.03)):
        found = seen.under(pixel(seen, (x, -0.02, z)), hand)
        assert found == pytest.approx((x, -0.02, z), abs=2e-6)


def test_seen_along_the_ground_the_wheel_goes_away_and_from_above_it_goes_up() -> None:
    hand = (0.01, -0.02, 0.005)
    assert map_of(FROM_ABOVE).outward(hand) == (0.0, 0.0, 1.0)
    assert map_of(FROM_THE_SOUTH, laid=window(turn=0.0)).outward(hand) == pytest.approx(
        (0.0, 1.0, 0.0), abs=1e-6
    )
    turned = map_of(FROM_THE_SOUTH, laid=window(turn=0.5)).outward(hand)
    assert turned == pytest.approx((math.sin(0.5), math.cos(0.5), 0.0), abs=1e-6)


def test_a_pointer_in_the_sky_puts_the_hand_nowhere() -> None:
    seen = map_of(Vector((0.0, -12.0, 6.0)))
    assert seen.under((400.0, 6000.0), (0.0, 0.0, 0.0)) is None
    assert seen.under((400.0, 300.0), (0.0, 0.0, 0.0)) is not None


@pytest.mark.parametrize("eye", [FROM_ABOVE, FROM_THE_SOUTH])
def test_the_hand_stays_within_reach_wherever_the_pointer_is(eye: Vector) -> None:
    seen = map_of(eye)
    for pointer in itertools.product((-5e4, 0.0, 5e4), (-5e4, 0.0, 280.0, 5e4)):
        found = seen.under(pointer, (0.0, 0.0, 0.0))
        assert found is None or (abs(found[0]) <= 0.08 and abs(found[1]) <= 0.06)


@pytest.mark.parametrize("projection", PROJECTIONS)
@pytest.mark.parametrize("place", ["where it was", "moved, turned and scaled"])
def test_a_pixel_is_as_wide_as_the_hands_way_on_the_screen(projection: str, place: str) -> None:
    seen = map_of(Vector((0.0, -0.001, 9.0)), PROJECTIONS[projection], PLACES[place], window(turn=0.0))
    apart = math.dist(pixel(seen, (0.0, 0.0, 0.0)), pixel(seen, (0.01, 0.0, 0.0)))
    assert seen.metres_per_pixel((0.0, 0.0, 0.0)) == pytest.approx(0.01 / apart, rel=1e-3)


def test_a_narrow_window_of_a_whole_planet_is_still_met_to_a_pixel() -> None:
    narrow = window(width=40.0)
    seen = map_of(Vector((0.0, -2e-4, 6e-4)), laid=narrow)
    wide = seen.metres_per_pixel((0.0, 0.0, 0.0))
    found = seen.under(pixel(seen, (0.03, 0.02, 0.001)), (0.0, 0.0, 0.001))
    assert found == pytest.approx((0.03, 0.02, 0.001), abs=2.0 * wide)


def test_beyond_the_seam_the_hand_goes_straight_on() -> None:
    around = frame(turn=1e6)
    seen = map_of(FROM_ABOVE, laid=window(east=2e4, turn=0.0), shown=around)
    left = (-0.06, 0.01, 0.0)
    found = seen.under(pixel(seen, left), (0.0, 0.0, 0.0))
    assert found == pytest.approx(left, abs=2e-6), "west of the map's western edge"
    shown = around.to_object(2e4 - 0.06 / 0.16 * 4e5, -3.8e5 + 0.01 / 0.16 * 4e5, 500.0)
    clip = seen.view.projection @ seen.view.to_camera @ np.array((*shown, 1.0))
    other = tuple((clip[axis] / clip[3] + 1.0) / 2.0 * SIZE[axis] for axis in (0, 1))
    assert seen.under(other, (0.0, 0.0, 0.0)) == pytest.approx(left, abs=2e-6), "where its ground is shown"


def test_windows_that_ran_around_the_planet_mean_the_same() -> None:
    around = frame(turn=1e6)
    once = map_of(FROM_ABOVE, laid=window(), shown=around)
    twice = map_of(FROM_ABOVE, laid=window(east=2.52e6), shown=around)
    pointer = (500.0, 200.0)
    assert twice.under(pointer, (0.0, 0.0, 0.0)) == pytest.approx(
        once.under(pointer, (0.0, 0.0, 0.0)), abs=2e-6
    )


@pytest.mark.parametrize("latitude", [None, 20.0])
@pytest.mark.parametrize("projection", PROJECTIONS)
def test_on_a_globe_the_hand_is_under_the_pointer(latitude: float | None, projection: str) -> None:
    radius = 4e5
    bend = module("terrain.bend").Bend(
        radius=radius, latitude=latitude, parallel=None if latitude is None else 0.9 * radius
    )
    seen = map_of(FROM_ABOVE, PROJECTIONS[projection], shown=frame(bend=bend))
    for x, y, z in itertools.product((-0.03, 0.05), (-0.03, 0.02), (0.0, 0.01)):
        found = seen.under(pixel(seen, (x, y, z)), (0.0, 0.0, z))
        assert found == pytest.approx((x, y, z), abs=2e-6)


def test_beside_a_globe_the_pointer_puts_the_hand_nowhere() -> None:
    bend = module("terrain.bend").Bend(radius=4e5)
    seen = map_of(FROM_ABOVE, ORTHOGRAPHIC, shown=frame(bend=bend))
    assert seen.under((0.0, 300.0), (0.0, 0.0, 0.0)) is None
