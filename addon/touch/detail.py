"""The terrain as it is seen while it is touched: finely around the hand, coarsely far away.

What is shown is prepared in a thread, and only copied into the mesh by Blender's main thread.
"""

from __future__ import annotations

import time
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field

import bpy
from proxygraph import Grid

from ..formats import FormatError
from ..terrain.frame import TerrainFrame, place_in_grid
from ..terrain.kept import KeptTerrain
from ..terrain.levels.level import Extent
from ..terrain.levels.mesh_arrays import mesh_arrays
from ..terrain.levels.nested_surface import NestedSurface
from ..terrain.levels.plan import Focus, Plan, plan_levels
from ..terrain.levels.samples import SampleReader
from ..terrain.levels.standing import Filling, Room, filling
from ..terrain.levels.steering import Steering
from ..terrain.levels_mesh import refresh
from ..terrain.levels_object import (
    MARK,
    mesh_for_levels,
    put_away_levels,
    show_levels,
    shown_levels,
    wear_materials,
)
from ..terrain.mesh import ELEVATION, FILLED, SLOPE
from ..terrain.preview import VERTEX_BUDGET
from .placement import Placement

FINEST_PIXELS = 2.0
"""A cell of the finest level is that wide on the screen at most, or one of the grid's own."""


@dataclass(frozen=True)
class _Wanted:
    """What is to be shown."""

    plan: Plan
    frame: TerrainFrame
    room: Room


@dataclass(frozen=True)
class _Prepared:
    """What is ready to be shown."""

    wanted: _Wanted
    filling: Filling
    surface: NestedSurface


@dataclass
class Detail:
    """The levels of one touch: ``follow`` is called between two drawings of the screen."""

    grid: Grid
    kept: KeptTerrain
    steering: Steering = field(init=False)
    surface: NestedSurface | None = None
    """As it is shown now; ``None`` while the terrain's own mesh is."""
    _extent: Extent = field(init=False)
    _pool: ThreadPoolExecutor = field(init=False)
    _reader: SampleReader | None = None
    _work: Future[_Prepared] | None = None
    _shown: _Prepared | None = None
    _stamp: int = field(default_factory=lambda: time.monotonic_ns() % 1_000_000_000)
    """Of the newest refresh; the mesh has it too, unless an undo brought an older one back."""
    _last_frame: float | None = None

    def __post_init__(self) -> None:
        # A person may let the terrain's own mesh have more: it is not refreshed all the time.
        self.steering = Steering(min(self.kept.vertex_budget, VERTEX_BUDGET))
        self._extent = Extent.of(self.grid.layout)
        self._pool = ThreadPoolExecutor(1, thread_name_prefix="terrain levels")

    def follow(
        self,
        terrain: bpy.types.Object,
        placement: Placement,
        east: float,
        north: float,
        pixels_per_unit: float | None,
    ) -> None:
        """Show what was prepared, and prepare what is to be shown next.

        Args:
            east, north: where it is to be fine, terrain metres.
            pixels_per_unit: of the screen there, by Blender units; ``None`` where nobody sees it.

        Raises:
            MemoryError: there is too little of it for what is to be shown.
        """
        if self._work is not None and self._work.done():
            prepared = self._work.result()
            self._work = None
            self._show(terrain, prepared)
        elif self._shown is not None:
            self._keep(terrain, self._shown)
        if pixels_per_unit is None or self._work is not None:
            return
        wanted = self._wanted(placement, east, north, pixels_per_unit)
        if self._shown is None or wanted != self._shown.wanted:
            if self._shown is None or wanted.room != self._shown.wanted.room:
                mesh_for_levels(wanted.room)  # now, not when there is more to do
            self._work = self._pool.submit(self._prepare, wanted)

    def tell_frame(self) -> None:
        """Tell that Blender has drawn: vertices are dropped while that takes long."""
        now = time.perf_counter()
        if self._last_frame is not None:
            self.steering.frame(now - self._last_frame)
        self._last_frame = now

    def wait(self) -> None:
        """Wait until what is being prepared is ready: for scripts and tests."""
        if self._work is not None:
            self._work.result()

    def put_away(self) -> None:
        """Show the terrain's own mesh again."""
        if self._shown is not None or self._work is not None:
            put_away_levels()
        self._shown = self._work = self.surface = None

    def end(self) -> None:
        """Give up what is being prepared."""
        self._pool.shutdown(wait=False, cancel_futures=True)

    @property
    def words(self) -> str | None:
        """What is shown, for a person; ``None`` while the terrain's own mesh is."""
        if self._shown is None:
            return None
        step = self._shown.wanted.plan.levels[0].step
        finest = "every sample" if step == 1 else f"1 of {step} samples"
        return f"{finest}, {self._shown.filling.used:,} triangles"

    def _wanted(self, placement: Placement, east: float, north: float, pixels_per_unit: float) -> _Wanted:
        layout, frame = self.grid.layout, placement.frame
        column, row = place_in_grid(layout, frame.on_map(east), north)
        scale = placement.matrix.to_scale()
        cell = max(layout.cell_width * abs(scale.x), layout.cell_height * abs(scale.y))
        pixels = cell * frame.units_per_metre * pixels_per_unit
        focus = Focus(column, row, FINEST_PIXELS / pixels)
        room = Room(self.steering.budget)
        before = None if self._shown is None else self._shown.wanted.plan
        return _Wanted(plan_levels(self._extent, focus, room.budget, before), frame, room)

    def _prepare(self, wanted: _Wanted) -> _Prepared:
        """In the thread."""
        if self._reader is None:
            self._reader = SampleReader(self.grid, self._raw())
        arrays = mesh_arrays(wanted.plan.levels, self._reader, wanted.frame, self.grid.layout)
        numbers = {ELEVATION: arrays.elevations, SLOPE: arrays.slopes}
        if arrays.filled is not None:
            numbers[FILLED] = arrays.filled
        return _Prepared(wanted, filling(arrays, numbers, wanted.room), arrays.surface)

    def _raw(self) -> Grid | None:
        """The grid with its voids, to tell what was filled."""
        if self.kept.filled:
            with suppress(FormatError):  # the colour of what was filled is not worth ending touch
                return self.kept.grid.open()
        return None

    def _keep(self, terrain: bpy.types.Object, prepared: _Prepared) -> None:
        """Show again what an undo or a person's hand took away."""
        levels = shown_levels(terrain)
        if levels is None or levels.get(MARK) != self._stamp:
            self._show(terrain, prepared)
        else:
            wear_materials(levels, terrain)

    def _show(self, terrain: bpy.types.Object, prepared: _Prepared) -> None:
        begun = time.perf_counter()
        room = prepared.wanted.room
        levels = shown_levels(terrain)
        if levels is not None and refresh(levels, prepared.filling, room):
            self.steering.refresh(time.perf_counter() - begun)
        else:
            levels = mesh_for_levels(room)
            show_levels(terrain, levels)
            refresh(levels, prepared.filling, room)
        wear_materials(levels, terrain)
        self._stamp += 1
        levels[MARK] = self._stamp
        self._shown, self.surface = prepared, prepared.surface
