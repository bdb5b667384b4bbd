"""The trail of a take: a tube over the terrain, coloured by the force that was felt."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np
from proxygraph import GridLayout

from ..terrain.frame import TerrainFrame, map_size
from ..terrain.material import Ramp, ramp_material
from ..terrain.mesh import triangle_mesh
from ..terrain.palettes import Colour
from .trail_path import Trail
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


def tube_trail(trails: Sequence[Trail], frame: TerrainFrame, layout: GridLayout) -> bpy.types.Object:
    """Make the tube, in the terrain's own coordinates."""
    radius = trail_radius(layout) * frame.units_per_metre
    return bpy.data.objects.new(NAME, _mesh(tube(trails, frame, radius)))


def trail_radius(layout: GridLayout) -> float:
    """Terrain metres: also how far apart a trail's points are."""
    return RADIUS * max(map_size(layout))


def _mesh(shape: Tube) -> bpy.types.Mesh:
    mesh = triangle_mesh(NAME, shape.positions.astype(np.float32), shape.triangles)
    force = mesh.attributes.new(FORCE, "FLOAT", "POINT")
    force.data.foreach_set("value", shape.force.astype(np.float32))
    ramp = Ramp(FORCE, 0.0, float(shape.force.max()), COLOURS, glow=0.6)
    mesh.materials.append(ramp_material("Touch force", ramp))
    return mesh
