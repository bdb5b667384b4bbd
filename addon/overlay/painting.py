"""Painting the overview map in a thread: the first pictures of a touch do not wait for it."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import bpy
import numpy as np
import numpy.typing as npt

from ..terrain.palettes import Colour
from ..terrain.ramps import heights_ramp
from ..terrain.terrain_material import ColourBy, material_of, swatches
from ..touch.live import Touch
from .overview_picture import overview_picture

Picture = npt.NDArray[np.float32]


class Painting:
    """A picture in the making."""

    def __init__(self, touch: Touch) -> None:
        """Begin it, with the colours that the terrain has now."""
        colours = _colours(touch)
        exaggeration = touch.frame.exaggeration
        pool = ThreadPoolExecutor(1, thread_name_prefix="overview map")
        self._picture: Future[Picture] = pool.submit(overview_picture, touch.surface, colours, exaggeration)
        pool.shutdown(wait=False)

    def finished(self) -> Picture | None:
        """The picture, once it is there."""
        return self._picture.result() if self._picture.done() else None


def _colours(touch: Touch) -> Sequence[tuple[float, Colour]]:
    """Metres and colours from low to high: of the terrain's material, else those that it would have got."""
    terrain = touch.terrain.find()
    material = material_of(terrain) if terrain is not None else None
    found = swatches(material, ColourBy.ELEVATION) if material is not None else []
    if found:
        return [(swatch.value, _rgb(swatch.element)) for swatch in reversed(found)]
    ramp = heights_ramp(touch.georeference.body, touch.surface.heights)
    return [(ramp.low + share * (ramp.high - ramp.low), colour) for share, colour in ramp.colours]


def _rgb(element: bpy.types.ColorRampElement) -> Colour:
    colour: Any = element.color
    return colour[0], colour[1], colour[2]
