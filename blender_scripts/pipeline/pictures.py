"""Pictures of a take."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy
from mathutils import Vector

from pipeline.command import RefusedError
from pipeline.growing_trail import GrowingTrail
from pipeline.scene import Parts, refused
from pipeline.vertex_colours import show_ramps

PITCH = math.radians(45.0)
"""Of the view, below the horizon."""

AROUND = 1.4
"""Of the path's extent, that is seen."""


class Pictures:
    """Renders frames of a take.

    Args:
        parts: of the extension.
        name: of the take; empty is the only one.

    Raises:
        RefusedError: there is no such take, or its terrain is gone.
    """

    def __init__(self, parts: Parts, scene: bpy.types.Scene, name: str) -> None:
        kept = parts("record.kept_take")
        self._parts, self._scene = parts, scene
        self.take = _take(kept, scene, name)
        action = kept.take_action(self.take)
        with refused():
            self.data = kept.recall_take(action)
            self.terrain = parts("ui.goal_choices").terrain_under(bpy.context, self.data.about.terrain)
        self._first = kept.recall_start_frame(action)
        self._rate = scene.render.fps / scene.render.fps_base
        self._growing: GrowingTrail | None = None

    @property
    def frames(self) -> tuple[int, int]:
        """Of the take, the first and the last."""
        return self._first, self._first + int(self.data.seconds * self._rate + 1e-3)

    def set_up(
        self,
        *,
        engines: Sequence[str],
        resolution: Sequence[int],
        samples: int,
        camera: str | None,
        growing: bool,
    ) -> None:
        """Choose engine and camera, and dress the scene for it.

        Raises:
            RefusedError: there is no such camera or engine.
        """
        self._scene.frame_set(self._first)
        kept = self._parts("terrain.kept").recall(self.terrain)
        placement = self._parts("touch.placement").Placement.of(self.terrain, kept.frame)
        if growing:
            self._hide_trails()
            self._growing = GrowingTrail(self._parts, self.data, placement, self._ground(kept))
        self._choose_camera(camera, placement)
        render: Any = self._scene.render
        _choose_engine(render, engines)
        render.resolution_x, render.resolution_y = resolution
        render.resolution_percentage = 100
        render.image_settings.file_format = "PNG"
        render.image_settings.color_mode = "RGB"
        render.use_file_extension = True
        if render.engine == "CYCLES":
            self._scene.cycles.device = "CPU"
            self._scene.cycles.samples = samples
        if self._uses_workbench:
            shading = self._scene.display.shading
            shading.light, shading.color_type = "STUDIO", "VERTEX"
            shading.show_cavity, shading.cavity_type = True, "SCREEN"
            self._scene.display.render_aa = (
                "5"  # without a GPU, eight samples and shadows take ten times as long
            )
            self._scene.view_settings.view_transform = "Standard"
        elif not any(thing.type == "LIGHT" for thing in self._scene.objects):
            self._add_sun()

    def render(self, frame: int, file: Path) -> None:
        """Render a frame into a file; an older one is replaced only by a whole one.

        Raises:
            OSError: it cannot be written.
        """
        self._scene.frame_set(frame)
        if self._growing is not None:
            self._growing.show((frame - self._first) / self._rate)
        if self._uses_workbench:
            show_ramps(self._scene.objects)
        beginning = file.with_name(f".{file.stem}.part.png")
        self._scene.render.filepath = str(beginning.resolve())
        try:
            bpy.ops.render.render(write_still=True)
            if not beginning.is_file():
                raise OSError(f"{file} cannot be written.")
            beginning.replace(file)
        finally:
            beginning.unlink(missing_ok=True)

    @property
    def _uses_workbench(self) -> bool:
        engine: str = self._scene.render.engine
        return engine == "BLENDER_WORKBENCH"

    def _ground(self, kept: Any) -> Any:
        preview = self._parts("terrain.preview")
        grid = self._parts("terrain.opening").open_shown(self._parts("touch.live").live.opened, kept)
        cells = preview.preview_cells(grid.layout, kept.vertex_budget)
        return self._parts("record.ground").Ground(grid, preview.preview_surface(grid, cells))

    def _hide_trails(self) -> None:
        key = self._parts("record.write_take").TRAIL
        for thing in self._scene.objects:
            if thing.get(key) is not None:
                thing.hide_render = True

    def _choose_camera(self, name: str | None, placement: Any) -> None:
        if name is not None:
            camera = self._scene.objects.get(name)
            if camera is None or camera.type != "CAMERA":
                raise RefusedError(f"{self._scene.name} has no camera {name}.")
            self._scene.camera = camera
        elif self._scene.camera is None:
            self._scene.camera = self._overview(placement)

    def _overview(self, placement: Any) -> bpy.types.Object:
        """Look north, from above, on all of the path."""
        step = max(1, len(self.data) // 1000)
        places = [placement.to_scene(*place) for place in self.data.places[::step].tolist()]
        low = Vector([min(axis) for axis in zip(*places, strict=True)])
        high = Vector([max(axis) for axis in zip(*places, strict=True)])
        least = 0.05 * placement.longest_side(_layout(self._parts, self.terrain))
        across = AROUND * max((high - low).length, least)
        lens = bpy.data.cameras.new("Touch")
        camera = bpy.data.objects.new("Touch", lens)
        distance = across * lens.lens / lens.sensor_width
        away = Vector((0.0, -math.cos(PITCH), math.sin(PITCH)))
        camera.location = (low + high) / 2.0 + distance * away
        camera.rotation_euler = away.to_track_quat("Z", "Y").to_euler()
        lens.clip_start, lens.clip_end = 0.001 * distance, 100.0 * distance
        self._scene.collection.objects.link(camera)
        return camera

    def _add_sun(self) -> None:
        sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
        sun.data.energy = 4.0
        sun.rotation_euler = (math.radians(50.0), 0.0, math.radians(-40.0))
        self._scene.collection.objects.link(sun)


def _take(kept: Any, scene: bpy.types.Scene, name: str) -> bpy.types.Object:
    takes = [thing for thing in scene.objects if kept.is_take(thing)]
    if name:
        found = next((take for take in takes if take.name == name), None)
        if found is None:
            raise RefusedError(f"{scene.name} has no take {name}; it has {_names(takes)}.")
        return found
    if len(takes) != 1:
        raise RefusedError(f"Name the take with --take: {scene.name} has {_names(takes)}.")
    return takes[0]


def _names(takes: Sequence[bpy.types.Object]) -> str:
    return ", ".join(take.name for take in takes) or "none"


def _layout(parts: Parts, terrain: bpy.types.Object) -> Any:
    return parts("terrain.kept").recall(terrain).grid.layout


def _choose_engine(render: Any, engines: Sequence[str]) -> None:
    for engine in engines:
        try:
            render.engine = engine
        except TypeError:  # other Blenders call it otherwise
            continue
        return
    raise RefusedError(f"This Blender has no render engine {engines[0]}.")
