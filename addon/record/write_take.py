"""What a take becomes in the scene: one way for live recordings, files, playback and baking."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from ..terrain.progress import Tell
from ..touch.placement import Placement
from .ground import Ground
from .take_data import TakeData
from .take_options import TakeOptions


@dataclass(frozen=True)
class Take:
    """What a take left in the scene."""

    take: bpy.types.Object
    trail: bpy.types.Object | None
    """The tube."""
    keyframes: int
    """On each of its location curves."""
    seconds: float
    dropped: int
    """Ticks that were lost because Blender was busy for longer than the ring lasts."""


def write_take(
    scene: bpy.types.Scene,
    data: TakeData,
    placement: Placement,
    ground: Ground,
    options: TakeOptions,
    tell: Tell = lambda _share: None,
) -> Take:
    """Make the take's object, its action and its trails; the caller takes care of undo.

    Args:
        placement: of the terrain that was touched.
        ground: of the same terrain; what is written never lies below it.

    Raises:
        ValueError: there is no tick.
    """
    raise NotImplementedError
