"""What a thing looks like on the screen: the pixels that differ when it is hidden."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass

import bpy
import numpy as np

from tests.gui.inside.blender import Blender
from tests.gui.inside.picture import Picture
from tests.gui.inside.script import Script, check

NEAR = 3.0
"""Blender units from the eye to what is looked at."""

RADIUS = 120
"""Pixels around the middle of the view that are compared."""

DIFFERS = 30
"""Of 255: more than a shadow makes."""


@dataclass(frozen=True)
class Silhouette:
    """Of one thing."""

    width: int
    height: int
    """Pixels, of the smallest box around it."""
    hue: float
    """Degrees on the colour circle, of the mean colour: 0 red, 120 green, 240 blue."""

    @property
    def slenderness(self) -> float:
        """Height over width."""
        return self.height / self.width


def silhouette(blender: Blender, thing: bpy.types.Object, name: str) -> Script[Silhouette]:
    """Bring a thing near, look at it and then without it; Blender's own helpers are hidden for so long.

    Raises:
        Failed: it cannot be seen.
    """
    view, overlay = blender.space.region_3d, blender.space.overlay
    view.view_location, view.view_distance = thing.matrix_world.translation, NEAR
    overlay.show_overlays = False
    with_it = yield from blender.picture(name)
    thing.hide_viewport = True
    without = yield from blender.picture(f"{name}-hidden")
    thing.hide_viewport = False
    overlay.show_overlays = True
    yield 0.2
    with_it, without = _middle(blender, with_it), _middle(blender, without)
    seen = with_it.differs_from(without, by=DIFFERS)
    check(seen.any(), f"{thing.name} cannot be seen ({name})")
    rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
    red, green, blue = with_it.pixels[seen].mean(axis=0) / 255.0
    return Silhouette(
        width=int(columns[-1] - columns[0] + 1),
        height=int(rows[-1] - rows[0] + 1),
        hue=360.0 * colorsys.rgb_to_hsv(float(red), float(green), float(blue))[0],
    )


def _middle(blender: Blender, picture: Picture) -> Picture:
    region = blender.region()
    return picture.around(region.x + region.width / 2, region.y + region.height / 2, radius=RADIUS)
