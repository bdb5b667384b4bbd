"""What outlives a call: the session that runs now, the take that is being recorded, grids that stay open."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import bpy
from proxygraph import Grid, Session, Window

from ..formats import Georeference
from ..terrain.frame import Point, TerrainFrame
from ..terrain.kept import KeptTerrain
from ..terrain.opened import OpenedGrids
from ..terrain.preview import PreviewSurface
from .detail import Detail
from .handle import Handle
from .mouse_hand import MouseHand
from .placement import Placement
from .recorder import Recorder
from .shown import Look, Shown


@dataclass(frozen=True)
class Readout:
    """What the panel shows of the newest tick."""

    mode: str
    """One of ``normal``, ``pan`` and ``zoom``."""
    window: Window
    """Where the workspace lies."""
    in_contact: bool
    proxy: Point
    """Terrain metres; of the cursor."""
    coordinates: tuple[float, float] | None
    """Degrees east and north; ``None`` where the grid's projection is not known."""
    own: tuple[float, float]
    """In the map's own coordinates, degrees or metres east and north."""
    on_map: bool
    """Whether the cursor is over the map; beside it there is no longitude or latitude to speak of."""
    elevation: float | None
    """Of the ground at the cursor, metres; ``None`` where there is no data, and beside the map."""
    force: float
    """Newtons."""
    ticks: int
    missed_ticks: int
    active_ticks: int
    """In which the spring had given the hand more energy than it took."""
    load: float
    """Share of each millisecond that the servo takes, mean."""
    worst_load: float
    """The same, exceeded in one tick of a thousand."""
    late_us: float
    """Microseconds that the servo woke up late, exceeded in one tick of a hundred."""
    priority: str
    """How the system schedules the servo, in words."""
    held: str | None
    """Why the force is away, or not yet wholly back, as ``State.held`` has it."""
    warnings: tuple[str, ...]
    """What the safety chain did since touch began, in words."""


@dataclass(frozen=True)
class ModelChoice:
    """A contact model and its knobs, as ``Session`` takes them."""

    model: str
    sub_step: float | None
    """Cells; of the surface walk."""
    radius: float | None
    """Workspace metres; of the virtual proxy."""


@dataclass(frozen=True)
class Clip:
    """How near a 3D view shows things, Blender units."""

    own: float
    """As a person chose it."""
    ours: float
    """As it was set, so that the cursor is not cut off."""


@dataclass
class Touch:
    """A hand on a terrain."""

    session: Session
    model: ModelChoice
    grid: Grid
    kept: KeptTerrain
    """What the terrain remembered when touch began."""
    georeference: Georeference
    frame: TerrainFrame
    surface: PreviewSurface
    scene: Handle[bpy.types.Scene]
    """Where touch was started: the cursor belongs there, whatever scene is looked at."""
    terrain: Handle[bpy.types.Object]
    target: Handle[bpy.types.Object] | None
    """The Empty; ``None`` where the device needs none."""
    workspace: tuple[float, float, float]
    """Of the device: width, depth and height, metres."""
    target_window: Window
    """In which the Empty's place is where the hand is to be; while the window moves, it stays."""
    view_window: Window
    """Which the views have followed so far."""
    has_modes: bool
    """Whether the stylus button changes the mode, and walls keep the hand in the workspace."""
    is_simulated: bool
    """Whether the hand and its handle are simulated."""
    is_pressed: bool = False
    """Whether a key or a button of the panel holds the stylus button down."""
    view_scale: float = 1.0
    """How much nearer the views came since touch began, below 1; the cursor looks as large as ever."""
    twist: float = 0.0
    """Of the simulated handle, radians counter-clockwise."""
    passivity_control: bool = False
    """What the session was told last."""
    pre_roll: float = 0.0
    """The same, seconds."""
    mouse: MouseHand | None = None
    """What the mouse wants of the simulated hand while it moves it, in the Empty's stead."""
    clips: dict[int, Clip] = field(default_factory=dict)
    """Of 3D views that were brought nearer, by their pointer."""
    shortcomings: tuple[str, ...] = ()
    """What of the terrain's place in the scene cannot be followed, in words."""
    readout: Readout | None = None
    shown: Shown | None = None
    """What the newest tick looks like in the scene; it stays while a picture is rendered."""
    look: Look | None = None
    """What was drawn last."""
    looked: float = 0.0
    """When, in seconds of the monotonic clock."""
    detail: Detail | None = None
    """What the views show in the place of the terrain's mesh; ``None`` where nobody looks."""


@dataclass(frozen=True)
class Played:
    """How a scene was played before a take began."""

    sync_mode: Literal["NONE", "FRAME_DROP", "AUDIO_SYNC"]
    frame_end: int
    uses_preview_range: bool


@dataclass
class Recording:
    """A take in the making; it outlives the session, so that a fault does not lose it."""

    touch: Touch
    recorder: Recorder
    placement: Placement
    """Of the terrain when the take began, for when it is gone at the end."""
    start_frame: int
    models: list[str] = field(default_factory=list)
    """Contact models that answered, in their order."""
    played: Played | None = None
    """What to put back when the take ends; ``None`` where the timeline does not play along."""
    not_spooled: str = ""
    """Why the take is in memory only from the beginning; empty where it is not."""


@dataclass
class Live:
    """The holder."""

    touch: Touch | None = None
    recording: Recording | None = None
    message: str = ""
    """Why touch ended by itself, or does not do what was chosen; empty where all is well."""
    rendering: bool = False
    """Nothing is written to the scene while it is rendered."""
    spool_folder: Path | None = None
    """Where takes are until they are written to the scene; ``None`` while the extension is off."""
    watchers: list[Callable[[], None]] = field(default_factory=list)
    """Called after touch has begun or ended."""
    opened: OpenedGrids = field(default_factory=OpenedGrids)
    """What was decoded for an import, so that touch need not do it again; until another file is loaded."""

    def change(self, touch: Touch | None) -> None:
        """Let a touch begin or end."""
        self.touch = touch
        for watcher in self.watchers:
            watcher()


live = Live()

RENDERING = "A picture is being rendered: wait for its end"
"""Why nothing can be added to the scene."""
