"""What of a terrain's place in the scene touch cannot follow: it goes on, and says so.

Location, rotation, scale and mirroring are followed, whatever they come from: a parent, a constraint, an
animation. The hand's metric is one of the terrain's metres, alike in all directions of the ground; a scene
can show a terrain in ways that no such metric has.
"""

from __future__ import annotations

import bpy

from .placement import Placement

TOLERANCE = 1e-3
"""Of a right angle, and of a length: less is neither seen nor felt, and Blender's 32 bits have some of it."""

HIDDEN = "The terrain is hidden: what is touched is not seen, nor followed where it is moved."

SHEARED = (
    "The terrain is sheared, which cannot be felt: the hand feels it upright. A parent that is scaled "
    "unevenly does that to what is turned under it: scale the parent evenly, or clear the parent."
)

UNEVEN = (
    "The terrain is stretched more one way along the ground than the other, which cannot be felt: the hand "
    "feels it as it is from west to east. Give the object's X and Y the same scale."
)


def shortcomings(terrain: bpy.types.Object, scene: bpy.types.Scene, placement: Placement) -> tuple[str, ...]:
    """Sentences, none where everything is followed."""
    found = []
    if not any(terrain.visible_get(view_layer=layer) for layer in scene.view_layers):
        found.append(HIDDEN)
    if placement.shear > TOLERANCE:
        found.append(SHEARED)
    elif abs(placement.unevenness) > TOLERANCE:
        found.append(UNEVEN)
    return tuple(found)
