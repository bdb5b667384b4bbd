"""A trail that is there up to a moment: it grows while its take plays."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import bpy
import numpy as np

from pipeline.scene import Parts


class GrowingTrail:
    """The tube of a take, cut at a moment.

    Args:
        parts: of the extension.
        data: the take.
        placement, ground: of its terrain.
        thickness: of the tube, as a share of a take's own trail.
    """

    def __init__(
        self, parts: Parts, data: Any, placement: Any, ground: Any, *, thickness: float = 1.0
    ) -> None:
        path, tube = parts("record.trail_path"), parts("record.trail_tube")
        layout, frame = ground.grid.layout, placement.frame
        self._triangle_mesh = parts("terrain.mesh").triangle_mesh

        def trails(take: Any) -> Any:
            return path.contact_trails(take, frame, ground.highest, tube.trail_radius(layout))

        felt = trails(data)
        self.thing: Any = None
        """The tube; ``None`` where nothing was touched."""
        if not felt:
            return
        # The same points once more, which carry their time where force was.
        none = np.zeros(len(data))
        timed = {**data.columns, "force_x": data.columns["time"], "force_y": none, "force_z": none}
        times = [trail.force for trail in trails(replace(data, columns=timed))]
        sides = parts("record.tube").SIDES
        self.thing = tube.tube_trail(felt, frame, layout)
        self.thing.matrix_world = placement.matrix
        bpy.context.scene.collection.objects.link(self.thing)
        self._whole = self.thing.data
        self._triangles = _read(self._whole, ".corner_vert", "value", np.int32).reshape(-1, 3)
        self._ends = np.repeat(np.concatenate(times), sides)[self._triangles].max(axis=1)
        rings = _read(self._whole, "position", "vector", np.float32).reshape(-1, sides, 3)
        middles = rings.mean(axis=1, keepdims=True)
        self._positions = (middles + thickness * (rings - middles)).reshape(-1, 3)

    def show(self, seconds: float) -> None:
        """Cut it at a moment of the take."""
        if self.thing is None:
            return
        whole: Any = self._whole
        old: Any = self.thing.data
        mesh = self._triangle_mesh(whole.name, self._positions, self._triangles[self._ends <= seconds])
        force = mesh.attributes.new("force", "FLOAT", "POINT")
        force.data.foreach_set("value", _read(whole, "force", "value", np.float32))
        mesh.materials.append(whole.materials[0])
        self.thing.data = mesh
        if old is not whole:
            bpy.data.meshes.remove(old)


def _read(mesh: Any, name: str, field: str, kind: Any) -> Any:
    data = mesh.attributes[name].data
    values = np.empty(len(data) * (3 if field == "vector" else 1), kind)
    data.foreach_get(field, values)
    return values
