"""What a take becomes in the scene: one way for live recordings, files, playback and baking."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import bpy
import numpy as np

from ..terrain.progress import Tell
from ..touch.placement import Placement
from .ground import Ground
from .kept_take import keep_take, recall_start_frame, recall_take, take_action
from .keys import take_keys
from .markers import mark_modes
from .merge import merged
from .nla import push_down
from .scene_view import SceneView
from .take import COLLECTION, home, key_take, new_take
from .take_data import TakeData
from .take_options import TakeOptions
from .trail_curve import curve_trail
from .trail_path import contact_trails
from .trail_points import point_trail
from .trail_tube import trail_radius, tube_trail

TRAIL = "haptic_terrain_trail"
"""ID property of a take's trails: which kind it is."""


@dataclass(frozen=True)
class Take:
    """What a take left in the scene."""

    take: bpy.types.Object
    trails: dict[str, bpy.types.Object]
    """By kind; none where nothing was touched."""
    keyframes: int
    """On each of its location curves."""
    seconds: float
    dropped: int
    """Ticks that were lost because Blender was busy for longer than the ring lasts."""
    cut_seconds: float
    """At the end, that lie beyond Blender's last frame and have no keys."""
    left_out: tuple[str, ...]
    """Columns that only one of two takes had that were put together."""

    @property
    def trail(self) -> bpy.types.Object | None:
        """The tube."""
        return self.trails.get("TUBE")


def write_take(
    scene: bpy.types.Scene,
    data: TakeData,
    placement: Placement,
    ground: Ground,
    options: TakeOptions,
    tell: Tell = lambda _share: None,
) -> Take:
    """Make the take's object, its action and its trails; the caller takes care of undo.

    Args:
        placement: of the terrain that was touched.
        ground: of the same terrain; what is written never lies below it.

    Raises:
        ValueError: there is no tick.
        KeptTakeError: ticks are to be appended to a take that has none any more.
        OtherTerrainError: ticks are to be appended to a take of another terrain.
    """
    if not len(data):
        raise ValueError("The take is empty: nothing was written.")
    rate = scene.render.fps / scene.render.fps_base
    start_frame = options.start_frame
    older = take_action(options.onto)
    appended = older is not None and options.append
    left_out: tuple[str, ...] = ()
    if older is not None and appended:
        old, old_start = recall_take(older), recall_start_frame(older)
        left_out = tuple(sorted(old.columns.keys() ^ data.columns.keys()))
        data = merged(old, data, (start_frame - old_start) / rate)
        start_frame = min(start_frame, old_start)
    keys = take_keys(
        data,
        SceneView(placement.frame, np.array(placement.matrix)),
        ground.highest,
        start_frame=start_frame,
        frames_per_second=rate,
        bound=options.bound_mm / 1000.0 if options.reduced else None,
        tell=lambda share: tell(0.5 * share),
    )
    tell(0.5)
    # All that may fail is made before anything that was there is changed.
    trails = dict(_trails(data, placement, ground, options))
    tell(0.8)
    onto = options.onto if older is not None else None
    take = onto or new_take(scene, placement, placement.longest_side(ground.grid.layout))
    action = key_take(take, keys, data.about.models)
    # What is appended to keeps its ticks: the older ones are nowhere else.
    keep_take(action, data, start_frame, ticks=options.keep_ticks or appended)
    # So that the take plays to its end; a longer range that was chosen stays.
    scene.frame_end = max(scene.frame_end, keys.last_frame)
    if options.markers:
        mark_modes(scene, take, keys.mode)
    if options.nla:
        push_down(take, action)
    _place_trails(home(take, scene), take, trails, placement)
    return Take(
        take,
        trails,
        len(keys.location),
        data.seconds,
        data.about.lost_ticks,
        keys.cut_seconds,
        left_out,
    )


def _place_trails(
    collection: bpy.types.Collection,
    take: bpy.types.Object,
    trails: dict[str, bpy.types.Object],
    placement: Placement,
) -> None:
    """Put the trails beside their take, in place of those that it had."""
    if collection.get(COLLECTION):
        for old in [thing for thing in collection.objects if thing.get(TRAIL)]:
            bpy.data.objects.remove(old)
    for kind, trail in trails.items():
        trail[TRAIL] = kind
        if not trail.data.materials and isinstance(take.data, bpy.types.Mesh):
            for colour in take.data.materials:
                trail.data.materials.append(colour)
        trail.matrix_world = placement.matrix
        collection.objects.link(trail)


def _trails(
    data: TakeData, placement: Placement, ground: Ground, options: TakeOptions
) -> Iterator[tuple[str, bpy.types.Object]]:
    frame, layout = placement.frame, ground.grid.layout
    if options.trails & {"TUBE", "CURVE"}:
        trails = contact_trails(data, frame, ground.highest, spacing=trail_radius(layout))
        if trails and "TUBE" in options.trails:
            yield "TUBE", tube_trail(trails, frame, layout)
        if trails and "CURVE" in options.trails:
            yield "CURVE", curve_trail(trails, frame, layout)
    if "POINTS" in options.trails:
        yield "POINTS", point_trail(data, frame, ground)
