"""Baking: an animated object is the goal, and its contact with a terrain becomes a take.

Computed in stepped time at the servo's rate, so that the same scene gives the same bits, however busy the
machine is.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import asdict, dataclass, replace
from typing import TypeVar

import bpy
import numpy as np
from proxygraph import Grid, SimulatedDevice, Window

from ..terrain.frame import TerrainFrame
from ..terrain.kept import KeptTerrain, recall
from ..terrain.opening import open_shown
from ..terrain.progress import Tell
from ..terrain.undone import undone_on_failure
from ..touch.handle import Handle
from ..touch.live import ModelChoice, live
from ..touch.model import chosen_model
from ..touch.tick import UNUSABLE
from ..touch.workspace import whole_map
from .animated import Animated, AnimationError, Frames, Path, check_frames, found, samples
from .bake_contact import Answer, felt
from .bake_goals import goals_at, tick_times, unwrapped
from .chosen_options import chosen_options
from .ground import Ground
from .stand import Stand
from .take_data import Numbers, TakeData
from .terrain_about import terrain_about
from .write_take import Take, write_take

Result = TypeVar("Result")

SAMPLES_PER_FRAME = 4
"""Of the scene: at 24 frames a second about 100 Hz, faster than a hand trembles."""

MOST_TICKS = 10_000_000
"""Nearly three hours; 2 GB of columns."""

SAMPLING = 0.7
"""Share of a bake that evaluating the scene takes, for showing progress."""


@dataclass(frozen=True)
class Bake:
    """What is to be baked."""

    scene: Handle[bpy.types.Scene]
    view_layer: str
    goal: Animated
    terrain: Handle[bpy.types.Object]
    frames: Frames
    model: ModelChoice


@dataclass(frozen=True)
class Baked:
    """What was felt, and where the terrain stood."""

    data: TakeData
    answer: Answer
    path: Path
    stand: Stand
    ground: Ground
    notes: tuple[str, ...]
    """What a person should know."""


def bake_of(context: bpy.types.Context, goal: Animated, terrain: bpy.types.Object, frames: Frames) -> Bake:
    """Describe a bake of the open scene with the contact model that is chosen there.

    Raises:
        AnimationError: it cannot be baked; nothing was done yet.
    """
    scene = context.scene
    if scene is None or context.view_layer is None:
        raise AnimationError("No scene is open.")
    check_frames(scene, frames)
    ticks = len(tick_times(frames.last - frames.first, frame_rate(scene)))
    if ticks > MOST_TICKS:
        raise AnimationError(
            f"{frames.first} to {frames.last} are {ticks:,} milliseconds, and {MOST_TICKS:,} can be baked "
            "at once: bake it in parts."
        )
    if goal.thing == Handle.to(terrain):
        raise AnimationError(
            f"{terrain.name} is the terrain itself: choose the object that is to move over it as the goal."
        )
    return Bake(
        Handle.to(scene), context.view_layer.name, goal, Handle.to(terrain), frames, chosen_model(scene)
    )


def baked(bake: Bake) -> Generator[float, None, Baked]:
    """Bake, telling the share that is done; close it to cancel. The scene's frame is restored in any case.

    Raises:
        AnimationError: the goal or the terrain cannot be followed through the frames.
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept, ground = opened_ground(bake)
    scene = found(bake.scene)
    rate, settings = frame_rate(scene), scene.haptic_terrain
    width, max_force = settings.window_width * 1000.0, settings.max_force

    path = yield from _shares(path_of(bake), 0.0, SAMPLING)
    stand = usable_stand(bake.terrain, kept.frame, path)
    places = terrain_places(stand, path)
    times = tick_times(bake.frames.last - bake.frames.first, rate)
    goals = goals_at(times, places, rate * bake.frames.per_frame)
    answer = Answer(
        ground.grid,
        kept.maximum,
        _window(ground.grid, goals, width, stand.exaggeration),
        SimulatedDevice().workspace[0],
        max_force=max_force,
        **asdict(bake.model),
    )
    columns = yield from _shares(felt(answer, times, goals), SAMPLING, 1.0)
    about = terrain_about(bake.terrain.name, kept)
    about = replace(about, workspace_width=answer.workspace_width, models=(answer.model,))
    data = TakeData(columns, about)
    return Baked(data, answer, path, stand, ground, _notes(bake, data, places))


def write_baked(bake: Bake, result: Baked, tell: Tell = lambda _share: None) -> Take:
    """Put the take into the scene as its settings say; what cannot be finished leaves nothing there.

    Raises:
        AnimationError: the scene is gone.
        ValueError: it cannot be appended to the take that is chosen for that.
    """
    scene = found(bake.scene)
    options = chosen_options(scene, bake.frames.first)
    with undone_on_failure():
        return write_take(scene, result.data, result.stand.placement, result.ground, options, tell)


def opened_ground(bake: Bake) -> tuple[KeptTerrain, Ground]:
    """Open the terrain's grid.

    Raises:
        AnimationError: the terrain is gone.
        FormatError: the grid's file cannot be used any more.
        KeptError: the terrain does not remember its grid.
    """
    kept = recall(found(bake.terrain))
    grid = open_shown(live.opened, kept)
    return kept, Ground.of(grid, kept)


def path_of(bake: Bake) -> Generator[float, None, Path]:
    """Follow the goal through the frames; see ``samples``."""
    return samples(bake.scene, bake.view_layer, bake.goal, bake.terrain, bake.frames)


def frame_rate(scene: bpy.types.Scene) -> float:
    """Frames a second; 24 / 1.001 for film on video."""
    return scene.render.fps / scene.render.fps_base


def usable_stand(terrain: Handle[bpy.types.Object], frame: TerrainFrame, path: Path) -> Stand:
    """Where the terrain stands.

    Raises:
        AnimationError: it is flattened, or its place is no number.
    """
    stand = Stand(frame, path.terrain)
    if not stand.placement.is_usable:
        raise AnimationError(f"{terrain.name}: {UNUSABLE}")
    return stand


def terrain_places(stand: Stand, path: Path) -> Numbers:
    """Terrain metres at each sample, n x 3; east runs on around the planet."""
    places = np.array([stand.to_terrain(sample.place) for sample in path.moving])
    places[:, 0] = unwrapped(places[:, 0], stand.frame.turn)
    return places


def _shares(part: Generator[float, None, Result], begin: float, end: float) -> Generator[float, None, Result]:
    """Tell the shares of a part as shares of the whole."""
    try:
        while True:
            yield begin + (end - begin) * next(part)
    except StopIteration as done:
        result: Result = done.value
        return result
    finally:
        part.close()


def _window(grid: Grid, goals: Numbers, width: float, exaggeration: float) -> Window:
    """Lay a hand's workspace over the whole map, or as wide as the person wants it around the path."""
    east, north, whole = whole_map(grid.layout, SimulatedDevice().workspace)
    if width > 0.0:
        east, north = (float(goals[:, axis].min() + goals[:, axis].max()) / 2.0 for axis in (0, 1))
    ground = grid.elevation_at(east, north)
    return Window(
        east, north, 0.0 if ground is None else ground, width=width or whole, exaggeration=exaggeration
    )


def _notes(bake: Bake, data: TakeData, places: Numbers) -> tuple[str, ...]:
    """Say what is odd, and may be meant."""
    notes = []
    if (places == places[0]).all():
        notes.append(
            f"{bake.goal.name} does not move from frame {bake.frames.first} to {bake.frames.last}: the take "
            "stands still. Has it animation in these frames?"
        )
    if not data.in_contact.any():
        notes.append(f"{bake.goal.name} never touches {bake.terrain.name}: lower it to be felt.")
    return tuple(notes)
