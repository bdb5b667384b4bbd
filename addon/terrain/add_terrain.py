"""The terrain object of a grid that was prepared."""

from __future__ import annotations

import bpy
import numpy as np

from .kept import keep
from .mesh import FILLED, preview_mesh
from .prepare import Prepared
from .ramps import heights_ramp, slopes_ramp
from .select import select_only
from .terrain_material import terrain_material


def add_terrain(context: bpy.types.Context, prepared: Prepared) -> bpy.types.Object:
    """Make the object and put it into the scene, selected."""
    kept, surface = prepared.kept, prepared.surface
    title = kept.grid.title
    mesh = preview_mesh(title, surface, kept.frame, prepared.slopes)
    mesh.materials.append(
        terrain_material(
            f"{title} heights",
            heights_ramp(kept.grid.georeference.body, surface.heights),
            slopes_ramp(prepared.slopes[np.isfinite(surface.heights)]),
            filled=FILLED in mesh.attributes,
        )
    )
    terrain = bpy.data.objects.new(title, mesh)
    keep(terrain, kept)
    context.collection.objects.link(terrain)
    select_only(context, terrain)
    return terrain
