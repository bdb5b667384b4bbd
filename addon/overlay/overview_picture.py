"""The picture of the overview map: heights in the terrain's own colours, in light from the north-west."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ..terrain.frame import map_size
from ..terrain.palettes import Colour
from ..terrain.preview import PreviewSurface
from .colours import on_screen

Numbers = npt.NDArray[np.float64]

LONGEST = 480
"""Pixels: the map's largest size on a screen of twice the usual density."""

VOID = (0.06, 0.06, 0.065)
"""Where there is no data, linear."""

LIGHT = (-0.5, 0.5, 0.7071067811865476)
"""Toward the sun: east, north, up; of length 1."""

AMBIENT = 0.35
"""Share of the light that comes from everywhere."""


def overview_picture(
    surface: PreviewSurface, colours: Sequence[tuple[float, Colour]], exaggeration: float
) -> npt.NDArray[np.float32]:
    """Paint it, in any thread: Blender is not touched.

    Args:
        colours: metres and the linear colours that they have, from low to high.
        exaggeration: of heights, in light and shadow.

    Returns:
        Rows x columns x 4, from the south-west, as a screen takes it (sRGB); opaque.
    """
    across, down = map_size(surface.layout)
    longest = max(across, down)
    columns = max(2, min(round(LONGEST * across / longest), len(surface.cells.columns)))
    rows = max(2, min(round(LONGEST * down / longest), len(surface.cells.rows)))
    heights = _averaged(surface, columns, rows)
    light = _light(heights * exaggeration, across / columns, down / rows)
    values = [value for value, _colour in colours]
    painted = np.stack(
        [np.interp(heights, values, [colour[channel] for _value, colour in colours]) for channel in range(3)],
        axis=-1,
    )
    painted = np.where(np.isfinite(heights)[..., None], painted * light[..., None], np.array(VOID))
    picture = np.ones((rows, columns, 4), dtype=np.float32)
    picture[..., :3] = on_screen(painted)[::-1]
    return picture


def _averaged(surface: PreviewSurface, columns: int, rows: int) -> Numbers:
    """Heights of the picture's pixels, north first: the mean of the shown samples in each."""
    known = np.isfinite(surface.heights)
    total = _summed(np.where(known, surface.heights, 0.0), surface, columns, rows)
    count = _summed(known.astype(float), surface, columns, rows)
    return np.divide(total, count, out=np.full_like(total, np.nan), where=count > 0.0)


def _summed(values: Numbers, surface: PreviewSurface, columns: int, rows: int) -> Numbers:
    down = np.add.reduceat(values, _first(surface.cells.rows, rows), axis=0)
    return np.asarray(np.add.reduceat(down, _first(surface.cells.columns, columns), axis=1))


def _first(lines: tuple[int, ...], pixels: int) -> npt.NDArray[np.intp]:
    """The shown line at which each pixel begins."""
    edges = np.linspace(lines[0], lines[-1], pixels + 1)[:-1]
    numbers = np.searchsorted(np.array(lines), edges, side="right") - 1
    return np.clip(numbers, 0, len(lines) - 1)


def _light(heights: Numbers, width: float, height: float) -> Numbers:
    """Shares of the full light, 1 on level ground.

    Args:
        heights: metres, north first. width, height: of a pixel, metres.
    """
    south, east = np.gradient(heights)
    eastward, northward = np.nan_to_num(east / width), np.nan_to_num(-south / height)
    toward = (LIGHT[2] - eastward * LIGHT[0] - northward * LIGHT[1]) / np.sqrt(
        1.0 + eastward**2 + northward**2
    )
    return np.asarray(AMBIENT + (1.0 - AMBIENT) * np.maximum(toward, 0.0) / LIGHT[2])
