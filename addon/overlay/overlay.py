"""All that is drawn over the 3D views of a touch."""

from __future__ import annotations

from dataclasses import dataclass, field

import bpy

from ..touch.live import Touch
from .keys import grab_key, mouse_grab_key
from .legend import draw_legend, legend_lines
from .overview import Overview, placed_map
from .painting import Painting
from .readout import ReadoutBlock
from .scene_marks import draw_scene_marks
from .symbols import Symbols
from .view import View
from .writing import Writing


@dataclass(frozen=True)
class Wanted:
    """What a person wants to see."""

    overview: bool = True
    readout: bool = True
    legend: bool = True
    force: bool = True
    ghost: bool = True

    @staticmethod
    def by(scene: bpy.types.Scene) -> Wanted:
        """As it is set in a scene."""
        settings = scene.haptic_terrain
        return Wanted(
            overview=settings.show_overview,
            readout=settings.show_readout,
            legend=settings.show_legend,
            force=settings.show_force,
            ghost=settings.show_ghost,
        )


@dataclass
class Overlay:
    """Of one touch."""

    touch: Touch
    overview: Overview
    block: ReadoutBlock = field(default_factory=ReadoutBlock)
    symbols: Symbols = field(default_factory=Symbols)
    """Of the legend."""
    writing: Writing = field(default_factory=Writing)
    keys: dict[bool, str] = field(default_factory=dict)
    """That grabs, in words, by whether the mouse is the hand."""

    @staticmethod
    def of(touch: Touch) -> Overlay:
        """Begin what takes time; nothing is drawn yet."""
        return Overlay(touch, Overview(Painting(touch)))

    def draw_flat(self, view: View, wanted: Wanted) -> None:
        """Draw what lies flat on a region."""
        readout, shown = self.touch.readout, self.touch.shown
        if readout is None or shown is None or not view.has_text:
            return
        taken = [view.buttons]
        chart = placed_map(view, self.touch.grid.layout) if wanted.overview else None
        if chart is not None:
            self.overview.draw(chart, self.touch, readout, shown, view)
            taken.append(chart.rect)
        if wanted.readout:
            plate = self.block.draw(self.touch, readout, shown, view, self.writing, taken)
            taken += [plate] if plate is not None else []
        if wanted.legend:
            lines = legend_lines(self._grab_key(), has_modes=self.touch.has_modes)
            draw_legend(lines, shown, view, self.symbols, self.writing, taken)

    def _grab_key(self) -> str:
        is_mouse = self.touch.mouse is not None
        if is_mouse not in self.keys:
            self.keys[is_mouse] = (mouse_grab_key if is_mouse else grab_key)(bpy.context)
        return self.keys[is_mouse]

    def draw_in_scene(self, view: View, wanted: Wanted) -> None:
        """Draw what has a place in the scene."""
        if self.touch.shown is not None:
            strongest = self.touch.session.max_force
            draw_scene_marks(self.touch.shown, view, strongest, force=wanted.force, ghost=wanted.ghost)
