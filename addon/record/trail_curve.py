"""The trail of a take as a curve: thick where the hand pressed hard."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np
from proxygraph import GridLayout

from ..terrain.frame import TerrainFrame
from .trail_path import Trail
from .trail_tube import trail_radius

NAME = "Touch Trail Curve"

THICKEST = 3.0
"""Times the tube's radius, where the force was largest."""

THINNEST = 0.1
"""Share of that where there was hardly a force: a line that is still seen."""


def curve_trail(trails: Sequence[Trail], frame: TerrainFrame, layout: GridLayout) -> bpy.types.Object:
    """Make the curve, in the terrain's own coordinates: a spline for each touch, its radius by the force."""
    line = bpy.data.curves.new(NAME, "CURVE")
    line.dimensions = "3D"
    line.bevel_depth = THICKEST * trail_radius(layout) * frame.units_per_metre
    line.bevel_resolution = 2
    strongest = max(float(trail.force.max()) for trail in trails) or 1.0
    for trail in trails:
        spline = line.splines.new("POLY")
        spline.points.add(len(trail.force) - 1)
        east, north, up = trail.places.T
        x, y, z = frame.to_object(east, north, up)
        spline.points.foreach_set("co", np.stack((x, y, z, np.ones_like(x)), axis=-1).ravel())
        spline.points.foreach_set("radius", np.maximum(trail.force / strongest, THINNEST))
    return bpy.data.objects.new(NAME, line)
