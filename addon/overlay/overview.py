"""The overview map: the whole grid, the window and the cursor on it."""

from __future__ import annotations

from dataclasses import dataclass, field

from gpu.types import Buffer, GPUBatch, GPUTexture
from proxygraph import GridLayout, Window

from ..touch.live import Readout, Touch
from ..touch.shown import Shown
from ..touch.windows import lies
from .colours import LINE, PLATE, SHADOW
from .design import MARGIN
from .overview_map import OverviewMap, overview_map
from .painting import Painting
from .pen import at, draw_lines, draw_picture, draw_plate, flat_lines_batch, placed
from .rect import Rect
from .symbols import PlacedSymbol, Symbols
from .view import View

CURSOR = 4.5
"""From the middle of the cursor's symbol to its sides, pixels at a scale of 1."""

FRAME = 1.5
"""Width of the window's outline, pixels at a scale of 1."""


@dataclass
class Overview:
    """What is made once, or again when the window moves."""

    painting: Painting
    _symbols: Symbols = field(default_factory=Symbols)
    _texture: GPUTexture | None = None
    _outlined: tuple[object, ...] = ()
    """What the outline was made of."""
    _outline: GPUBatch | None = None

    def draw(self, chart: OverviewMap, touch: Touch, readout: Readout, shown: Shown, view: View) -> None:
        """Draw it."""
        self._draw_picture(chart.rect, view.scale)
        outline = self._outline_of(chart, readout.window, touch.workspace, view.scale)
        if outline is not None:
            draw_lines(outline, SHADOW, (FRAME + 2.0) * view.scale)
            draw_lines(outline, LINE, FRAME * view.scale)
        if readout.on_map:
            x, y = chart.at(*readout.proxy[:2])
            with placed(at(x, y)):  # it moves with every picture, and need not be made again for that
                self._symbols.draw([PlacedSymbol(shown.shape, 0.0, 0.0, CURSOR * view.scale)], view.scale)

    def _draw_picture(self, rect: Rect, scale: float) -> None:
        """The picture with a thin dark edge; the edge alone until it is painted."""
        edge = scale
        draw_plate(rect.inset(-edge, -edge, -edge, -edge), SHADOW)
        texture = self._painted()
        if texture is None:
            draw_plate(rect, PLATE)
        else:
            draw_picture(texture, rect)

    def _painted(self) -> GPUTexture | None:
        picture = self.painting.finished() if self._texture is None else None
        if picture is not None:
            rows, columns, channels = picture.shape
            pixels = Buffer("FLOAT", rows * columns * channels, memoryview(picture.ravel()))
            self._texture = GPUTexture((columns, rows), format="RGBA8", data=pixels)
        return self._texture

    def _outline_of(
        self, chart: OverviewMap, window: Window, workspace: tuple[float, float, float], scale: float
    ) -> GPUBatch | None:
        outlined = chart, lies(window), scale
        if outlined != self._outlined:
            self._outlined = outlined
            segments = chart.outline(window, workspace, scale)
            self._outline = flat_lines_batch(segments) if segments else None
        return self._outline


def placed_map(view: View, layout: GridLayout) -> OverviewMap | None:
    """Where the map of a grid is in a view; ``None`` where the view has none."""
    if not view.has_text:
        return None
    margin = MARGIN * view.scale
    free = view.free.inset(margin, margin, max(margin, view.buttons.width), max(margin, view.axes))
    return overview_map(free, layout, view.scale)
