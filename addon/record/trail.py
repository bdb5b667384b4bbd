"""The trail of a take: a tube over the terrain, coloured by the force that was felt."""

from __future__ import annotations

import math

import bpy
import numpy as np

from ..terrain.frame import map_size
from ..terrain.material import Ramp, ramp_material
from ..terrain.mesh import triangle_mesh
from ..terrain.palettes import Colour
from ..terrain.progress import Tell
from ..touch.live import Recording
from ..touch.placement import Placement
from .trail_path import Numbers, contact_trails
from .tube import Tube, tube

NAME = "Touch Trail"

FORCE = "force"
"""Vertex attribute, newtons."""

RADIUS = 0.0013
"""Of the tube, as a share of the terrain's longest side."""

COLOURS: tuple[tuple[float, Colour], ...] = (
    (0.0, (0.55, 0.95, 1.0)),
    (0.5, (0.02, 0.25, 1.0)),
    (1.0, (0.45, 0.0, 0.75)),
)
"""From a light to a strong touch: none of them is a colour of the terrain."""


def add_trail(
    scene: bpy.types.Scene, recording: Recording, placement: Placement, tell: Tell
) -> bpy.types.Object | None:
    """Make the trail's object; ``None`` where nothing was touched."""
    frame, grid, surface = placement.frame, recording.touch.grid, recording.touch.surface
    radius = RADIUS * max(map_size(grid.layout))

    def ground(east: Numbers, north: Numbers) -> Numbers:
        real = map(grid.elevation_at, east.tolist(), north.tolist())
        heights = np.fromiter((math.nan if height is None else height for height in real), float, len(east))
        return np.asarray(np.fmax(surface.heights_at(east, north), heights))

    trails = contact_trails(recording.recorder, frame, ground, spacing=radius)
    tell(0.4)
    if not trails:
        return None
    shape = tube(trails, frame, radius * frame.units_per_metre)
    tell(0.6)
    trail = bpy.data.objects.new(NAME, _mesh(shape))
    trail.matrix_world = placement.matrix
    scene.collection.objects.link(trail)
    return trail


def _mesh(shape: Tube) -> bpy.types.Mesh:
    mesh = triangle_mesh(NAME, shape.positions.astype(np.float32), shape.triangles)
    force = mesh.attributes.new(FORCE, "FLOAT", "POINT")
    force.data.foreach_set("value", shape.force.astype(np.float32))
    ramp = Ramp(FORCE, 0.0, float(shape.force.max()), COLOURS, glow=0.6)
    mesh.materials.append(ramp_material("Touch force", ramp))
    return mesh
